#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/kept_tables.h>
#include <wheelrail/vehicle/axle_wheel.h>
#include <wheelrail/wheel/load_search.h>
#include <wheelrail/wheel/several_patches.h>
#include <wheelrail/wheel/wheel_contacts.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
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
