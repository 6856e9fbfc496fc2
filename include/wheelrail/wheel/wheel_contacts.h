#pragma once

#include <wheelrail/wheel/plane_contact.h>

#include <functional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// The sentence where several patches are not brought into balance.
  extern const std::string patches_not_found;

  /// The contacts of one wheel with its rail, each in its own plane, that share the wheel's position, its
  /// turning rate and its load. The wheel is lowered as a whole, so that the approach of a region is the
  /// lowering times the cosine of its inclination less the least distance there; the half-spaces are pressed
  /// down by the forces of the other patches as by point loads at their centres (Boussinesq 1885), whose
  /// component along the normal counts.
  class WheelContacts
  {
  public:
    /// `one`: the contact as solved in the plane of the first point alone, for a first guess. The geometry
    /// must outlive it.
    WheelContacts(const Scene                      &scene,
                  const SceneGeometry              &geometry,
                  const SectionOffsets             &offsets,
                  const std::vector<ContactRegion> &regions,
                  const PlaneContact               &one);
    WheelContacts(const WheelContacts &) = delete;
    WheelContacts &
    operator=(const WheelContacts &) = delete;

    /// Presses all patches together with a force [N]: the sum of their normal forces, or of the vertical
    /// components of these.
    void
    press(double force, bool vertical);

    /// Rolls all patches with a creepage, pressed as before.
    void
    roll(double creepage);

    /// Sums of the forces on the wheel: along X, upwards, and along the track, or along the wheelset turned
    /// by `direction` [rad] against it [N].
    double
    lateral() const;
    double
    vertical() const;
    double
    driving(double direction) const;

    /// Of the contacts on the wheelset about its axle, which something has to balance: positive where it
    /// drives [N m].
    double
    torque() const;

    /// The patch of the first contact point, with the others in `others`; each has its own forces.
    /// `carried`: whether friction carries what drives; `not_found`: a sentence on a balance that was not
    /// found, or nothing.
    WheelRailSolution
    result(bool carried, const std::string &not_found) const;

  private:
    /// What the point loads add to the distance of patch k [m].
    double
    pressed_down(std::size_t k, double x, double s) const;

    /// Lowers the wheel [m]; what the normal forces carry vertically, or of a load that is normal to the
    /// planes their sum [N].
    double
    lower(double lowering, bool vertical);

    double
    sum(const std::function<double(const PlaneContact &)> &of) const;

    /// A patch as the others feel it.
    struct PointLoad
    {
      double force = 0; ///< normal [N]
      Point2 place;     ///< in the track plane [m]
    };

    std::vector<PlaneContact> contacts_;
    std::vector<PointLoad>    points_;            ///< from the round before
    double                    compliance_ = 0;    ///< displacement times distance over force [m2/N]
    double                    lowering_   = 0;    ///< of the wheel [m]
    bool                      pressed_    = true; ///< whether the last press() has found its force
  };
} // namespace wheelrail
