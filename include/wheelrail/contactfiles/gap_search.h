#pragma once

#include <wheelrail/contactfiles/contact_case.h>
#include <wheelrail/contactfiles/section_line.h>
#include <wheelrail/contactfiles/weakened_rows.h>
#include <wheelrail/contactfiles/wheel_rail_pose.h>

#include <functional>
#include <optional>
#include <vector>

namespace wheelrail
{
  /// Where the wheel comes nearest to the rail at one y of the track: the vertical gap between the rail and
  /// the contact locus of the wheel, its points whose normals lie across the track (Wang 1984), over a roller
  /// those that incline along the track as it does, at the height 0 of the wheelset.
  struct GapPlace
  {
    double y = 0, gap = 0;
    double x      = 0; ///< of the wheel's point, along the track
    double rail_z = 0; ///< of the rail
    double angle  = 0; ///< of the rail's surface against y
    double line   = 0; ///< parameter on the rail's section
  };

  /// Those places from the track centre to the field side, at most so far apart; none where rail and
  /// wheel do not lie over each other.
  std::vector<GapPlace>
  gap_places(const WheelRailPose &pose, const ProfileLine &rail, const ProfileLine &wheel, double most);

  /// A contact patch as the overlap of the undeformed surfaces places it, in the axes of the track.
  struct PatchPlace
  {
    Vector3 reference{};                ///< on the rail: mean of the overlap, its square as weight
    double  angle = 0;                  ///< of the plane of contact against y
    double  line = 0, arc = 0;          ///< parameter and length of the reference on the rail's section
    double  x_low = 0, x_high = 0;      ///< of the overlap, in the track
    double  s_low = 0, s_high = 0;      ///< its ends on the rail's section, as lengths from the reference
    double  y_low = 0, y_high = 0;      ///< in the track
    double  z_low = 0, z_high = 0;      ///< of the rail there
    double  weight = 0;                 ///< of the overlap
    std::vector<RowDivision> divisions; ///< between overlaps that are joined in part, at y of the track
  };

  /// The patches of a wheelset at a height, from the field side to the track centre: overlaps are joined,
  /// separated and turned by the distances and the angle of the case.
  std::vector<PatchPlace>
  patch_places(const std::vector<GapPlace> &gaps,
               const WheelRailPose         &pose,
               const ProfileLine           &rail,
               const ContactElements       &elements);

  /// Overlaps from the field side to the track centre, joined, separated and turned as the case says.
  std::vector<PatchPlace>
  joined_patches(std::vector<PatchPlace> patches, const ContactElements &elements);

  /// A point of a curve over the track, and its parameter there.
  struct PointOver
  {
    double  t = 0;
    Vector3 place{};
  };
  using CurveAt = std::function<std::optional<Vector3>(double)>;

  /// The points of a curve over n equally spaced y: of several over one y the lowest (`down` = 1) or the
  /// highest (-1).
  std::vector<std::optional<PointOver>>
  points_over(const std::vector<double> &samples,
              const CurveAt             &at,
              double                     first,
              double                     spacing,
              std::size_t                n,
              double                     down);
} // namespace wheelrail
