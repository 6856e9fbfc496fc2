#include <wheelrail/base/parallel.h>
#include <wheelrail/vehicle/axle_contact.h>
#include <wheelrail/wheel/load_search.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// What came of a round of the search.
    struct Round
    {
      double torque  = 0;    ///< of all wheels [N m]
      double missed  = 0;    ///< of a load, the largest share
      bool   carried = true; ///< whether each wheel carries its load
    };

    /// Rolls all wheels with a pitch rate [1/m].
    Round
    roll_all(const std::vector<std::unique_ptr<AxleWheel>> &wheels,
             const double                                   rate,
             const unsigned int                             threads)
    {
      std::vector<double> torques(wheels.size());
      parallel_for(
        wheels.size(), [&](const std::size_t k) { torques[k] = wheels[k]->roll(rate); }, threads);
      Round round;
      for (std::size_t k = 0; k < wheels.size(); ++k)
        {
          round.torque += torques[k];
          round.carried = wheels[k]->carried() && round.carried;
          round.missed  = std::max(round.missed, wheels[k]->missed());
        }
      return round;
    }

    /// Adds what a wheel does to the wheelset; `side` is -1 for the left one, which is seen in a mirror.
    void
    add_wheel(const WheelRailSolution &wheel, const double side, AxleSolution &axle)
    {
      const auto add_patch = [&](const WheelRailSolution &patch) {
        axle.lateral += side * patch.lateral;
        axle.yaw_moment += side * patch.reference->yaw_moment;
        axle.torque += patch.reference->torque;
      };
      add_patch(wheel);
      for (const WheelRailSolution &other : wheel.others)
        add_patch(other);
    }
  } // namespace


  void
  sum_up(AxleSolution &axle)
  {
    axle.torque = axle.lateral = axle.yaw_moment = 0;
    if (axle.right)
      add_wheel(*axle.right, 1, axle);
    if (axle.left)
      add_wheel(*axle.left, -1, axle);
  }


  AxleSolution
  solve_axle(const WheelOnAxle &right,
             const WheelOnAxle &left,
             const AxleDrive   &drive,
             const unsigned int threads)
  {
    constexpr int    most_rounds  = 20;
    constexpr double enough       = 1e-4; // of the torque that the loads have about the axle
    constexpr double ten_promille = 1e-2; // of the load, after the last round
    constexpr double settled      = 0.05; // of the load, from where on the creepage is sought
    const auto       begin        = std::chrono::steady_clock::now();
    // the rate at which the wheels roll freely in the mean, weighted with their loads
    const double loads       = right.load + left.load,
                 mean_radius = loads > 0 ? (right.load * right.geometry.contact.forward_radius +
                                            left.load * left.geometry.contact.forward_radius) /
                                             loads
                                         : right.geometry.contact.forward_radius;
    AxleSolution axle;
    axle.rate =
      drive.rate_held ? (1 + drive.creepage) / right.geometry.contact.forward_radius : 1 / mean_radius;
    std::vector<const WheelOnAxle *> loaded;
    for (const WheelOnAxle *wheel : {&right, &left})
      if (wheel->load > 0)
        loaded.push_back(wheel);
    std::vector<std::unique_ptr<AxleWheel>> wheels(loaded.size());
    parallel_for(
      wheels.size(),
      [&](const std::size_t k) { wheels[k] = make_axle_wheel(*loaded[k], axle.rate); },
      threads);
    // loads and creepage are found together: what one changes of the other fades from round to round
    CreepageSearch search(axle.rate * mean_radius - 1);
    bool           found = wheels.empty(), nearly = found;
    for (int round = 0; round < most_rounds && !found; ++round)
      {
        axle.rate       = (1 + search.creepage()) / mean_radius;
        const Round now = roll_all(wheels, axle.rate, threads);
        found           = now.carried;
        double miss     = (now.torque - drive.torque) / (loads * mean_radius);
        if (drive.rate_held || !search.carried())
          miss = 0;
        nearly = now.missed < ten_promille && std::abs(miss) < 10 * enough;
        if (std::abs(miss) > enough)
          {
            found = false;
            if (now.missed < settled) // else the sign may be that of another load
              search.missed(miss);
          }
      }
    found = found || nearly;
    for (std::size_t k = 0; k < wheels.size(); ++k)
      {
        auto &result = loaded[k] == &right ? axle.right : axle.left;
        result       = wheels[k]->result(
          search.carried(), found ? "" : "The turning rate and the loads of the axle were not found. ");
        name_made_up(loaded[k]->geometry, *result);
        result->time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      }
    sum_up(axle);
    return axle;
  }
} // namespace wheelrail
