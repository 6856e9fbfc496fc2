#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/geometry/frame_profile.h>
#include <wheelrail/profiles/profile_text.h>
#include <wheelrail/profiles/slices_file.h>

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace wheelrail
{
  namespace
  {
    std::string
    text_of_file(const std::string &path, const std::string &named_at)
    {
      try
        {
          return read_whole_file(path);
        }
      catch (const RunError &error)
        {
          throw InputError(named_at + error.what());
        }
    }

    /// The lines of a slices file, one after the other, without comments.
    class SlicesText
    {
    public:
      explicit SlicesText(const std::string &path)
        : path_(path)
      {
        for (const Line &line : lines_of(text_of_file(path, "")))
          {
            const std::string text    = without_comment(line.text, "%");
            const std::string numbers = text.substr(0, text.find_first_not_of("0123456789+-.,eEdD \t"));
            for (std::size_t k = numbers.find(','); k != std::string::npos; k = numbers.find(',', k + 1))
              if (k > 0 && k + 1 < numbers.size() && std::isdigit(numbers[k - 1]) &&
                  std::isdigit(numbers[k + 1]))
                throw InputError(
                  place(path_, line.number) + shown(text) +
                  ": a comma between digits; write decimal points, and blanks between numbers");
            if (!text.empty())
              lines_.push_back({text, line.number});
          }
      }

      /// The next line, in which `what` is expected.
      const Line &
      next(const std::string &what)
      {
        if (next_ >= lines_.size())
          throw InputError(path_ + ": ends before " + what);
        return lines_[next_++];
      }

      /// At least `n` numbers at the begin of the next line, words after them left out.
      std::vector<double>
      numbers(const std::size_t n, const std::string &what)
      {
        const Line         &line = next(what);
        std::vector<double> values;
        for (const std::string &field : fields_of(line.text))
          if (const auto number = number_of(field); number && values.size() < n)
            values.push_back(*number);
          else
            break;
        if (values.size() < n)
          throw InputError(place(path_, line.number) + shown(line.text) + ": " + what + " is expected");
        return values;
      }

    private:
      std::string       path_;
      std::vector<Line> lines_;
      std::size_t       next_ = 0;
    };

    double
    unit_of_points(const FileContent &content, const ProfileUnit unit, const std::string &file)
    {
      if (unit != ProfileUnit::automatic)
        return unit == ProfileUnit::metre ? 1 : unit == ProfileUnit::inch ? 0.0254 : 1e-3;
      if (content.metres_per_unit > 0)
        return content.metres_per_unit;
      const auto [low, high] = std::minmax_element(
        content.points.begin(), content.points.end(), [](const FilePoint &a, const FilePoint &b) {
          return a.position.x < b.position.x;
        });
      const double width = high->position.x - low->position.x;
      for (const double metres : {1e-3, 1.})
        if (width * metres >= 0.01 && width * metres <= 0.4)
          return metres;
      throw InputError(file + ": the slice is " + format_number(width) +
                       " units wide; as mm or m it is none (10 mm to 400 mm): set the unit of the profile");
    }

    std::vector<Point2>
    points_of_slice(const std::string &file, const std::string &named_at, const ProfileUnit unit)
    {
      const FileContent content = parse_profile_text(text_of_file(file, named_at), file);
      if (content.points.size() < 8)
        throw InputError(file + ": " + counted(content.points.size(), "point") +
                         "; a slice needs at least 8");
      const double        metres = unit_of_points(content, unit, file);
      std::vector<Point2> points;
      for (const FilePoint &p : content.points)
        {
          const Point2 q{metres * p.position.x, -metres * p.position.y};
          if (points.empty() || norm(q - points.back()) > 1e-7)
            points.push_back(q);
        }
      return points;
    }

    /// The quoted name in a line.
    std::optional<std::string>
    quoted(const std::string &text)
    {
      const auto begin = text.find_first_of("'\"");
      const auto end   = begin == std::string::npos ? begin : text.find(text[begin], begin + 1);
      if (end == std::string::npos)
        return {};
      return text.substr(begin + 1, end - begin - 1);
    }

    /// A curve through the points of a slice: cubic splines over the length of the chords.
    class SliceCurve
    {
    public:
      explicit SliceCurve(const std::vector<Point2> &points)
        : length_{0}
      {
        std::vector<double> x{points.front().x}, y{points.front().y};
        for (std::size_t k = 1; k < points.size(); ++k)
          {
            length_.push_back(length_.back() + norm(points[k] - points[k - 1]));
            x.push_back(points[k].x);
            y.push_back(points[k].y);
          }
        for (const auto &[spline, values] : {std::make_pair(&x_, &x), {&y_, &y}})
          {
            spline->reset(gsl_spline_alloc(gsl_interp_cspline, values->size()), gsl_spline_free);
            gsl_spline_init(spline->get(), length_.data(), values->data(), values->size());
          }
        const auto [low, high] = std::minmax_element(x.begin(), x.end());
        low_                   = *low;
        high_                  = *high;
      }

      double
      low() const
      {
        return low_;
      }
      double
      high() const
      {
        return high_;
      }

      /// Over its chords [m].
      double
      length() const
      {
        return length_.back();
      }

      /// Where the line from `point` along `normal` meets the curve nearest, or misses an end of it by less
      /// than `beside`: the way to it [m]; nothing where it does not within `reach`.
      std::optional<double>
      way_to(const Point2 &point, const Point2 &normal, const double reach, const double beside) const
      {
        std::optional<double> nearest;
        const auto            side   = [&](const double s) { return cross(normal, at(s) - point); };
        double                before = side(length_.front());
        for (std::size_t k = 1; k < length_.size(); ++k)
          {
            const double now = side(length_[k]);
            if ((before > 0) != (now > 0))
              {
                double a = length_[k - 1], b = length_[k], f = before;
                for (double m = 0.5 * (a + b); m > a && m < b && b - a > 1e-15; m = 0.5 * (a + b))
                  if (const double value = side(m); (value > 0) == (f > 0))
                    a = m;
                  else
                    b = m;
                const double way = dot(at(0.5 * (a + b)) - point, normal);
                if (std::abs(way) < reach && (!nearest || std::abs(way) < std::abs(*nearest)))
                  nearest = way;
              }
            before = now;
          }
        for (const double end : {length_.front(), length_.back()})
          if (const Point2 d = at(end) - point;
              !nearest && std::abs(cross(normal, d)) < beside && std::abs(dot(normal, d)) < reach)
            nearest = dot(normal, d);
        return nearest;
      }

    private:
      Point2
      at(const double s) const
      {
        return {gsl_spline_eval(x_.get(), s, nullptr), gsl_spline_eval(y_.get(), s, nullptr)};
      }

      std::vector<double>         length_;
      std::shared_ptr<gsl_spline> x_, y_;
      double                      low_ = 0, high_ = 0;
    };

    void
    read_slices(SlicesText &text, const std::string &path, const ProfileUnit unit, Slices &slices)
    {
      const bool        wheel  = slices.wheel;
      const auto        scale  = text.numbers(2, wheel ? "TH_OFFSET TH_SCALE" : "U_OFFSET U_SCALE");
      const auto        count  = text.numbers(1, "NSLC, the number of slices")[0];
      const auto        parts  = text.numbers(3, "NFEAT NKINK NACCEL");
      const auto        kind   = text.numbers(1, wheel ? "TH_INTPOL" : "U_INTPOL")[0];
      const std::string folder = std::filesystem::path(path).parent_path().string();
      if (!(count >= 4) || count > 10000)
        throw InputError(path + ": NSLC = " + format_number(count) + "; 4 to 10000 slices are accepted");
      if (parts[0] > 1)
        throw InputError(path + ": NFEAT = " + format_number(parts[0]) +
                         "; a rail in parts (a crossing) is not read, only one surface without features");
      if (kind != 1 && kind != 2)
        throw InputError(path + ": " + (wheel ? "TH_INTPOL" : "U_INTPOL") + " = " + format_number(kind) +
                         "; 1 (interpolation) or 2 (smoothing) are accepted");
      slices.smoothed = kind == 2;
      for (int k = 0; k < count; ++k)
        {
          const Line &line     = text.next("slice " + std::to_string(k + 1) + " of " + format_number(count));
          const std::string at = place(path, line.number);
          const auto        name   = quoted(line.text);
          const auto        fields = fields_of(line.text);
          const auto        where  = fields.empty() ? std::nullopt : number_of(fields.front());
          if (!name || !where)
            throw InputError(at + shown(line.text) +
                             ": a place and the name of a file in quotes are expected");
          const double along = (wheel ? 1 : 1e-3) * scale[1] * (scale[0] + *where);
          if (!slices.slices.empty() && !(along > slices.slices.back().along))
            throw InputError(at + "the places of the slices do not ascend; order them along " +
                             (wheel ? "the angle" : "the track"));
          slices.slices.push_back(
            {along, points_of_slice((std::filesystem::path(folder) / *name).string(), at, unit)});
        }
    }
  } // namespace


  bool
  is_slices_file(const std::string &path)
  {
    const std::string ending = lower(std::filesystem::path(path).extension().string());
    return ending == ".slcs" || ending == ".slcw";
  }


  Slices
  read_slices_file(const std::string &path, const ProfileUnit unit)
  {
    Slices slices;
    slices.wheel = lower(std::filesystem::path(path).extension().string()) == ".slcw";
    SlicesText text(path);
    read_slices(text, path, unit, slices);
    return slices;
  }


  HeightGrid
  heights_of_slices(const Slices &slices, const Curve &profile, const double radius, const std::string &path)
  {
    // `beside`: what a normal may miss the end of a slice by that is moved or tilted against the profile
    constexpr double        spacing = 0.5e-3, reach = 5e-3, beside = 0.2e-3, least = 10e-3, steepest = 4;
    std::vector<SliceCurve> curves;
    HeightGrid              grid;
    for (const Slices::Slice &slice : slices.slices)
      {
        curves.emplace_back(slice.points);
        grid.along.push_back(slices.wheel ? radius * slice.along : slice.along);
      }
    // s of this frame is minus x of the section
    const FrameProfile base(profile, Placement(), ContactFrame(), steepest);
    double             low = -base.s_max(), high = -base.s_min();
    for (const SliceCurve &curve : curves)
      {
        low  = std::max(low, curve.low());
        high = std::min(high, curve.high());
      }
    if (!(high - low > least))
      throw InputError(path + ": slices and profile lie beside each other over less than " + in_mm(least) +
                       "; their lateral origins must be the same, y to the field side");
    // as CONTACT divides the longest slice: between its points a spline rings beside kinks, and the pressure
    // there depends on where they lie
    double longest = 0;
    for (const SliceCurve &curve : curves)
      longest = std::max(longest, curve.length());
    const int n = 1 + static_cast<int>(std::floor(longest / spacing));
    for (int i = 0; i <= n; ++i)
      grid.across.push_back(low + (high - low) * i / n);
    for (const double x : grid.across)
      {
        const CurvePoint p = profile.at(base.parameter(-x));
        const Point2     normal =
          slices.wheel ? Point2{-p.tangent.y, p.tangent.x} : Point2{p.tangent.y, -p.tangent.x};
        for (std::size_t k = 0; k < curves.size(); ++k)
          {
            const auto way = curves[k].way_to(p.position, normal, reach, beside);
            if (!way)
              throw InputError(path + ": slice " + std::to_string(k + 1) + " is more than " + in_mm(reach) +
                               " away from the profile at " + in_mm(x) +
                               "; slices have y to the field side and z down, and the origin of the profile");
            grid.height.push_back(*way);
          }
      }
    if (slices.smoothed)
      {
        // heights are control points of a uniform cubic B-spline, continued along a line at the ends
        const std::size_t m = grid.along.size();
        for (std::size_t row = 0; row < grid.height.size(); row += m)
          {
            const std::vector<double> control(grid.height.begin() + row, grid.height.begin() + row + m);
            for (std::size_t k = 1; k + 1 < m; ++k)
              grid.height[row + k] = (control[k - 1] + 4 * control[k] + control[k + 1]) / 6;
          }
      }
    return grid;
  }


  Irregularity
  slices_irregularity(const HeightGrid &heights, const double place, const double circumference)
  {
    Irregularity shape = grid_irregularity(heights, place, 0, circumference);
    shape.endless      = true;
    return shape;
  }
} // namespace wheelrail
