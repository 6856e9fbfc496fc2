#include <wheelrail/input/motion_columns.h>

namespace wheelrail
{
  namespace
  {
    using Q = MotionQuantity;
  } // namespace


  const MotionColumns &
  motion_columns()
  {
    static const MotionColumns list = {
      {Q::time, {"time", Dimension::time, -1e9, 1e9, "", false, true}},
      {Q::distance, {"distance", Dimension::length, -1e9, 1e9, "", false, true}},
      {Q::lateral_shift, {"lateral shift", Dimension::length, -0.012, 0.012, "-12 mm to 12 mm"}},
      {Q::roll, {"roll", Dimension::angle, -0.05, 0.05, "-50 mrad to 50 mrad"}},
      {Q::yaw, {"yaw", Dimension::angle, -0.05, 0.05, "-50 mrad to 50 mrad"}},
      {Q::load, {"load", Dimension::force, 0, 5e5, "0 kN (no contact) to 500 kN"}},
      {Q::load_right, {"load right", Dimension::force, 0, 5e5, "0 kN (no contact) to 500 kN"}},
      {Q::load_left, {"load left", Dimension::force, 0, 5e5, "0 kN (no contact) to 500 kN"}},
      {Q::velocity, {"velocity", Dimension::velocity, 5 / 3.6, 500 / 3.6, "5 km/h to 500 km/h"}},
      {Q::torque, {"torque", Dimension::moment, -1e6, 1e6, "-1000 kN m to 1000 kN m"}},
      {Q::traction, {"traction", Dimension::none, -1, 1, "-1 to 1"}},
      {Q::creepage, {"creepage", Dimension::none, -0.1, 0.1, "-10 % to 10 %"}},
      {Q::lateral_creepage, {"lateral creepage", Dimension::none, -0.1, 0.1, "-10 % to 10 %"}},
      {Q::radius,
       {"radius",
        Dimension::length,
        -1e5,
        1e5,
        "20 m to 100 km on either side, or 0",
        false,
        false,
        least_track_radius}},
      {Q::curvature,
       {"curvature",
        Dimension::spin,
        -0.05,
        0.05,
        "-0.05 1/m to 0.05 1/m (a radius of 20 m on either side)"}},
      {Q::cant, {"cant", Dimension::length, -0.3, 0.3, "-300 mm to 300 mm"}}};
    return list;
  }


  const MotionColumns &
  mix_columns()
  {
    static const MotionColumns list = [] {
      MotionColumns columns;
      for (const MotionColumn &column : motion_columns())
        if (column.quantity != Q::torque) // which the load of a row would turn into a traction
          columns.push_back(column);
      columns.push_back({Q::weight, {"weight", Dimension::none, 0, 1e12, "0 to 1e12"}});
      return columns;
    }();
    return list;
  }


  const MotionColumns &
  passage_columns()
  {
    static const MotionColumns list = {
      {Q::load, {"load", Dimension::force, 1e3, 5e5, "1 kN to 500 kN"}},
      {Q::lateral_shift, {"lateral shift", Dimension::length, -0.012, 0.012, "-12 mm to 12 mm"}},
      {Q::traction, {"traction", Dimension::none, -1, 1, "-1 to 1"}},
      {Q::velocity, {"velocity", Dimension::velocity, 5 / 3.6, 500 / 3.6, "5 km/h to 500 km/h"}},
      {Q::creepage, {"creepage", Dimension::none, -0.1, 0.1, "-10 % to 10 %"}}};
    return list;
  }


  const MotionColumns &
  curve_columns()
  {
    static const MotionColumns list = {
      {Q::creepage, {"creepage", Dimension::none, -1, 1, "-100 % to 100 %"}},
      {Q::spin, {"spin", Dimension::spin, -100, 100, "-100 1/m to 100 1/m"}},
      {Q::longitudinal_force, {"longitudinal force", Dimension::force, -1e6, 1e6, "-1000 kN to 1000 kN"}},
      {Q::lateral_force, {"lateral force", Dimension::force, -1e6, 1e6, "-1000 kN to 1000 kN"}},
      {Q::spin_moment, {"spin moment", Dimension::moment, -1e6, 1e6, "-1000 kN m to 1000 kN m"}},
      {Q::traction, {"traction", Dimension::none, -2, 2, "-2 to 2"}}};
    return list;
  }


  const MotionColumns &
  receptance_columns()
  {
    static const MotionColumns list = {
      {Q::frequency, {"frequency", Dimension::frequency, 1e-3, 1e5, "0.001 Hz to 100 kHz"}},
      {Q::receptance, {"receptance", Dimension::receptance, 0, 1, "0 to 1 m/N"}},
      {Q::mobility, {"mobility", Dimension::mobility, 0, 1, "0 to 1 m/(N s)"}},
      {Q::accelerance, {"accelerance", Dimension::accelerance, 0, 1e3, "0 to 1000 m/(s2 N)"}},
      {Q::phase, {"phase", Dimension::angle, -1e3, 1e3, "-1000 rad to 1000 rad"}}};
    return list;
  }

} // namespace wheelrail
