#pragma once

#include <wheelrail/geometry/profiles.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/sections/sections_surface.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Two rails by slices beside each other under one wheel, as wing and nose of a crossing, as one surface
  /// that a mesh can have.
  ///
  /// The surface is that of the higher rail, and nowhere deeper than `below` under what the rigid wheel
  /// sweeps when it rolls over both: up to there the flangeway and all that the wheel does not come near are
  /// filled. What the wheel sweeps is its lowest line W(x) over the section at the height g(z), the closing
  /// of the highest places of the rails against it, m(z) = max over x of S - W, with the wheel's circle
  /// (Serra 1982): h(a) = max over z of m - (z - a)^2/2R is its height at the place a, g(z) = min over a of
  /// h + (z - a)^2/2R.
  ///
  /// A rail is cut off where its head, 5 mm below its top, is thinner than three cells. Where a rail that
  /// the wheel comes near begins or ends, it sinks out of reach over three cells, 10 mm at least.
  class CrossingSurface
  {
  public:
    /// Over the path of the scene and 100 mm before and behind it. What is cut off is told in `notes`. Throws
    /// InputError that names the entry.
    CrossingSurface(const Scene &scene, const WheelProfile &wheel, std::vector<std::string> &notes);

    /// Depth below what the wheel sweeps [m].
    static constexpr double below = 0.6e-3;

    /// Places along the rails, `start` of which is the begin of the path [m].
    std::vector<double> along;
    std::size_t         start = 0;

    /// Where the wheel comes near the rails, and 20 mm beside it; of the section, positive to the field side
    /// [m].
    std::vector<double> across;

    /// Heights over these at each of the places along, y up [m].
    std::vector<std::vector<double>> height;

    /// Largest slope along of the surface where the rigid wheel touches it.
    double slope = 0;

    /// Length over which it rises and falls, of eight of the shortest distances of slices [m].
    double shortest = 0;

    /// Whether a place along and across belongs to the second rail: its border lies in the middle of the
    /// flangeway.
    bool
    on_second(double across, double along) const;

    /// The section where the path begins, from the field side to the gauge side, with rounded corners of 13
    /// mm and sides of 1:20 [m].
    std::vector<Point2>
    section_of_start() const;

  private:
    struct OneRail;

    void
    lay_places(const ProfileSettings &scene, double distance);
    OneRail
    read_rail(const Scene              &scene,
              const std::string        &name,
              const std::string        &path,
              std::vector<std::string> &notes) const;
    double
    sunk(const OneRail &rail, double place) const;
    std::vector<double>
    swept(const std::vector<double> &highest,
          const std::vector<double> &highest_across,
          double                     edge,
          double                     radius);
    void
    fill(const std::vector<OneRail> &rails,
         const std::vector<double>  &wheel,
         const Scene                &scene,
         const WheelProfile         &profile,
         std::vector<std::string>   &notes);

    void
    refuse_flange(const std::vector<OneRail> &rails,
                  const std::vector<double>  &heights,
                  const Scene                &scene,
                  const WheelProfile         &profile) const;

    void
    note_ends(const std::vector<OneRail> &rails,
              const std::vector<double>  &wheel,
              const std::vector<double>  &heights,
              std::vector<std::string>   &notes) const;
    void
    note_far(const std::vector<OneRail> &rails,
             const std::vector<double>  &wheel,
             const std::vector<double>  &heights,
             std::vector<std::string>   &notes) const;
    void
    keep(std::size_t first, std::size_t end);

    Range                          slices_; ///< where there are any [m]
    std::vector<std::vector<char>> second_; ///< [along][across]
  };
} // namespace wheelrail
