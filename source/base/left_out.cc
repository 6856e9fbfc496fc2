#include <wheelrail/base/errors.h>
#include <wheelrail/base/hints.h>
#include <wheelrail/base/left_out.h>

#include <array>

namespace wheelrail
{
  namespace
  {
    struct Built
    {
      const char *words, *option;
      bool        there;
    };

    const Built &
    built(const Subject subject)
    {
      static constexpr std::array<Built, 5> all = {
        {{"track", "TRACK", WHEELRAIL_TRACK},
         {"vehicle", "VEHICLE", WHEELRAIL_VEHICLE},
         {"wear", "WEAR", WHEELRAIL_WEAR},
         {"files of CONTACT", "CONTACT_FILES", WHEELRAIL_CONTACT_FILES},
         {"rails by slices", "SECTIONS", WHEELRAIL_SECTIONS}}};
      return all[static_cast<std::size_t>(subject)];
    }
  } // namespace


  bool
  is_built(const Subject subject)
  {
    return built(subject).there;
  }


  std::string
  left_out(const std::string &what, const Subject subject)
  {
    return what + ": this program is built without " + built(subject).words +
           "; WHEELRAIL_CMAKE_OPTIONS=-DWHEELRAIL_" + built(subject).option + "=ON " + own_call() +
           " build makes one with it";
  }


  void
  refuse_left_out(const std::string &what, const Subject subject)
  {
    throw InputError(left_out(what, subject));
  }
} // namespace wheelrail
