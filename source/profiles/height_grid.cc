#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/profiles/height_grid.h>
#include <wheelrail/profiles/height_noise.h>
#include <wheelrail/profiles/profile_text.h>
#include <wheelrail/tables/table.h>
#include <wheelrail/tables/text_rows.h>

#include <gsl/gsl_spline.h>
#include <gsl/gsl_spline2d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>

namespace wheelrail
{
  namespace
  {
    constexpr double largest_height = 5e-3;                     // as Irregularity/Depth
    constexpr double farthest_along = 1e6, farthest_across = 1; // [m]

    std::string
    in_millimetres(const double value)
    {
      return text("%.6g mm", 1e3 * value);
    }

    /// Different values, ascending; those closer than 1 nm are one.
    std::vector<double>
    different(std::vector<double> values)
    {
      constexpr double same = 1e-9;
      std::sort(values.begin(), values.end());
      std::vector<double> result;
      for (const double value : values)
        if (result.empty() || value - result.back() > same)
          result.push_back(value);
      return result;
    }

    std::size_t
    index_of(const std::vector<double> &values, const double value)
    {
      const auto after = std::lower_bound(values.begin(), values.end(), value - 1e-9);
      return static_cast<std::size_t>(after - values.begin());
    }

    void
    require_enough(const HeightGrid &grid, const std::string &path)
    {
      if (grid.along.size() < 4)
        throw InputError(path + ": " + counted(grid.along.size(), "place") +
                         " along; a line or a grid needs at least 4");
      if (!grid.across.empty() && grid.across.size() < 4)
        throw InputError(path + ": " + counted(grid.across.size(), "place") +
                         " across; a grid needs at least 4, a line has no column across");
    }

    HeightGrid
    read_grid(const std::string &path)
    {
      const Table table = read_table(
        path,
        {{"along", Dimension::length, -farthest_along, farthest_along, "-1000 km to 1000 km", true},
         {"across", Dimension::length, -farthest_across, farthest_across, "-1 m to 1 m"},
         {"height", Dimension::length, -largest_height, largest_height, "-5 mm to 5 mm", true}},
        {"heights are rows under names such as along_mm, across_mm (not of a line), height_um",
         true,
         {},
         "#%!",
         ""});
      const std::vector<double> &along = *table.find(0), &height = *table.find(2);
      const std::vector<double> *across = table.find(1);
      HeightGrid grid{different(along), across ? different(*across) : std::vector<double>(), {}, table.notes};
      require_enough(grid, path);
      const std::size_t         n = grid.along.size(), m = std::max<std::size_t>(1, grid.across.size());
      std::vector<unsigned int> from(n * m, 0);
      grid.height.resize(n * m);
      for (std::size_t row = 0; row < height.size(); ++row)
        {
          const std::size_t k =
            index_of(grid.along, along[row]) + n * (across ? index_of(grid.across, (*across)[row]) : 0);
          if (from[k] > 0)
            throw InputError(place(path, table.lines[row]) + "the same place as in line " +
                             std::to_string(from[k]) + "; one row for each place is needed");
          from[k]        = table.lines[row];
          grid.height[k] = height[row];
        }
      if (const auto hole = std::find(from.begin(), from.end(), 0u); hole != from.end())
        {
          const auto k = static_cast<std::size_t>(hole - from.begin());
          throw InputError(path + ": no row for along = " + in_millimetres(grid.along[k % n]) +
                           (across ? ", across = " + in_millimetres(grid.across[k / n]) : "") + " (" +
                           std::to_string(std::count(from.begin(), from.end(), 0u)) + " of " +
                           std::to_string(n * m) + " are missing); fill the holes of the grid");
        }
      return grid;
    }

    bool
    is_hdf5(const std::string &path)
    {
      const std::size_t dot    = path.rfind('.');
      const std::string ending = dot == std::string::npos ? "" : lower(path.substr(dot));
      return ending == ".h5" || ending == ".hdf5";
    }

