#include <deal.II/base/quadrature_lib.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/contactfiles/section_line.h>
#include <wheelrail/profiles/profile_formats.h>
#include <wheelrail/profiles/smoothing_spline.h>
#include <wheelrail/sections/cubic_spline.h>
#include <wheelrail/sections/slices_file.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    constexpr double same = 1e-7; ///< distance of points that count as one [m]

    double
    value(const std::array<double, 4> &c, const double u)
    {
      return c[0] + u * (c[1] + u * (c[2] + u * c[3]));
    }

    double
    slope(const std::array<double, 4> &c, const double u)
    {
      return c[1] + u * (2 * c[2] + u * 3 * c[3]);
    }

    /// A piece of a spline as a cubic of u from 0 to 1.
    std::array<double, 4>
    cubic(const double length, const double a, const double b, const double second_a, const double second_b)
    {
      const double h = length * length / 6;
      return {{a, b - a - h * (2 * second_a + second_b), 3 * h * second_a, h * (second_b - second_a)}};
    }
  } // namespace


  double
  ProfileLine::Place::angle() const
  {
    return std::atan2(dz, dy);
  }


  ProfileLine::ProfileLine(std::vector<Point2> points, const std::string &file, const bool kinks)
  {
    if (!points.empty() && points.front().x > points.back().x)
      std::reverse(points.begin(), points.end());
    points.erase(std::unique(points.begin(),
                             points.end(),
                             [](const Point2 &a, const Point2 &b) { return norm(a - b) < same; }),
                 points.end());
    if (points.size() < 4)
      throw InputError(file + ": " + std::to_string(points.size()) +
                       " points; a profile of an input file of CONTACT has four or more");
    std::vector<double> knots{0}, y, z;
    for (std::size_t k = 0; k < points.size(); ++k)
      {
        y.push_back(points[k].x);
        z.push_back(points[k].y);
        if (k > 0)
          knots.push_back(knots.back() + norm(points[k] - points[k - 1]));
      }
    // between kinks, where the tangent jumps
    std::vector<std::size_t> ends;
    if (kinks)
      ends = find_kinks(points, std::vector<double>(points.size(), 0.));
    ends.push_back(points.size() - 1);
    std::size_t first = 0;
    for (const std::size_t last : ends)
      {
        if (last == first)
          continue;
        const auto part = [&](const std::vector<double> &all) {
          return std::vector<double>(all.begin() + std::ptrdiff_t(first),
                                     all.begin() + std::ptrdiff_t(last) + 1);
        };
        const std::vector<double> s = part(knots), dy = second_derivatives(s, part(y), SplineEnds::natural),
                                  dz = second_derivatives(s, part(z), SplineEnds::natural);
        for (std::size_t k = first; k < last; ++k)
          {
            const double      length = knots[k + 1] - knots[k];
            const std::size_t i      = k - first;
            pieces_.push_back({cubic(length, y[k], y[k + 1], dy[i], dy[i + 1]),
                               cubic(length, z[k], z[k + 1], dz[i], dz[i + 1])});
          }
        first = last;
      }

    measure();
    const auto middle = std::find_if(points.begin(), points.end(), [](const Point2 &p) { return p.x >= 0; });
    if (middle != points.end())
      zero_ = starts_[std::size_t(middle - points.begin())];
  }


  ProfileLine
  ProfileLine::straight(std::vector<Point2> points)
  {
    if (!points.empty() && points.front().x > points.back().x)
      std::reverse(points.begin(), points.end());
    ProfileLine line;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      line.pieces_.push_back({{{points[k].x, points[k + 1].x - points[k].x, 0, 0}},
                              {{points[k].y, points[k + 1].y - points[k].y, 0, 0}}});
    line.measure();
    const auto middle = std::find_if(points.begin(), points.end(), [](const Point2 &p) { return p.x >= 0; });
    if (middle != points.end())
      line.zero_ = line.starts_[std::size_t(middle - points.begin())];
    return line;
  }


  void
  ProfileLine::measure()
  {
    constexpr double spacing = 5e-5; // [m]
    starts_.push_back(0);
    for (std::size_t k = 0; k < pieces_.size(); ++k)
      {
        const double length = length_within(k, 1);
        starts_.push_back(starts_.back() + length);
        const int n = std::max(1, int(std::ceil(length / spacing)));
        for (int i = 0; i < n; ++i)
          samples_.push_back(double(k) + double(i) / n);
      }
    samples_.push_back(end());
  }


  double
  ProfileLine::parameter(const double arc) const
  {
    const double along = arc + zero_;
    if (along <= 0 || along >= starts_.back())
      return along <= 0 ? 0 : end();
    const auto        next = std::upper_bound(starts_.begin(), starts_.end(), along);
    const std::size_t k    = std::size_t(next - starts_.begin()) - 1;
    double            u    = (along - starts_[k]) / (starts_[k + 1] - starts_[k]);
    for (int step = 0; step < 3; ++step)
      u += (along - starts_[k] - length_within(k, u)) /
           std::hypot(slope(pieces_[k].y, u), slope(pieces_[k].z, u));
    return double(k) + std::clamp(u, 0., 1.);
  }


  ProfileLine
  ProfileLine::chords(const double from, const double spacing) const
  {
    ProfileLine  line;
    const double first =
      from - spacing * std::floor((from + zero_) / spacing); // the first within the section
    const int n = int((starts_.back() - zero_ - first) / spacing);
    Place     a = at(parameter(first));
    for (int k = 1; k <= n; ++k)
      {
        const Place b = at(parameter(first + k * spacing));
        line.pieces_.push_back({{{a.y, b.y - a.y, 0, 0}}, {{a.z, b.z - a.z, 0, 0}}});
        a = b;
      }
    line.measure();
    return line;
  }


  ProfileLine::Place
  ProfileLine::at(const double t) const
  {
    const double      clamped = std::clamp(t, 0., end());
    const std::size_t k       = std::min(std::size_t(clamped), pieces_.size() - 1);
    const double      u       = t - double(k); // beyond the ends the last piece goes on
    const Piece      &p       = pieces_[k];
    return {value(p.y, u), value(p.z, u), slope(p.y, u), slope(p.z, u)};
  }


  double
  ProfileLine::length_within(const std::size_t piece, const double u) const
  {
    static const dealii::QGauss<1> gauss(4);
    double                         sum = 0;
    for (unsigned int i = 0; i < gauss.size(); ++i)
      {
        const double at = u * gauss.point(i)[0];
        sum += gauss.weight(i) * std::hypot(slope(pieces_[piece].y, at), slope(pieces_[piece].z, at));
      }
    return u * sum;
  }


  double
  ProfileLine::arc(const double t) const
  {
    const std::size_t k = std::min(std::size_t(std::clamp(t, 0., end())), pieces_.size() - 1);
    return starts_[k] + length_within(k, t - double(k)) - zero_;
  }


  double
  arc_at_y(const ProfileLine &line, const double y)
  {
    double t = 0;
    for (const double sample : line.samples())
      if (line.at(sample).y < y)
        t = sample;
    const ProfileLine::Place p = line.at(t);
    return line.arc(t + (p.dy > 0 ? std::min(1., (y - p.y) / p.dy) : 0));
  }


  namespace
  {
    /// Whether z of a file points up: by the habit of its format; in two columns by the ends of a head, which
    /// lie below its middle, or the flange, which hangs down farther than anything rises.
    bool
    points_up(const FileContent &content, const bool wheel)
    {
      if (content.format != "two columns" || content.points.empty())
        return !content.down;
      const double first = content.points.front().position.y, last = content.points.back().position.y,
                   middle = content.points[content.points.size() / 2].position.y;
      if (!wheel)
        return 0.5 * (first + last) < middle;
      double low = middle, high = middle;
      for (const FilePoint &p : content.points)
        {
          low  = std::min(low, p.position.y);
          high = std::max(high, p.position.y);
        }
      const double rises = high - middle, hangs = middle - low, most = std::max(rises, hangs);
      if (std::min(rises, hangs) < 0.05 * most && std::abs(first - last) < 0.5 * most)
        return rises > hangs; // a disc without flange, from whose middle both ends rise
      return rises < hangs;
    }
  } // namespace


  namespace
  {
    /// Points on smoothing splines over the chord length between kinks, which weigh a hundred times as much
    /// as others, as CONTACT lays them (ISMOOTH = 0). lambda in m3.
    std::vector<Point2>
    smoothed_points(const std::vector<Point2> &given, const double lambda)
    {
      std::vector<Point2> points;
      std::vector<double> places;
      for (const Point2 &p : given)
        {
          const double step = points.empty() ? 0 : norm(p - points.back());
          if (!points.empty() && step < same)
            continue;
          places.push_back(points.empty() ? 0 : places.back() + step);
          points.push_back(p);
        }
      std::vector<std::size_t> ends = find_kinks(points, std::vector<double>(points.size(), 0.));
      std::vector<double>      weights(points.size(), 1.);
      for (const std::size_t k : ends)
        weights[k] = 100;
      ends.push_back(points.size() - 1);
      std::vector<Point2> smooth = points;
      std::size_t         first  = 0;
      for (const std::size_t last : ends)
        {
          std::vector<double> s, w, y, z;
          for (std::size_t k = first; k <= last; ++k)
            {
              s.push_back(places[k]);
              w.push_back(weights[k]);
              y.push_back(points[k].x);
              z.push_back(points[k].y);
            }
          y = smoothed_values(s, y, w, lambda);
          z = smoothed_values(s, z, w, lambda);
          for (std::size_t k = first; k <= last; ++k)
            smooth[k] = {y[k - first], z[k - first]};
          first = last;
        }
      return smooth;
    }

    std::vector<Point2>
    given_points(const ContactProfile &profile, const bool wheel)
    {
      std::vector<Point2> points;
      if (!profile.points.empty())
        {
          for (const auto &[y, z] : profile.points)
            points.push_back({profile.scale * millimetre * (profile.mirror_y == 1 ? -1 : 1) * y,
                              profile.scale * millimetre * (profile.mirror_z == 1 ? -1 : 1) * z});
          return points;
        }
      const FileContent content = parse_profile_text(read_whole_file(profile.file), profile.file);
      const double      unit    = content.metres_per_unit > 0 ? content.metres_per_unit : millimetre;
      const bool turned = profile.mirror_z == 1 || (profile.mirror_z == 0 && points_up(content, wheel));
      for (const FilePoint &p : content.points)
        points.push_back({profile.scale * unit * (profile.mirror_y == 1 ? -1 : 1) * p.position.x,
                          profile.scale * unit * (turned ? -1 : 1) * p.position.y});
      return points;
    }
  } // namespace


  std::vector<Point2>
  section_points(const ContactProfile &profile, const bool wheel)
  {
    std::vector<Point2> points = given_points(profile, wheel);
    if (profile.smoothing > 0 && points.size() >= 4)
      return smoothed_points(points, profile.smoothing * std::pow(millimetre, 3));
    return points;
  }

  ProfileLine
  section_line(const ContactProfile &profile, const bool wheel)
  {
    return ProfileLine(section_points(profile, wheel), profile.file);
  }


  std::shared_ptr<const SectionsSurface>
  contact_slices(const ContactProfile &profile, const bool wheel)
  {
    const bool in_metres = profile.scale == 1000;
    Slices slices = read_slices_file(profile.file, in_metres ? ProfileUnit::metre : ProfileUnit::millimetre);
    if (slices.wheel != wheel)
      throw InputError(profile.file + (wheel ? ": slices of a rail (.slcs) stand for a wheel"
                                             : ": slices of a wheel (.slcw) stand for a rail"));
    const double scale = in_metres ? 1 : profile.scale;
    for (Slices::Slice &slice : slices.slices)
      for (Point2 &p : slice.points)
        p = {(profile.mirror_y == 1 ? -1 : 1) * scale * p.x, (profile.mirror_z == 1 ? -1 : 1) * scale * p.y};
    return std::make_shared<const SectionsSurface>(slices, Placement{{0, 0}, 0}, 0, profile.file);
  }


  ProfileLine
  section_at(const SectionsSurface &slices, const double place, const bool wheel)
  {
    const SectionColumn column = slices.column(place);
    if (column.empty())
      throw InputError(slices.path() + ": nothing is at " +
                       (wheel ? text("%.4g degrees", place * 180 / M_PI) : text("%g mm", 1e3 * place)));
    slices.refuse_jump(place);
    std::vector<Point2> points;
    for (const Point2 &p : column.points()) // there y to the track centre and z up
      points.push_back({-p.x, -p.y});
    return ProfileLine(std::move(points), slices.path(), false);
  }
} // namespace wheelrail
