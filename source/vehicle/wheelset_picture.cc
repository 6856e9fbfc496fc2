#include <wheelrail/geometry/track.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/vehicle/wheelset_picture.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace wheelrail
{
  namespace
  {
    /// The rows of one wheel, which was computed as its mirror image when it is the left one.
    class WheelRows
    {
    public:
      WheelRows(const WheelOnAxle &wheel, const bool left, std::ostream &file)
        : geometry_(wheel.geometry)
        , side_(left ? "left" : "right")
        , to_right_(left ? -1 : 1)
        , middle_(running_circle_distance(wheel.scene.track))
        , file_(file)
      {
      }

      void
      add_profiles() const
      {
        add_curve("rail", geometry_.rail.head, geometry_.contact.rail);
        add_curve("wheel", geometry_.wheel.tread, geometry_.contact.wheel);
      }

      void
      add_patch(const WheelRailSolution &patch) const
      {
        add_place("contact", patch.reference->place);
        add("force", -to_right_ * 1e-3 * patch.lateral, 1e-3 * patch.vertical);
        add("peak pressure", 1e-6 * patch.solution.peak_pressure, 1e6 * patch.measures.area);
        // from edge to edge, along the mean plane
        const Point2 half = 0.5 * patch.measures.width * Point2{std::cos(patch.angle), std::sin(patch.angle)};
        add_place("edge", patch.reference->place - half);
        add_place("edge", patch.reference->place + half);
      }

    private:
      void
      add(const std::string &what, const double x, const double y) const
      {
        file_ << side_ << ',' << what << ',' << x << ',' << y << '\n';
      }

      /// A place of the track plane in which the wheel was computed.
      void
      add_place(const std::string &what, const Point2 &place) const
      {
        add(what, to_right_ * 1e3 * (middle_ - place.x), 1e3 * place.y);
      }

      void
      add_curve(const std::string &what, const Curve &curve, const Placement &placement) const
      {
        for (const Segment &segment : curve.segments())
          {
            const int n = samples_on(segment, 16);
            for (int i = 0; i <= n; ++i)
              add_place(what, placement.to_track(position_on(segment, static_cast<double>(i) / n)));
          }
      }

      const SceneGeometry &geometry_;
      std::string          side_;
      double               to_right_, middle_;
      std::ostream        &file_;
    };
  } // namespace


  void
  write_wheelset_lines(const WheelsetSolution &wheelset, const std::string &path)
  {
    std::ostringstream file;
    file << std::setprecision(9) << "side,what,x,y\n";
    for (const bool left : {false, true})
      {
        const WheelRows rows(left ? wheelset.left : wheelset.right, left, file);
        rows.add_profiles();
        if (const auto &solution = left ? wheelset.axle.left : wheelset.axle.right)
          {
            rows.add_patch(*solution);
            for (const WheelRailSolution &other : solution->others)
              rows.add_patch(other);
          }
      }
    replace_file(path, file.str());
  }
} // namespace wheelrail
