#include <wheelrail/application/geometry_picture.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/commands/report_script.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>

namespace wheelrail
{
  namespace
  {
    /// Rows "what, a, b" of numbers in millimetres (distances in micrometres).
    class Rows
    {
    public:
      explicit Rows(const std::string &path)
        : path_(path)
        , file_(path)
      {
        file_ << std::setprecision(9) << "what,a,b\n";
      }

      void
      add(const std::string &what, const double a, const double b)
      {
        file_ << what << ',' << a << ',' << b << '\n';
      }

      /// A text; quotes in it would end the cell.
      void
      add_text(const std::string &what, std::string text)
      {
        std::replace(text.begin(), text.end(), '"', '\'');
        file_ << what << ",\"" << text << "\",\n";
      }

      void
      close()
      {
        file_.close();
        if (!file_)
          throw RunError(path_ + ": cannot be written; choose a folder with room and permission to write");
      }

    private:
      std::string   path_;
      std::ofstream file_;
    };

    void
    add_curve(Rows &rows, const std::string &what, const Curve &curve, const Placement &placement)
    {
      for (const Segment &g : curve.segments())
        {
          const int n = samples_on(g, 32);
          for (int i = 0; i <= n; ++i)
            {
              const Point2 p = placement.to_track(position_on(g, static_cast<double>(i) / n));
              rows.add(what, 1e3 * p.x, 1e3 * p.y);
            }
        }
    }
  } // namespace


  void
  draw_profiles(const ProfileSettings &scene,
                const SceneGeometry   &geometry,
                const std::string     &name,
                std::ostream          &out)
  {
    const ContactGeometry &c = geometry.contact;
    Rows                   rows(name + ".csv");
    rows.add_text("wheel name", scene.wheel_profile);
    rows.add_text("rail name", scene.rail_profile);
    rows.add("shift", 1e3 * c.lateral_shift, 1e3 * c.roll);
    rows.add("radius", 1e3 * c.rolling_radius, c.angle * 180 / M_PI);
    add_curve(rows, "rail", geometry.rail.head, c.rail);
    add_curve(rows, "wheel", geometry.wheel.tread, c.wheel);
    rows.add("contact", 1e3 * c.frame.origin.x, 1e3 * c.frame.origin.y);
    rows.add("contact in sections", 1e3 * c.rail_x, 1e3 * c.wheel_x);
    for (const FurtherPoint &p : c.further)
      if (p.gap < 1e-3)
        {
          rows.add("further", 1e3 * p.frame.origin.x, 1e3 * p.frame.origin.y);
          rows.add("further gap", 1e6 * p.gap, 1e3 * c.frame.to_frame(p.frame.origin).x);
        }
    const FrameProfile &wheel_heights = geometry.wheel_heights(), &rail_heights = geometry.rail_heights();
    const double        low = std::max({wheel_heights.s_min(), rail_heights.s_min(), -0.03}),
                 high       = std::min({wheel_heights.s_max(), rail_heights.s_max(), 0.03});
    for (int i = 0; i <= 1200; ++i)
      {
        const double s = low + (high - low) * i / 1200;
        rows.add("distance", 1e3 * s, 1e6 * undeformed_distance(wheel_heights, rail_heights, s));
      }
    rows.close();
    if (run_script("profile_picture.py", {name + ".csv", name + ".png"}) != 0)
      throw RunError(name + ".png could not be drawn from " + name +
                     ".csv; install the Debian package python3-matplotlib");
    out << "\nPicture of the profiles: " << name << ".png (numbers: " << name << ".csv)\n";
  }
} // namespace wheelrail
