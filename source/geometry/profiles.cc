#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/profiles.h>
#include <wheelrail/geometry/standard_rails.h>
#include <wheelrail/geometry/standard_wheels.h>

#include <map>

namespace wheelrail
{
  namespace
  {
    const std::map<std::string, RailProfile (*)()>  rails  = {{"54E1", &rail_54E1}, {"60E1", &rail_60E1}};
    const std::map<std::string, WheelProfile (*)()> wheels = {{"S1002", &wheel_S1002},
                                                              {"cone 1:20", []() { return wheel_cone(20); }},
                                                              {"cone 1:40", []() { return wheel_cone(40); }}};

    template <typename Map>
    std::vector<std::string>
    names_of(const Map &map)
    {
      std::vector<std::string> names;
      for (const auto &entry : map)
        names.push_back(entry.first);
      return names;
    }

    template <typename Map>
    auto
    make(const Map &map, const std::string &kind, const std::string &name)
    {
      const auto found = map.find(name);
      if (found != map.end())
        return found->second();
      std::string known;
      for (const auto &entry : map)
        known += (known.empty() ? "" : ", ") + entry.first;
      throw InputError("There is no standard " + kind + " profile named '" + name + "'. Known are: " + known +
                       ".");
    }

  } // namespace


  std::vector<std::string>
  standard_rails()
  {
    return names_of(rails);
  }


  std::vector<std::string>
  standard_wheels()
  {
    return names_of(wheels);
  }


  RailProfile
  rail_profile(const std::string &name)
  {
    return make(rails, "rail", name);
  }


  WheelProfile
  wheel_profile(const std::string &name)
  {
    return make(wheels, "wheel", name);
  }
} // namespace wheelrail