    /// A dataset of numbers whose name tells its unit [m].
    std::vector<double>
    lengths_of(const hid_t file, const std::string &path, const std::string &quantity)
    {
      for (const auto &[ending, unit] : {std::make_pair("_mm", 1e-3), {"_m", 1.}, {"_um", 1e-6}})
        if (H5Lexists(file, (quantity + ending).c_str(), H5P_DEFAULT) > 0)
          {
            std::vector<double> values = hdf5::read_dataset(file, quantity + ending);
            for (double &value : values)
              value *= unit;
            return values;
          }
      throw InputError(path + ": no dataset " + quantity +
                       "_mm (or _m, _um); along_mm, across_mm and height_um are needed");
    }

    /// Throws InputError where places are no numbers, far out or in no order.
    void
    check_places(const std::vector<double> &places, const double most, const std::string &path)
    {
      for (const double place : places)
        if (!(std::abs(place) <= most))
          throw InputError(path + ": a place at " + in_millimetres(place) + "; " + in_millimetres(-most) +
                           " to " + in_millimetres(most) + " is accepted there");
      if (std::adjacent_find(places.begin(), places.end(), std::greater_equal<double>()) != places.end())
        throw InputError(path + ": the places along or across do not ascend");
    }

    /// Throws InputError where the rows of a dataset are not those of the places across, and notes where
    /// their number does not tell.
    void
    check_shape(const hid_t file, const std::string &name, HeightGrid &grid, const std::string &path)
    {
      const std::size_t    n = grid.along.size(), m = grid.across.size();
      const hdf5::Handle   set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "read " + name);
      const hdf5::Handle   space(H5Dget_space(set), H5Sclose, "read " + name);
      std::vector<hsize_t> shape(std::max(0, H5Sget_simple_extent_ndims(space)));
      H5Sget_simple_extent_dims(space, shape.data(), nullptr);
      if (shape.size() == 2 && shape[0] != m)
        throw InputError(path + ": " + name + " has " + std::to_string(shape[0]) + " rows of " +
                         std::to_string(shape[1]) + " heights for " + std::to_string(m) +
                         " places across and " + std::to_string(n) +
                         " along; a row for each place across is needed: exchange rows and columns");
      if (shape.size() != 2 || n == m)
        grid.notes.push_back(path + ": each " + std::to_string(n) + " heights of " + name +
                             " are taken as those along at one place across");
    }

    /// The same of all heights.
    void
    check_rows(const hid_t file, HeightGrid &grid, const std::string &path)
    {
      const std::size_t n = grid.along.size(), m = grid.across.size();
      if (grid.height.size() != n * m)
        throw InputError(path + ": " + std::to_string(grid.height.size()) + " heights for " +
                         std::to_string(m) + " x " + std::to_string(n) +
                         " places; a row for each place across is needed");
      for (const char *name : {"height_mm", "height_m", "height_um"})
        if (H5Lexists(file, name, H5P_DEFAULT) > 0)
          return check_shape(file, name, grid, path);
    }

    HeightGrid
    read_datasets(const std::string &path)
    {
      const hdf5::Quiet quiet;
      try
        {
          const std::string  bytes = read_whole_file(path);
          const hdf5::Handle file(
            hdf5::open_in_memory(bytes), H5Fclose, "read " + path + ": it is no HDF5 file, or not complete");
          HeightGrid grid{lengths_of(file, path, "along"),
                          lengths_of(file, path, "across"),
                          lengths_of(file, path, "height"),
                          {}};
          require_enough(grid, path);
          check_places(grid.along, farthest_along, path);
          check_places(grid.across, farthest_across, path);
          check_rows(file, grid, path);
          for (const double height : grid.height)
            if (!std::isfinite(height))
              throw InputError(path + ": a height that is no number; fill the holes of the grid");
            else if (std::abs(height) > largest_height)
              throw InputError(path + ": a height of " + in_millimetres(height) +
                               "; -5 mm to 5 mm is accepted");
          return grid;
        }
      catch (const RunError &error)
        {
          throw InputError(error.what());
        }
    }

