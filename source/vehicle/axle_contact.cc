#include <wheelrail/base/parallel.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/kept_tables.h>
#include <wheelrail/vehicle/axle_contact.h>
#include <wheelrail/wheel/load_search.h>
#include <wheelrail/wheel/several_patches.h>
#include <wheelrail/wheel/wheel_contacts.h>

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


  namespace
  {
    double
    creepage_at(const double rate, const WheelOnAxle &wheel)
    {
      return rate * wheel.geometry.contact.forward_radius - 1;
    }

    class HalfspaceWheel : public AxleWheel
    {
    public:
      HalfspaceWheel(const WheelOnAxle &wheel, const double rate)
        : wheel_(wheel)
        , search_(wheel.load)
      {
        const SectionOffsets offsets = scene_offsets(wheel.scene);
        const ContactRegion  whole   = whole_region(wheel.geometry.contact);
        PlaneContact         one(wheel.scene, wheel.geometry, offsets, whole);
        one.press(wheel.load / std::cos(whole.frame.angle));
        // friction changes the force, and with it what touches, on a steep flange alone
        const auto &further = wheel.geometry.contact.further;
        if (std::any_of(further.begin(), further.end(), [&](const FurtherPoint &point) {
              return std::abs(point.frame.angle - whole.frame.angle) >= same_plane;
            }))
          one.carry(rolling_load(wheel, rate));
        contacts_ = std::make_unique<WheelContacts>(
          wheel.scene, wheel.geometry, offsets, separate_regions(wheel.geometry, offsets, one), one);
      }

      double
      roll(const double rate) override
      {
        if (pressed_ != search_.pressed())
          contacts_->press(search_.pressed(), true);
        pressed_ = search_.pressed();
        contacts_->roll(creepage_at(rate, wheel_));
        return contacts_->torque();
      }

      bool
      carried() override
      {
        return search_.carried(contacts_->vertical());
      }

      double
      missed() const override
      {
        return std::abs(search_.missed());
      }

      WheelRailSolution
      result(const bool within_friction, const std::string &not_found) const override
      {
        return contacts_->result(within_friction, not_found);
      }

    private:
      const WheelOnAxle             &wheel_;
      LoadSearch                     search_;
      double                         pressed_ = 0; ///< [N]
      std::unique_ptr<WheelContacts> contacts_;
    };

    /// The load is carried in every solution of the bodies.
    class BodyWheel : public AxleWheel
    {
    public:
      explicit BodyWheel(const WheelOnAxle &wheel)
        : wheel_(wheel)
        , scene_(with_load(wheel))
        , tables_(make_body_tables(scene_, wheel.geometry, kept_tables_folder()))
        , contact_(scene_, wheel.geometry, tables_)
      {
      }

      double
      roll(const double rate) override
      {
        contact_.carry(rolling_load(wheel_, rate));
        return contact_.torque();
      }

      bool
      carried() override
      {
        return true;
      }

      double
      missed() const override
      {
        return 0;
      }

      WheelRailSolution
      result(const bool within_friction, const std::string &not_found) const override
      {
        WheelRailSolution result        = contact_.result();
        result.solution.within_friction = within_friction;
        if (!not_found.empty())
          {
            result.solution.coupling_converged = false;
            result.solution.not_reached += not_found;
          }
        return result;
      }

    private:
      static Scene
      with_load(const WheelOnAxle &wheel)
      {
        Scene scene      = wheel.scene;
        scene.wheel_load = wheel.load;
        return scene;
      }

      const WheelOnAxle &wheel_;
      Scene              scene_;
      BodyTables         tables_;
      BodyContact        contact_;
    };
  } // namespace


  WheelRailLoad
  rolling_load(const WheelOnAxle &wheel, const double rate)
  {
    WheelRailLoad load;
    load.force     = wheel.load;
    load.vertical  = true;
    load.rate_held = true;
    load.creepage  = creepage_at(rate, wheel);
    return load;
  }


  std::unique_ptr<AxleWheel>
  make_axle_wheel(const WheelOnAxle &wheel, const double rate)
  {
    if (wheel.scene.halfspace_bodies == ContactBodies::real)
      return std::make_unique<BodyWheel>(wheel);
    return std::make_unique<HalfspaceWheel>(wheel, rate);
  }
} // namespace wheelrail
