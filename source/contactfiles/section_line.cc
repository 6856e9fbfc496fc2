#include <wheelrail/base/errors.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/contactfiles/section_line.h>
#include <wheelrail/profiles/profile_formats.h>
#include <wheelrail/profiles/smoothing_spline.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wheelrail
{
  namespace
  {

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

    /// The coefficients of a piece, filled up with zeros.
    std::array<double, 4>
    cubic(const std::vector<double> &coefficients)
    {
      std::array<double, 4> c{};
      std::copy_n(coefficients.begin(), std::min<std::size_t>(4, coefficients.size()), c.begin());
      return c;
    }
  } // namespace


  double
  SectionLine::Place::angle() const
  {
    return std::atan2(dz, dy);
  }


  SectionLine::SectionLine(std::vector<Point2> points, const std::string &file)
  {
    if (!points.empty() && points.front().x > points.back().x)
      std::reverse(points.begin(), points.end());
    constexpr double same = 1e-7; // [m]
    points.erase(std::unique(points.begin(),
                             points.end(),
                             [](const Point2 &a, const Point2 &b) { return norm(a - b) < same; }),
                 points.end());
    if (points.size() < 4)
      throw InputError(file + ": " + std::to_string(points.size()) +
                       " points; a profile of an input file of CONTACT has four or more");
    const std::vector<double> exact(points.size(), 0.);
    for (const Segment &s : smoothing_spline(points, find_kinks(points, exact), exact))
      pieces_.push_back({cubic(s.coefficients_x), cubic(s.coefficients)});

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
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i)
      {
        const double a = at(samples_[i]).y, b = at(samples_[i + 1]).y;
        if (a <= 0 && b > 0)
          {
            zero_ = arc(samples_[i] + (samples_[i + 1] - samples_[i]) * (0 - a) / (b - a));
            break;
          }
      }
  }


  SectionLine::Place
  SectionLine::at(const double t) const
  {
    const double      clamped = std::clamp(t, 0., end());
    const std::size_t k       = std::min(std::size_t(clamped), pieces_.size() - 1);
    const double      u       = t - double(k); // beyond the ends the last piece goes on
    const Piece      &p       = pieces_[k];
    return {value(p.y, u), value(p.z, u), slope(p.y, u), slope(p.z, u)};
  }


  double
  SectionLine::length_within(const std::size_t piece, const double u) const
  {
    // Gauss's rule of four points
    constexpr std::array<double, 4> at{{0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558}},
      weight{{0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226}};
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
      sum += weight[i] * std::hypot(slope(pieces_[piece].y, u * at[i]), slope(pieces_[piece].z, u * at[i]));
    return u * sum;
  }


  double
  SectionLine::arc(const double t) const
  {
    const std::size_t k = std::min(std::size_t(std::clamp(t, 0., end())), pieces_.size() - 1);
    return starts_[k] + length_within(k, t - double(k)) - zero_;
  }


  SectionLine
  section_line(const ContactProfile &profile)
  {
    std::vector<Point2> points;
    if (!profile.points.empty())
      {
        for (const auto &[y, z] : profile.points)
          points.push_back({profile.scale * millimetre * (profile.mirror_y == 1 ? -1 : 1) * y,
                            profile.scale * millimetre * (profile.mirror_z == 1 ? -1 : 1) * z});
        return SectionLine(std::move(points), profile.file);
      }
    const FileContent content = parse_profile_text(read_whole_file(profile.file), profile.file);
    const double      unit    = content.metres_per_unit > 0 ? content.metres_per_unit : millimetre;
    const bool        turned  = profile.mirror_z == 1 || (profile.mirror_z == 0 && !content.down);
    for (const FilePoint &p : content.points)
      points.push_back({profile.scale * unit * (profile.mirror_y == 1 ? -1 : 1) * p.position.x,
                        profile.scale * unit * (turned ? -1 : 1) * p.position.y});
    return SectionLine(std::move(points), profile.file);
  }
} // namespace wheelrail