    std::function<IrregularHeight(double, double)>
    line_spline(const HeightGrid &line)
    {
      const std::shared_ptr<gsl_spline> spline(gsl_spline_alloc(gsl_interp_cspline, line.along.size()),
                                               gsl_spline_free);
      gsl_spline_init(spline.get(), line.along.data(), line.height.data(), line.along.size());
      return [spline, low = line.along.front(), high = line.along.back()](const double, const double u) {
        const double at = std::clamp(u, low, high);
        return IrregularHeight{
          gsl_spline_eval(spline.get(), at, nullptr), 0, gsl_spline_eval_deriv(spline.get(), at, nullptr)};
      };
    }

    std::function<IrregularHeight(double, double)>
    grid_spline(const HeightGrid &grid)
    {
      const std::shared_ptr<gsl_spline2d> spline(
        gsl_spline2d_alloc(gsl_interp2d_bicubic, grid.along.size(), grid.across.size()), gsl_spline2d_free);
      gsl_spline2d_init(spline.get(),
                        grid.along.data(),
                        grid.across.data(),
                        grid.height.data(),
                        grid.along.size(),
                        grid.across.size());
      const double u0 = grid.along.front(), u1 = grid.along.back(), v0 = grid.across.front(),
                   v1 = grid.across.back();
      return [spline, u0, u1, v0, v1](const double across, const double along) {
        const double    u = std::clamp(along, u0, u1), v = std::clamp(across, v0, v1);
        IrregularHeight h;
        h.height = gsl_spline2d_eval(spline.get(), u, v, nullptr, nullptr);
        h.along  = gsl_spline2d_eval_deriv_x(spline.get(), u, v, nullptr, nullptr);
        h.across = v == across ? gsl_spline2d_eval_deriv_y(spline.get(), u, v, nullptr, nullptr) : 0;
        return h;
      };
    }

    /// A line of heights over the places along that goes on beyond its ends.
    struct EndlessLine
    {
      const std::vector<double> &along;
      const double              *height;
      double                     circumference; ///< 0: the heights of the ends hold

      Point2
      operator()(const std::ptrdiff_t k) const
      {
        const auto n = static_cast<std::ptrdiff_t>(along.size());
        if (k >= 0 && k < n)
          return {along[k], height[k]};
        if (circumference > 0)
          return {along[(k + n) % n] + (k < 0 ? -circumference : circumference), height[(k + n) % n]};
        const double step = (along.back() - along.front()) / (n - 1);
        return k < 0 ? Point2{along.front() + k * step, height[0]}
                     : Point2{along.back() + (k - n + 1) * step, height[n - 1]};
      }
    };

    /// By how much the slope changes from the places before `a` to those behind `b`, each `step` places
    /// apart, less what it changes beside them over the same length.
    double
    jump_between(const EndlessLine   &line,
                 const std::ptrdiff_t a,
                 const std::ptrdiff_t b,
                 const std::ptrdiff_t step)
    {
      struct Slope
      {
        double at, value;
      };
      const auto slope = [&](const std::ptrdiff_t from) {
        const Point2 p = line(from), q = line(from + step);
        return Slope{0.5 * (p.x + q.x), (q.y - p.y) / (q.x - p.x)};
      };
      const Slope before = slope(a - 2 * step), behind = slope(a - step), ahead = slope(b),
                  beyond = slope(b + step);
      return ahead.value - behind.value -
             0.5 * (ahead.at - behind.at) *
               ((beyond.value - ahead.value) / (beyond.at - ahead.at) +
                (behind.value - before.value) / (behind.at - before.at));
    }

