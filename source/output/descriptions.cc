#include <wheelrail/output/descriptions.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/hdf5_handles.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    const std::vector<std::pair<const char *, const char *>> descriptions = {
      {"along", "position along Z relative to the axle, positive ahead"},
      {"lateral", "coordinate s across the rail in the contact plane, positive to the track centre"},
      {"gap", "signed gap of wheel and rail, negative where the penalty contact sinks in"},
      {"pressure", "normal pressure, positive in compression"},
      {"shear_along", "shear traction on the rail along Z"},
      {"shear_lateral", "shear traction on the rail along s"},
      {"slip_along", "slip velocity of the wheel against the rail along Z, over the speed"},
      {"slip_lateral", "slip velocity of the wheel against the rail along s, over the speed"},
      {"state", "0 open, 1 stick, 2 slip"},
      {"area", "tributary area of the node in the contact plane"},
      {"position",
       "along Z from the axle, positive ahead, or s: as the attribute position_is of the group says"},
      {"depth", "below the surface along the contact normal, into the body"},
      {"von_mises_stress", "von Mises' equivalent of the stress"},
      {"residual_von_mises_stress", "von Mises' equivalent of the stress behind the wheel"},
      {"stress_xx", "Cauchy stress along X, tension positive"},
      {"stress_yy", "Cauchy stress along Y, tension positive"},
      {"stress_zz", "Cauchy stress along Z, tension positive"},
      {"stress_yz", "Cauchy shear stress yz"},
      {"stress_xz", "Cauchy shear stress xz"},
      {"stress_xy", "Cauchy shear stress xy"},
      {"forward_shear",
       "displacement along Z per distance outwards, the loads taken off: plastic shear that goes forward at "
       "the "
       "surface"},
      {"plastic_strain", "accumulated plastic strain of the cell"},
      {"time", "time since the static start"},
      {"tangential_lateral_force",
       "lateral force on the wheel in the contact plane, positive to the track centre"},
      {"axle_lateral_force", "force that holds the axle laterally, positive to the track centre"},
      {"axle_vertical_force", "force that the axle gives to the wheel, positive up"},
      {"pitch_rate", "angular velocity of the wheel, positive when it rolls forward"},
      {"drive_torque", "torque on the axle, positive when driving"},
      {"axle_height", "height of the axle against the unloaded position, positive up"},
      {"axle_acceleration", "vertical acceleration of the axle box, positive up"},
      {"rail_velocity", "vertical velocity of the running surface of the rail around the wheel, positive up"},
      {"rail_irregularity", "height of the rail's irregularities under the wheel, along the normal"},
      {"wheel_irregularity", "height of the wheel's irregularities on the rail, along the normal"},
      {"first_rail_force", "vertical force on the wheel of Profiles/Rail"},
      {"second_rail_force", "vertical force on the wheel of Profiles/Second rail"},
      {"velocity", "of the wheelset along the track"},
      {"energy_residual", "what the balance of all energies and works misses"}};

    bool
    ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
    }
  } // namespace


  std::string
  description_of(const std::string &name)
  {
    for (const auto &[known, description] : descriptions)
      if (name == known)
        return description;
    for (const Figure &figure : all_figures())
      if (name == figure.name)
        return std::string(figure.label) + (*figure.remark ? std::string(", ") + figure.remark : "");
    std::string plain = name;
    std::replace(plain.begin(), plain.end(), '_', ' ');
    const bool energy =
      ends_with(name, "_energy") || ends_with(name, "_work") || ends_with(name, "_dissipation");
    return energy ? plain + ", a term of the energy balance, since the start" : plain;
  }


  void
  describe_root(const std::int64_t file)
  {
    using hdf5::write_attribute;
    write_attribute(file, "program", std::string("wheelrail ") + WHEELRAIL_VERSION);
    write_attribute(file, "format", 2u);
    write_attribute(
      file,
      "axes",
      std::string("X to the track centre, Y up, Z in the rolling direction; s across the rail in "
                  "the contact plane, growing to the track centre (side of the gauge corner)"));
    write_attribute(file,
                    "signs",
                    std::string("forces act on the wheel, tractions on the rail; pressure is positive in "
                                "compression, stress in tension; creepage is positive when driving"));
  }
} // namespace wheelrail
