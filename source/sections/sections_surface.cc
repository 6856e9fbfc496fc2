#include <wheelrail/base/errors.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/profiles/height_noise.h>
#include <wheelrail/profiles/measurement_noise.h>
#include <wheelrail/profiles/smoothing_spline.h>
#include <wheelrail/sections/sections_surface.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace wheelrail
{
  namespace
  {
    /// A slice as a smooth curve over the chord length of its points, from the end at the track centre.
    struct SmoothSlice
    {
      std::vector<double>  chords; ///< to the ends of its pieces [m]
      std::vector<Segment> pieces;

      double
      length() const
      {
        return chords.back();
      }

      Point2
      at(const double s) const
      {
        const std::size_t k = std::upper_bound(chords.begin() + 1, chords.end() - 1, s) - chords.begin() - 1;
        return position_on(pieces[k], std::clamp((s - chords[k]) / (chords[k + 1] - chords[k]), 0., 1.));
      }
    };

    SmoothSlice
    smooth_slice(std::vector<Point2> points, const double noise)
    {
      if (points.front().x > points.back().x)
        std::reverse(points.begin(), points.end());
      const std::vector<double> deviation =
        noise >= 0 ? std::vector<double>(points.size(), noise) : estimated_scatter(points);
      SmoothSlice slice;
      slice.pieces = smoothing_spline(points, find_kinks(points, deviation), deviation);
      slice.chords = {0};
      for (const Segment &piece : slice.pieces)
        slice.chords.push_back(slice.chords.back() + norm(piece.end - piece.start));
      return slice;
    }

    std::string
    slice_name(const std::string &path, const std::size_t k)
    {
      return path + ": slice " + std::to_string(k + 1);
    }

    /// Arc lengths of the features of a slice, its ends where it has none [m].
    std::vector<double>
    features_of(const Slices::Slice &slice, const double length, const std::string &name)
    {
      if (slice.features.empty())
        return {0, length};
      std::vector<double> features = slice.features;
      for (std::size_t f = 0; f < features.size(); ++f)
        if (features[f] > length)
          {
            if (f + 1 < features.size() && features[f + 1] >= 0)
              throw InputError(name + ": feature " + std::to_string(f + 1) + " at " + in_mm(features[f]) +
                               " lies behind the end of the slice, " + in_mm(length) +
                               " long; only the last feature may");
            features[f] = length;
          }
      return features;
    }

    /// Throws InputError where a slice is much more like the one before when its sides are exchanged.
    void
    refuse_mirrored(const std::vector<SmoothSlice> &slices, const std::string &path)
    {
      constexpr double far = 5e-3, near = 0.3;
      constexpr int    n = 50;
      for (std::size_t k = 0; k + 1 < slices.size(); ++k)
        {
          const SmoothSlice &a = slices[k], &b = slices[k + 1];
          double             as_is = 0, turned = 0;
          for (int i = 0; i <= n; ++i)
            {
              const double f  = static_cast<double>(i) / n;
              const Point2 at = a.at(f * a.length()), same = b.at(f * b.length()),
                           other = b.at((1 - f) * b.length()), side{at.x + other.x, at.y - other.y};
              as_is += dot(at - same, at - same) / n;
              turned += dot(side, side) / n;
            }
          if (std::sqrt(as_is) > far && std::sqrt(turned) < near * std::sqrt(as_is))
            throw InputError(slice_name(path, k + 1) +
                             " lies mirrored to the slice before; y of all slices points to the field side");
        }
    }
  } // namespace


  SectionsSurface::SectionsSurface(const Slices      &slices,
                                   const Placement   &placement,
                                   const double       noise,
                                   const std::string &path,
                                   const double       spacing,
                                   const bool         ends)
    : path_(path)
    , spacing_(spacing)
    , ends_(ends)
  {
    lay_lines(slices, placement, noise);
    if (noise < 0)
      find_noise();
    if (slices.smoothed)
      smooth_along();
    find_jumps();
    find_runs();
  }


  void
  SectionsSurface::lay_lines(const Slices &slices, const Placement &placement, const double noise)
  {
    const std::size_t                n = slices.slices.size();
    std::vector<SmoothSlice>         smooth(n);
    std::vector<std::vector<double>> features(n);
    parallel_for(n, [&](const std::size_t k) {
      smooth[k]   = smooth_slice(slices.slices[k].points, noise);
      features[k] = features_of(slices.slices[k], smooth[k].length(), slice_name(path_, k));
    });
    refuse_mirrored(smooth, path_);
    const std::size_t parts = features.front().size() - 1;
    part_begin_             = {0};
    for (const Slices::Slice &slice : slices.slices)
      places_.push_back(slice.along);
    for (std::size_t p = 0; p < parts; ++p)
      {
        std::vector<double> &lengths = lengths_.emplace_back();
        for (const std::vector<double> &f : features)
          lengths.push_back(f[p] >= 0 && f[p + 1] >= 0 ? f[p + 1] - f[p] : 0);
        const double longest = *std::max_element(lengths.begin(), lengths.end());
        part_begin_.push_back(part_begin_.back() + 1 +
                              static_cast<std::size_t>(std::floor(longest / spacing_)));
      }
    lines_.assign(part_begin_.back() + 1, std::vector<Point2>(n));
    for (std::size_t p = 0; p < parts; ++p)
      for (std::size_t line = part_begin_[p]; line <= part_begin_[p + 1]; ++line)
        for (std::size_t k = 0; k < n; ++k)
          if (lengths_[p][k] > 0)
            lines_[line][k] = placement.to_track(
              smooth[k].at(features[k][p] + lengths_[p][k] * static_cast<double>(line - part_begin_[p]) /
                                              static_cast<double>(part_begin_[p + 1] - part_begin_[p])));
  }


  void
  SectionsSurface::find_noise()
  {
    std::vector<Heights> whole;
    for (std::size_t p = 0; p < lengths_.size(); ++p)
      for (std::size_t line = part_begin_[p]; line <= part_begin_[p + 1]; ++line)
        if (*std::min_element(lengths_[p].begin(), lengths_[p].end()) > 0)
          {
            Heights &along = whole.emplace_back();
            for (std::size_t k = 0; k < places_.size(); ++k)
              along.push_back({places_[k], lines_[line][k].y});
          }
    noise_ = noise_of_slices(whole);
  }


  void
  SectionsSurface::smooth_along()
  {
    const std::size_t n       = places_.size();
    const double      spacing = (places_.back() - places_.front()) / double(n - 1);
    for (std::size_t k = 0; k + 1 < n; ++k)
      if (std::abs(places_[k + 1] - places_[k] - spacing) > 0.01 * spacing)
        throw InputError(path_ +
                         ": U_INTPOL = 2 (an approximating spline) on slices that are not equally far apart");
    for (const std::vector<double> &lengths : lengths_)
      if (*std::min_element(lengths.begin(), lengths.end()) <= 0)
        throw InputError(path_ + ": U_INTPOL = 2 (an approximating spline) with parts that begin or end");
    // values at the knots of the cubic B-spline with the points of the slices as control points (de Boor
    // 1978)
    for (std::vector<Point2> &line : lines_)
      {
        const std::vector<Point2> control = line;
        for (std::size_t k = 1; k + 1 < n; ++k)
          line[k] = (1. / 6) * (control[k - 1] + 4 * control[k] + control[k + 1]);
      }
  }


  void
  SectionsSurface::find_jumps()
  {
    constexpr double most_relative = 0.3, most = 20e-3;
    for (std::size_t p = 0; p < lengths_.size(); ++p)
      for (std::size_t k = 0; k + 1 < places_.size(); ++k)
        if (const double a = lengths_[p][k], b = lengths_[p][k + 1];
            a > 0 && b > 0 && std::abs(b - a) > std::max(most, most_relative * std::min(a, b)))
          jumps_.push_back({places_[k], places_[k + 1], a, b, p, k + 1});
  }


  void
  SectionsSurface::find_runs()
  {
    constexpr std::size_t least = 4;
    const std::size_t     n = places_.size(), parts = lengths_.size();
    // `has`: whether the strip is on slice k; `jumps`: behind it
    const auto add = [&](const std::size_t first, const std::size_t end, const auto &has, const auto &jumps) {
      Strip strip{first, end, {}};
      for (std::size_t k = 0; k < n;)
        {
          const std::size_t begin = k;
          while (k < n && has(k) && (k == begin || !jumps(k - 1)))
            ++k;
          const bool broken = (k > 0 && k < n && jumps(k - 1)) || (begin > 0 && jumps(begin - 1));
          if (k - begin >= least)
            strip.runs.push_back({begin, k});
          else if (k > begin && !broken)
            throw InputError(path_ + ": a part that begins at slice " + std::to_string(begin + 1) +
                             " ends after " + std::to_string(k - begin) +
                             "; it needs at least 4 slices in a row");
          if (k == begin)
            ++k;
        }
      strips_.push_back(strip);
    };
    const auto has = [&](const std::size_t p, const std::size_t k) {
      return p < parts && lengths_[p][k] > 0;
    };
    const auto jumps = [&](const std::size_t p, const std::size_t k) {
      return std::any_of(jumps_.begin(), jumps_.end(), [&](const Jump &jump) {
        return jump.part == p && jump.slice == k + 1;
      });
    };
    for (std::size_t f = 0; f <= parts; ++f)
      {
        // the line of a feature, then those between it and the next
        add(
          part_begin_[f],
          part_begin_[f] + 1,
          [&](const std::size_t k) { return has(f, k) || (f > 0 && has(f - 1, k)); },
          [&](const std::size_t k) { return jumps(f, k) || (f > 0 && jumps(f - 1, k)); });
        if (f < parts)
          add(
            part_begin_[f] + 1,
            part_begin_[f + 1],
            [&](const std::size_t k) { return has(f, k); },
            [&](const std::size_t k) { return jumps(f, k); });
      }
  }


  SectionColumn
  SectionsSurface::column(const double place, const std::size_t first, const std::size_t end) const
  {
    const double        at     = std::clamp(place, places_.front(), places_.back());
    const bool          inside = ends_ || (place > places_.front() && place < places_.back());
    std::vector<Point2> points, along;
    std::size_t         begin = first;
    std::map<std::pair<std::size_t, std::size_t>, SplineWeights> weights;
    for (const Strip &strip : strips_)
      {
        if (strip.end <= first || strip.first >= end || strip.end == strip.first)
          continue;
        const auto run = std::find_if(strip.runs.begin(), strip.runs.end(), [&](const auto &r) {
          return at >= places_[r.first] && at <= places_[r.second - 1];
        });
        if (run == strip.runs.end())
          {
            if (points.empty())
              begin = strip.end;
            else
              break;
            continue;
          }
        const auto [found, fresh] = weights.try_emplace(*run);
        SplineWeights &w          = found->second;
        if (fresh)
          w = spline_weights({places_.begin() + static_cast<std::ptrdiff_t>(run->first),
                              places_.begin() + static_cast<std::ptrdiff_t>(run->second)},
                             at);
        for (std::size_t line = std::max(first, strip.first); line < std::min(end, strip.end); ++line)
          {
            const Point2 *values = lines_[line].data() + run->first + w.first;
            Point2        p, d;
            for (std::size_t k = 0; k < w.value.size(); ++k)
              {
                p = p + w.value[k] * values[k];
                d = d + w.slope[k] * values[k];
              }
            points.push_back(p);
            along.push_back(inside ? d : Point2());
          }
      }
    if (points.size() < 4 || (ends_ && at != place))
      return {};
    return {begin, std::move(points), std::move(along)};
  }


  void
  SectionsSurface::refuse_jump(const double place) const
  {
    for (const Jump &jump : jumps_)
      if (place > jump.begin && place < jump.end)
        throw InputError(path_ + ": the place " + in_mm(place) + " lies between slices " +
                         std::to_string(jump.slice) + " and " + std::to_string(jump.slice + 1) +
                         ", where the arc length jumps from " + in_mm(jump.before) + " to " +
                         in_mm(jump.behind) + "; features have to tell which part begins there");
  }
} // namespace wheelrail