    /// The jump between places k and k + 1 as their distance goes to nothing. 0 where it differs by more than
    /// a fifth from that over the distance itself: beside a kink, and where the surface is round.
    double
    remaining_jump(const EndlessLine &line, const std::ptrdiff_t k)
    {
      const double jump = jump_between(line, k, k + 1, 1), one = jump_between(line, k, k + 2, 2),
                   other     = jump_between(line, k - 1, k + 1, 2),
                   remaining = 2 * jump - (jump > 0 ? std::max(one, other) : std::min(one, other));
      return std::abs(remaining - jump) < 0.2 * std::abs(jump) ? remaining : 0;
    }
  } // namespace


  HeightGrid
  read_height_file(const std::string &path)
  {
    HeightGrid grid = is_hdf5(path) ? read_datasets(path) : read_grid(path);
    find_noise(grid);
    if (grid.noise > 0)
      grid.notes.push_back("noise of " + text("%.2g um", 1e6 * grid.noise) +
                           " found in the heights smoothed");
    return grid;
  }


  Irregularity
  grid_irregularity(const HeightGrid &grid,
                    const double      place,
                    const double      lateral,
                    const double      circumference)
  {
    const auto   heights = grid.across.empty() ? line_spline(grid) : grid_spline(grid);
    Irregularity shape;
    shape.begin = place + grid.along.front();
    shape.end   = place + grid.along.back();
    // a wheel measured all around: the gap between last and first point is closed by the ends
    shape.endless = circumference > 0 && shape.end - shape.begin > 0.99 * circumference;
    shape.kinks   = kinks_of(grid, shape.endless ? circumference : 0);
    for (Kink &kink : shape.kinks)
      kink.along += place;
    shape.at = [heights, place, lateral](const double across, const double along) {
      return heights(across - lateral, along - place);
    };
    double widest = 0;
    for (std::size_t k = 1; k < grid.along.size(); ++k)
      widest = std::max(widest, grid.along[k] - grid.along[k - 1]);
    shape.shortest = 8 * widest;
    return shape;
  }


  Irregularity
  measured_irregularity(const HeightGrid &grid,
                        const double      place,
                        const double      lateral,
                        const double      circumference)
  {
    if (!(grid.noise > 0))
      return grid_irregularity(grid, place, lateral, circumference);
    const auto shape_of = [=](const unsigned int draw) {
      return grid_irregularity(
        smoothed_heights(with_noise(grid, false, draw)), place, lateral, circumference);
    };
    Irregularity shape = shape_of(0);
    shape.drawn        = [shape_of](const unsigned int draw) { return shape_of(draw).at; };
    return shape;
  }


  double
  largest_end(const HeightGrid &grid)
  {
    const std::size_t n       = grid.along.size();
    double            largest = 0;
    for (std::size_t k = 0; k < grid.height.size(); k += n)
      largest = std::max({largest, std::abs(grid.height[k]), std::abs(grid.height[k + n - 1])});
    return largest;
  }


  std::vector<Kink>
  kinks_of(const HeightGrid &grid, const double circumference)
  {
    constexpr double least = 1e-3; // [rad], adds 1 % to 1200 MPa with each halving
    // four standard deviations of remaining_jump() times the step [m]; digits of a file are noise, too
    const double                   noise = 48 * std::max(grid.noise, 2e-8);
    const auto                     n     = static_cast<std::ptrdiff_t>(grid.along.size());
    std::map<std::ptrdiff_t, Kink> found;
    if (n < 8) // too few to tell a kink from a round shape
      return {};
    for (const double *row = grid.height.data(); row != grid.height.data() + grid.height.size(); row += n)
      {
        const EndlessLine line{grid.along, row, circumference};
        for (std::ptrdiff_t k = -1; k < n; ++k)
          {
            const double from = line(k).x, to = line(k + 1).x;
            if (std::abs(remaining_jump(line, k)) > std::max(least, noise / (to - from)))
              found[k] = {0.5 * (from + to), to - from};
          }
      }
    std::vector<Kink> kinks;
    for (const auto &[unused, kink] : found)
      kinks.push_back(kink);
    return kinks;
  }
} // namespace wheelrail
