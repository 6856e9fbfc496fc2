#include <wheelrail/base/errors.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/profiles/height_noise.h>
#include <wheelrail/tables/table.h>
#include <wheelrail/tables/text_rows.h>
#include <wheelrail/wheel/given_distance.h>
#include <wheelrail/wheel/halfspace_parts.h>
#include <wheelrail/wheel/roller_distance.h>
#include <wheelrail/wheel/wheel_load.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// The surfaces before they deform.
    struct GivenSurfaces
    {
      std::function<double(double, double)> distance;                               ///< of x, y [m]
      double                                x_min, x_max, y_min, y_max;             ///< where it is known [m]
      double                                radius_along, radius_across;            ///< for a first guess [m]
      double                                lowest = 0, lowest_x = 0, lowest_y = 0; ///< [m]
      double                                width =
        0; ///< of a body that ends at its sides, in the middle of which y = 0 lies; 0: it does not
      std::function<double(double)> middle = {}; ///< height of the surfaces over y [m]; none: flat
      std::vector<std::string>      notes  = {}; ///< of files
    };

    GivenSurfaces
    rollers_of(const Scene &scene)
    {
      constexpr double far = 0.1, beside = 0.02; // farther than any approach; room for elements beside [m]
      const RollerDistance rollers = roller_distance(scene);
      const double         R       = rollers.radius_along;
      return {[rollers](const double x, const double y) {
                return x * x / (2 * rollers.radius_along) +
                       (y < rollers.low || y > rollers.high ? far : rollers.across(y));
              },
              -0.5 * R,
              0.5 * R,
              rollers.low - beside,
              rollers.high + beside,
              R,
              rollers.radius_across,
              rollers.lowest,
              0,
              rollers.lowest_at,
              scene.roller_width,
              rollers.middle,
              rollers.notes};
    }

    /// The distance of a file.
    GivenSurfaces
    surfaces_of(const Scene &scene, const DistanceTable &table)
    {
      const auto        lowest = std::min_element(table.distance.begin(), table.distance.end());
      const std::size_t k      = std::size_t(lowest - table.distance.begin());
      GivenSurfaces     surfaces{{},
                             table.x.front(),
                             table.x.back(),
                             table.y.front(),
                             table.y.back(),
                             scene.halfspace_radius_along,
                             scene.halfspace_radius_across,
                             *lowest,
                             table.x[k % table.x.size()],
                             table.y[k / table.x.size()]};
      surfaces.distance = [table](const double x, const double y) { return table.at(x, y); };
      return surfaces;
    }

    /// That of Hertz or of rollers.
    GivenSurfaces
    surfaces_of(const Scene &scene)
    {
      const double Rx = scene.halfspace_radius_along, Ry = scene.halfspace_radius_across;
      if (scene.halfspace_distance == "rollers")
        return rollers_of(scene);
      return {[Rx, Ry](const double x, const double y) { return x * x / (2 * Rx) + y * y / (2 * Ry); },
              -0.5 * Rx,
              0.5 * Rx,
              -0.5 * Ry,
              0.5 * Ry,
              Rx,
              Ry};
    }

    DistanceTable
    table_of(const Scene &scene)
    {
      try
        {
          return read_distance_file(scene.halfspace_distance);
        }
      catch (const InputError &error)
        {
          throw InputError(std::string("Half-space/Undeformed distance: ") + error.what());
        }
    }

    /// A grid over the places whose distance is below the lowest plus `approach`, with two elements around,
    /// within what is known.
    HalfspaceGrid
    grid_below(const GivenSurfaces &surfaces, const double approach, const double h)
    {
      double x0 = surfaces.lowest_x, x1 = x0, y0 = surfaces.lowest_y, y1 = y0;
      // a patch is convex enough to be found ring by ring, each a quarter wider than the last
      for (double reach = h;
           reach < std::max(surfaces.x_max - surfaces.x_min, surfaces.y_max - surfaces.y_min);
           reach *= 1.25)
        {
          bool inside = false;
          for (int k = 0; k < 720; ++k)
            {
              const double x = surfaces.lowest_x + reach * std::cos(k * M_PI / 360),
                           y = surfaces.lowest_y + reach * std::sin(k * M_PI / 360);
              if (x < surfaces.x_min || x > surfaces.x_max || y < surfaces.y_min || y > surfaces.y_max ||
                  surfaces.distance(x, y) - surfaces.lowest > approach)
                continue;
              inside = true;
              x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
            }
          if (!inside && reach > 4 * h)
            break;
        }
      const auto index = [h](const double value) { return int(std::floor(value / h)); };
      // a fifth of the extent more on either side: the patch of a given force is found only roughly
      const int i0 = std::max(index(1.2 * x0 - 0.2 * x1) - 2, index(surfaces.x_min) + 1),
                i1 = std::min(index(1.2 * x1 - 0.2 * x0) + 3, index(surfaces.x_max)),
                j0 = std::max(index(1.2 * y0 - 0.2 * y1) - 2, index(surfaces.y_min) + 1),
                j1 = std::min(index(1.2 * y1 - 0.2 * y0) + 3, index(surfaces.y_max));
      return {i1 - i0 + 1, j1 - j0 + 1, h, h, i0 * h, j0 * h};
    }

    /// By how much the surfaces turn from one side of the patch to the other [rad].
    double
    turn_across(const GivenSurfaces &surfaces, const HalfspaceSolution &solution)
    {
      if (!surfaces.middle)
        return 0;
      double least = HUGE_VAL, largest = -HUGE_VAL;
      for (int j = 0; j < solution.grid.my; ++j)
        for (int i = 0; i < solution.grid.mx; ++i)
          if (solution.pressure[i + solution.grid.mx * j] > 0)
            {
              const double y = solution.grid.y(j), step = 0.5 * solution.grid.dy;
              const double slope = (surfaces.middle(y + step) - surfaces.middle(y - step)) / (2 * step);
              least              = std::min(least, std::atan(slope));
              largest            = std::max(largest, std::atan(slope));
            }
      return std::max(0., largest - least);
    }

    /// The normal problem, on a grid that is enlarged until the contact keeps off its edge or all that is
    /// known of the surfaces is covered.
    HalfspaceSolution
    solve_normal_problem(const Scene                       &scene,
                         const GivenSurfaces               &surfaces,
                         HalfspaceProblem                  &problem,
                         int                               &enlargements,
                         std::shared_ptr<HalfspaceKernels> &kernels)
    {
      const double E = contact_modulus(scene), R = std::sqrt(surfaces.radius_along * surfaces.radius_across);
      const double approach = problem.force_given
                                ? std::cbrt(9 * std::pow(problem.normal_force / E, 2) / (16 * R))
                                : problem.approach;
      const auto   lay_grid = [&](const double reached, const double wanted) {
        // sides lie between elements, one of which lies in the middle
        const double element = surfaces.width > 0
                                   ? surfaces.width / (2 * std::ceil(0.5 * surfaces.width / wanted - 0.5) + 1)
                                   : wanted;
        problem.grid         = grid_below(surfaces, reached, element);
        problem.undeformed_distance.clear();
        for (int j = 0; j < problem.grid.my; ++j)
          for (int i = 0; i < problem.grid.mx; ++i)
            problem.undeformed_distance.push_back(surfaces.distance(problem.grid.x(i), problem.grid.y(j)) -
                                                  surfaces.lowest);
      };
      return solve_on_growing_grid(
        problem, approach, scene.halfspace_element_size, 8, lay_grid, enlargements, kernels);
    }

    /// What the noise of a file's distances, or the rounding of their last digit, may change: twice the root
    /// mean square of what one more draw of it changes.
    NoiseEffect
    noise_effect(const Scene &scene, const DistanceTable &table, HalfspaceProblem problem)
    {
      constexpr unsigned int draws = 6;
      HeightGrid             grid{table.x, table.y, table.distance, {}, 0};
      find_noise(grid);
      if (grid.noise == 0)
        return {0, 0, 0, 0, 0};
      const auto results = [&](const unsigned int draw) {
        const DistanceTable               drawn{table.x, table.y, with_noise(grid, false, draw).height};
        std::shared_ptr<HalfspaceKernels> kernels;
        int                               enlargements = 0;
        const HalfspaceSolution           solution =
          solve_normal_problem(scene, surfaces_of(scene, drawn), problem, enlargements, kernels);
        const PatchMeasures m = measure_patch(halfspace_patch(solution));
        return std::array<double, 5>{m.peak_pressure, m.area, m.width, m.length, solution.approach};
      };
      const std::array<double, 5> given = results(0);
      std::array<double, 5>       squares{};
      for (unsigned int draw = 1; draw <= draws; ++draw)
        {
          const std::array<double, 5> other = results(draw);
          for (std::size_t k = 0; k < squares.size(); ++k)
            squares[k] += std::pow(other[k] / given[k] - 1, 2);
        }
      const auto share = [&](const std::size_t k) { return 2 * std::sqrt(squares[k] / draws); };
      return {share(0), share(1), share(2), share(3), share(4)};
    }
  } // namespace


  bool
  distance_is_given(const HalfspaceSettings &scene)
  {
    return scene.halfspace_distance != "profiles";
  }


  bool
  needs_profiles(const HalfspaceSettings &scene)
  {
    return !distance_is_given(scene) || (scene.halfspace_distance != "rollers" &&
                                         scene.halfspace_normal_force == 0 && scene.halfspace_approach == 0);
  }


  WheelRailSolution
  solve_given_distance(const Scene &scene, const SceneGeometry *geometry)
  {
    const auto begin = std::chrono::steady_clock::now();
    if (scene.halfspace_normal_force > 0 && scene.halfspace_approach > 0)
      throw InputError(
        "Half-space/Normal force and Half-space/Approach are both given; one follows from the "
        "other: set one of them to auto");
    if (!geometry && scene.halfspace_normal_force == 0 && scene.halfspace_approach == 0)
      throw InputError(
        "Half-space/Normal force = auto: no wheel load presses rollers together; give the force, or "
        "Half-space/Approach");
    if (std::isfinite(scene.track_radius))
      throw InputError(
        "Track/Radius: without effect where Half-space/Undeformed distance is not that of the profiles; give "
        "Half-space/Given spin, or set Undeformed distance = profiles");
    if (scene.yaw != 0)
      throw InputError(
        "Wheelset/Yaw: without effect where Half-space/Undeformed distance is not that of the "
        "profiles; give Wheelset/Lateral creepage (about minus the yaw in rad), or set "
        "Undeformed distance = profiles");
    const bool of_file        = scene.halfspace_distance != "hertz" && scene.halfspace_distance != "rollers";
    const DistanceTable table = of_file ? table_of(scene) : DistanceTable();
    const GivenSurfaces surfaces = of_file ? surfaces_of(scene, table) : surfaces_of(scene);
    WheelRailSolution   result;
    HalfspaceProblem   &problem = result.problem;
    problem                     = halfspace_problem(scene);
    problem.force_given         = scene.halfspace_approach == 0;
    problem.approach            = scene.halfspace_approach;
    if (problem.force_given)
      problem.normal_force = scene.halfspace_normal_force > 0 ? scene.halfspace_normal_force
                                                              : static_wheel_load(scene, geometry->wheel);

    std::shared_ptr<HalfspaceKernels> kernels;
    const HalfspaceSolution           normal =
      solve_normal_problem(scene, surfaces, problem, result.enlargements, kernels);
    if (of_file)
      result.noise_effect = noise_effect(scene, table, problem);
    problem.motion                   = HalfspaceMotion::steady;
    problem.phi                      = std::isfinite(scene.halfspace_given_spin)
                                         ? scene.halfspace_given_spin
                                         : std::sin(scene.halfspace_contact_angle) / surfaces.radius_along;
    problem.eta                      = -lateral_creepage(scene);
    problem.longitudinal_force_given = scene.drive == Drive::torque;
    problem.fx                       = -scene.traction_coefficient * normal.fn;
    problem.xi                       = scene.drive == Drive::rate ? scene.creepage : 0;
    result.solution                  = solve_carried(problem, kernels);
    if (!result.solution.within_friction)
      {
        problem.longitudinal_force_given = false;
        problem.xi                       = result.solution.xi;
      }
    result.spin     = problem.phi;
    result.turn     = turn_across(surfaces, normal);
    result.notes    = surfaces.notes;
    result.vertical = result.solution.fn;
    result.lateral  = -result.solution.fy;
    result.patch    = halfspace_patch(result.solution);
    result.measures = measure_patch(result.patch);
    result.time     = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
  }


  namespace
  {
    /// The different values of one coordinate, growing; steps must be even.
    std::vector<double>
    lines_of(std::vector<double> values, const std::string &path, const char *name)
    {
      std::sort(values.begin(), values.end());
      const double        span = values.empty() ? 0 : values.back() - values.front();
      std::vector<double> lines;
      for (const double value : values)
        if (lines.empty() || value - lines.back() > 1e-6 * span)
          lines.push_back(value);
      if (lines.size() < 4)
        throw InputError(path + ": " + std::to_string(lines.size()) + " values of " + name +
                         "; a grid of at least 4 x 4 points is needed");
      const double step = span / double(lines.size() - 1);
      for (std::size_t k = 0; k < lines.size(); ++k)
        if (std::abs(lines[k] - lines[0] - double(k) * step) > 0.01 * step)
          throw InputError(path + ": the values of " + name + " have no even steps near " +
                           std::to_string(1e3 * lines[k]) + " mm; a regular grid is needed");
      return lines;
    }

    std::size_t
    place_of(const std::vector<double> &lines, const double value)
    {
      const double step = (lines.back() - lines.front()) / double(lines.size() - 1);
      return std::size_t(std::lround((value - lines.front()) / step));
    }
    /// Weights of the cubic through four neighbouring lines at a place, and the first of them.
    std::array<double, 4>
    cubic_weights(const std::vector<double> &lines, const double place, std::size_t &first)
    {
      const double step       = (lines.back() - lines.front()) / double(lines.size() - 1);
      const double t          = std::clamp((place - lines.front()) / step, 0., double(lines.size() - 1));
      first                   = std::min(std::size_t(std::max(0., std::floor(t) - 1)), lines.size() - 4);
      const double          z = t - double(first);
      std::array<double, 4> weights{1, 1, 1, 1};
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b)
          if (a != b)
            weights[a] *= (z - b) / (a - b);
      return weights;
    }
  } // namespace


  double
  DistanceTable::at(const double place_x, const double place_y) const
  {
    std::size_t                 i = 0, j = 0;
    const std::array<double, 4> u = cubic_weights(x, place_x, i), v = cubic_weights(y, place_y, j);
    double                      sum = 0;
    for (std::size_t b = 0; b < 4; ++b)
      for (std::size_t a = 0; a < 4; ++a)
        sum += u[a] * v[b] * distance[i + a + x.size() * (j + b)];
    return sum;
  }


  DistanceTable
  read_distance_file(const std::string &path)
  {
    const Table rows =
      read_table(path,
                 {{"x", Dimension::length, -1e3, 1e3, "-1 km to 1 km", true},
                  {"y", Dimension::length, -1e3, 1e3, "-1 km to 1 km", true},
                  {"distance", Dimension::length, -1e3, 1e3, "-1 km to 1 km", true}},
                 {"rows x, y, distance in mm are needed", false, {}, "#", "x_mm,y_mm,distance_mm"});
    const std::vector<double> &x = *rows.find(0), &y = *rows.find(1), &distance = *rows.find(2);
    DistanceTable              table{lines_of(x, path, "x"), lines_of(y, path, "y"), {}};
    std::vector<unsigned int>  from(table.x.size() * table.y.size(), 0);
    table.distance.resize(from.size());
    for (std::size_t row = 0; row < x.size(); ++row)
      {
        const std::size_t k = place_of(table.x, x[row]) + table.x.size() * place_of(table.y, y[row]);
        if (from[k] > 0)
          throw InputError(place(path, rows.lines[row]) + "the same place as in line " +
                           std::to_string(from[k]) + "; one row for each point is needed");
        from[k]           = rows.lines[row];
        table.distance[k] = distance[row];
      }
    const auto missing = std::find(from.begin(), from.end(), 0u);
    if (missing != from.end())
      {
        const auto k = std::size_t(missing - from.begin());
        throw InputError(path + ": no row for x = " + std::to_string(1e3 * table.x[k % table.x.size()]) +
                         " mm, y = " + std::to_string(1e3 * table.y[k / table.x.size()]) +
                         " mm; one row for each point of the grid is needed");
      }
    return table;
  }
} // namespace wheelrail
