#include <wheelrail/base/left_out.h>
#include <wheelrail/model/sliced_rails.h>
#include <wheelrail/sections/sections_command.h>

#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    [[noreturn]] void
    refuse_rail(const ProfileSettings &scene)
    {
      refuse_left_out("Profiles/Rail = " + scene.rail_profile, Subject::sections);
    }
  } // namespace


  std::vector<std::string>
  files_of_slices(const std::string &)
  {
    return {};
  }


  void
  read_sliced_rail(const Scene &scene, SceneProfiles &)
  {
    refuse_rail(scene);
  }


  bool
  is_crossing(const ProfileSettings &scene)
  {
    refuse_rail(scene);
  }


  Irregularities
  rise_of_slices(const Scene &scene, const TouchingProfiles &, double, std::vector<std::string> &)
  {
    refuse_rail(scene);
  }


  Irregularity
  irregularity_of_slices(const ProfileSettings &,
                         const IrregularityData &data,
                         const TouchingProfiles &,
                         double,
                         double,
                         std::vector<std::string> &)
  {
    refuse_left_out(data.file, Subject::sections);
  }


  int
  print_touching_places(const Scene &, const std::string &, std::ostream &)
  {
    refuse_left_out("--places", Subject::sections);
  }


  int
  run_sections_command(const Scene &, const std::string &, bool, std::ostream &)
  {
    refuse_left_out("--places", Subject::sections);
  }
} // namespace wheelrail
