#include <wheelrail/wheelset/guided_path.h>

#include <cmath>

namespace wheelrail
{
  namespace
  {
    const Vector3 up = {0, 1, 0}, along = {0, 0, 1};
  } // namespace


  RigidMotion
  GuidedPath::lead(const double rolled) const
  {
    const double   roll0 = roll.at(0), yaw0 = yaw.at(0), roll1 = roll.at(rolled), yaw1 = yaw.at(rolled);
    const Rotation roll_now(along, roll1), yaw_now(up, yaw1), roll_back(along, -roll0), yaw_back(up, -yaw0);
    RigidMotion    motion;
    for (int k = 0; k < 3; ++k)
      {
        Vector3 unit{};
        unit[k]             = 1;
        const Vector3 image = yaw_now(roll_now(roll_back(yaw_back(unit))));
        for (int i = 0; i < 3; ++i)
          motion.rows[i][k] = image[i];
      }
    // the wheel's centre lies at (-half_width, 0, 0) from the middle of the axle, before roll and yaw
    motion.move = {lateral_shift.at(rolled) - lateral_shift.at(0) -
                     half_width * (std::cos(roll1) * std::cos(yaw1) - std::cos(roll0) * std::cos(yaw0)),
                   0,
                   half_width * (std::cos(roll1) * std::sin(yaw1) - std::cos(roll0) * std::sin(yaw0))};
    return motion;
  }


  GuidedPath::Rate
  GuidedPath::rate(const double rolled) const
  {
    const double c = std::cos(yaw.at(rolled)), s = std::sin(yaw.at(rolled));
    const double cosine    = half_width * std::cos(roll.at(rolled)),
                 sine      = half_width * std::sin(roll.at(rolled));
    const double roll_rate = roll.slope(rolled), yaw_rate = yaw.slope(rolled);
    return {{lateral_shift.slope(rolled) + sine * c * roll_rate + cosine * s * yaw_rate,
             0,
             cosine * c * yaw_rate - sine * s * roll_rate},
            {s * roll_rate, yaw_rate, c * roll_rate}};
  }
} // namespace wheelrail
