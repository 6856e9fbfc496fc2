#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/kept_tables.h>
#include <wheelrail/bodies/placed_bodies.h>
#include <wheelrail/halfspace/added_influence.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/wheel/contact_reference.h>
#include <wheelrail/wheel/halfspace_parts.h>

#include <algorithm>
#include <chrono>
#include <cmath>

// One wheel on one rail as true bodies (doc/theory/bodies.md, Contact). One round: 1. load and force that the
// solver gets, with what tractions carry of them; 2. rigid slip, less u_Y/r of the tread; 3. half-space
// problem with the remainder R; 4. u_Y of the wheel's surface; 5. rows moved by (5) and (6). The rail is body
// 1: x forwards, y along its profile to the track centre, n into the rail; angle a of a row against X, e_s =
// (cos a, sin a), normal out of the rail (-sin a, cos a).

namespace wheelrail
{
  namespace
  {
    // changes between rounds: of the rigid slip, of pressures over their peak
    constexpr double slip_settled = 1e-7, pressure_settled = 2e-4;
  } // namespace


  BodyContact::BodyContact(const Scene &scene, const SceneGeometry &geometry, const BodyTables &tables)
    : geometry_(geometry)
    , tables_(tables)
    , sections_(geometry, {}, whole_region(geometry.contact))
    , motion_(wheel_motion(scene, geometry.contact))
    , element_(scene.halfspace_element_size)
    , rate_(scene.velocity / geometry.contact.rolling_radius)
    , problem_(halfspace_problem(scene))
  {
    // y = 0 of the grid: the first contact point, on the rail's own profile
    const Curve &head    = geometry.rail.head;
    first_               = head.closest(geometry.contact.rail.to_section(geometry.contact.frame.origin));
    first_arc_           = head.length(0, first_);
    problem_.force_given = true;
    problem_.motion      = HalfspaceMotion::steady;
    tolerance_           = problem_.tangential_tolerance;
    // gaps up to 1.5 times the expected approach lie on the grid
    reached_ = 1.5 * expected_approach(scene, geometry.contact.rolling_radius);
  }


  void
  BodyContact::set_bodies()
  {
    // rows of elements have equal arcs on the rail; those on the wheel and the angles are what the profiles
    // make of them
    std::vector<PlacedRow> rows;
    for (std::size_t j = 0; j < rows_.size(); ++j)
      rows.push_back({rows_[j].rail_arc, rows_[j].wheel_arc, rows_[j].angle, problem_.grid.y(j)});
    const double       step   = problem_.step > 0 ? problem_.step : problem_.grid.dx;
    const PlacedBodies placed = place_bodies(tables_, geometry_.contact, rows, problem_.grid, step);
    added_                    = added_influence(placed, problem_.grid, step);
    // rows of elements keep these influences while they move by tenths of a millimetre
    contact_rows_                = placed.rows;
    growth_                      = growth(tables_.wheel, placed.placements[1], placed.rows[1], rate_);
    problem_.added               = added_;
    HalfspaceProblem wheel_alone = problem_;
    // a rigid rail: displacement differences are then those of the wheel alone
    wheel_alone.body1.shear_modulus *= 1e12;
    wheel_kernels_ = std::make_shared<HalfspaceKernels>(wheel_alone);
  }


  void
  BodyContact::set_slip()
  {
    const HalfspaceGrid &grid = problem_.grid;
    // slip of rigid bodies in the rows' present places; the stretch of the tread comes on top in
    // solve_round()
    own_slip_.assign(grid.size(), 0.);
    problem_.rigid_slip_y.assign(grid.size(), 0.);
    // CONTACT counts the spin dq/6 upstream of the centre; across, where the rolling circle comes down,
    // likewise
    const double offset = problem_.spin_offset * grid.dx;
    for (int j = 0; j < grid.my; ++j)
      {
        const Row &row = rows_[j];
        if (!row.touches)
          continue;
        const RowSlip slip = row_slip(row.slice, motion_, problem_.xi);
        for (int i = 0; i < grid.mx; ++i)
          {
            // w_x, w_s of each row (rail as body 1), without the stretch of the tread
            own_slip_[i + grid.mx * j]             = slip.along;
            problem_.rigid_slip_y[i + grid.mx * j] = slip.lateral_at(grid.x(i) + offset);
          }
      }
  }


  std::vector<double>
  BodyContact::wheel_rise(const RowsInfluence::Given &t) const
  {
    const HalfspaceGrid &grid = problem_.grid;
    std::vector<double>  rise(grid.size(), 0.);
    // y and n of the wheel's half-space
    // with a rigid rail the difference, body 1 less body 2, is minus the wheel's own displacement
    const auto own    = displacements(*wheel_kernels_, {1, 2}, t);
    const auto beyond = added_->fixed_displacement(1, t);
    for (int j = 0; j < grid.my; ++j)
      {
        const double c = std::cos(rows_[j].angle), s = std::sin(rows_[j].angle);
        for (int e = grid.mx * j; e < grid.mx * (j + 1); ++e)
          // u_Y of the wheel's surface, up: of the half-space (n points down into the rail, body 1 less body
          // 2 is minus the wheel's own), growth, remainder (tractions on the wheel are minus those on the
          // rail)
          rise[e] = c * own[1][e] - s * own[0][e] + growth_[j].y - beyond[1][e];
      }
    return rise;
  }


  RowsInfluence::Given
  BodyContact::tractions() const
  {
    return {{&solution_.traction_x, &solution_.traction_y, &solution_.pressure}};
  }


  double
  BodyContact::stretch_of_tread() const
  {
    // e of doc/theory/rolling.md, Static start, by pressure alone: the same number from the bodies' own
    // tables
    const HalfspaceGrid      &grid = problem_.grid;
    const std::vector<double> none(grid.size(), 0.), rise = wheel_rise({{&none, &none, &solution_.pressure}});
    std::vector<double>       slip(grid.size(), 0.);
    added_->add_slip({{nullptr, nullptr, &solution_.pressure}}, {{&slip, nullptr, nullptr}});
    // the slope of least squares of a displacement is the mean of its derivative, with weights that vanish at
    // both ends of a row
    double sum = 0, weights = 0;
    for (int j = 0; j < grid.my; ++j)
      {
        int first = grid.mx, last = -1;
        for (int i = 0; i < grid.mx; ++i)
          if (solution_.pressure[i + grid.mx * j] > 0)
            first = std::min(first, i), last = i;
        for (int i = first; i <= last; ++i)
          {
            const int e = i + grid.mx * j;
            // slope of least squares of u(x): sum (x - m)(u - mean)/sum (x - m)^2 = integral of u' times a
            // parabola, summed by parts
            const double weight = (i - first + 0.5) * (last - i + 0.5);
            // stretch of the tread e: (u - u')/dx of both bodies along the track, less u_Y/r of the wheel
            // that rolls on r - u_Y
            sum += weight * (slip[e] - rise[e] / rows_[j].slice.radius);
            weights += weight;
          }
      }
    return weights > 0 ? sum / weights : 0;
  }


  double
  BodyContact::solve_round(const WheelRailLoad &load)
  {
    const HalfspaceGrid &grid  = problem_.grid;
    const bool           first = solution_.grid.size() == 0;
    // what tractions across carry of the load
    // 1. Load and force for the solver, with the tractions of the round before
    double shear = 0;
    for (int j = 0; j < grid.my && !first; ++j)
      for (int i = 0; i < grid.mx; ++i)
        shear += std::sin(rows_[j].angle) * solution_.traction_y[i + grid.mx * j] * grid.element_area();
    // vertical: sum of (p cos a - t_y sin a) dA = load; the solver has the sum of p cos a
    problem_.normal_force             = vertical_load(load) + shear;
    const double yaw                  = load.along_track ? 0 : geometry_.contact.yaw;
    problem_.longitudinal_force_given = !load.rate_held;
    if (load.rate_held)
      problem_.xi = load.creepage;
    // longitudinal force along the track = fx cos(yaw) + lateral force sin(yaw), on the wheel: the rail as
    // body 1 has minus it
    // a load that slides asks for ten times what it has, so that friction's bound answers
    problem_.fx = load.slides
                    ? -std::copysign(10 * load.force, load.longitudinal)
                    : -(load.longitudinal - (first ? 0 : force().x) * std::sin(yaw)) / std::cos(yaw);
    // 2. Rigid slip
    set_slip();
    const std::vector<double> before = rise_;
    problem_.rigid_slip_x            = own_slip_;
    for (int j = 0; j < grid.my && !rise_.empty(); ++j)
      for (int i = 0; i < grid.mx; ++i)
        if (rows_[j].touches)
          // w_x = r omega/V - 1 with r - u_Y for r (doc/theory/bodies.md, slip along the track)
          problem_.rigid_slip_x[i + grid.mx * j] -= rise_[i + grid.mx * j] / rows_[j].slice.radius;
    // 3. Half-space problem with the remainder; in the first round pressure alone, without tractions to guess
    // from
    const HalfspaceSolution guess = solution_;
    if (first) // the pressure alone
      {
        HalfspaceProblem pressing = problem_;
        pressing.motion           = HalfspaceMotion::none;
        solution_                 = solve_rolling(pressing, kernels_);
      }
    else
      solution_ = solve_carried(problem_, kernels_, &guess);
    // the creepage found is the guess of the next round
    if (!first && solution_.within_friction)
      problem_.xi = solution_.xi;
    // 4. Rise of the tread; 5. how much has changed, and where rows move to
    rise_         = wheel_rise(tractions());
    double change = before.empty() ? 1 : 0;
    for (std::size_t e = 0; e < before.size(); ++e)
      if (solution_.pressure[e] > 0)
        // 1 where the largest change is just settled: du_Y/r of the slip, dp over the peak
        change = std::max({change,
                           std::abs(rise_[e] - before[e]) / (geometry_.contact.rolling_radius * slip_settled),
                           std::abs(solution_.pressure[e] - guess.pressure[e]) /
                             (solution_.peak_pressure * pressure_settled)});
    return std::max(change, move_rows());
  }


  double
  BodyContact::vertical_load(const WheelRailLoad &load) const
  {
    // a force along the normal of the first contact point has the vertical part F cos(angle)
    return load.vertical ? load.force : load.force * std::cos(geometry_.contact.frame.angle);
  }


  BodyLoads
  BodyContact::loads(const bool on_wheel) const
  {
    const HalfspaceGrid &grid = problem_.grid;
    const ContactRows   &rows = contact_rows_[on_wheel];
    BodyLoads            loads{rows.first, {}, {}};
    loads.forces.assign(rows.count, std::vector<Vector3>(grid.mx, Vector3{}));
    for (int i = 0; i < grid.mx; ++i)
      // forces of each row at each x, what body_pose() takes
      loads.along.push_back(grid.x(i));
    // each element's force goes to the rows of the table by the weights of added_influence.cc, so that the
    // sum of forces is kept
    const double side = on_wheel ? -1 : 1;
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i)
        if (const int e = i + grid.mx * j; solution_.pressure[e] > 0)
          {
            const auto   basis = row_basis(rows_[j].angle);
            const double t[3]  = {solution_.traction_x[e], solution_.traction_y[e], solution_.pressure[e]};
            Vector3      force{};
            for (int axis = 0; axis < 3; ++axis)
              for (int c = 0; c < 3; ++c)
                // tractions on the rail, and minus them on the wheel, in (X, Y, Z)
                force[axis] += side * grid.element_area() * basis[3 * axis + c] * t[c];
            for (int r = 0; r < rows.count; ++r)
              add(loads.forces[r][i], rows.weights[std::size_t(j) * rows.count + r], force);
          }
    return loads;
  }


  Point2
  BodyContact::force() const
  {
    Point2 sum;
    for (int j = 0; j < problem_.grid.my; ++j)
      {
        const double c = std::cos(rows_[j].angle), s = std::sin(rows_[j].angle);
        for (int i = 0; i < problem_.grid.mx; ++i)
          {
            const int    e = i + problem_.grid.mx * j;
            const double p = solution_.pressure[e], t = solution_.traction_y[e];
            // on the wheel: p along the rail's normal (-sin a, cos a), and -t_y along (cos a, sin a)
            sum = sum + Point2{-s * p - c * t, c * p - s * t};
          }
      }
    return problem_.grid.element_area() * sum;
  }


  WheelsetForces
  BodyContact::forces_on_wheelset() const
  {
    std::vector<RowOfElements> rows;
    for (const Row &row : rows_)
      rows.push_back({row.place, row.angle});
    return wheelset_forces(sections_, rows, solution_);
  }


  double
  BodyContact::torque() const
  {
    // what the drive has to give against the moment of the contact
    return -dot(forces_on_wheelset().moment, geometry_.contact.axis.direction);
  }


  WheelRailSolution
  BodyContact::result() const
  {
    WheelRailSolution result;
    result.problem      = problem_;
    result.solution     = solution_;
    result.enlargements = enlargements_;
    result.body_loads   = {loads(false), loads(true)};
    result.patch        = halfspace_patch(solution_);
    for (int j = 0; j <= problem_.grid.my; ++j)
      result.row_edges.push_back(row_at(problem_.grid.y(j) - 0.5 * problem_.grid.dy).place);
    result.measures     = measure_patch(result.patch);
    result.centre       = row_at(result.measures.centre_lateral).place;
    result.rail         = geometry_.contact.rail;
    result.lateral      = force().x;
    result.vertical     = force().y;
    result.roll         = geometry_.contact.roll;
    result.ahead        = geometry_.contact.ahead;
    const auto   angle  = [&](const double y) { return row_at(y).angle; };
    const double middle = result.measures.centre_lateral, half = 0.5 * result.measures.width;
    // by which the surface turns across the patch: conformal where it is large [rad]
    result.turn = std::abs(angle(middle + half) - angle(middle - half));
    std::vector<double> places;
    for (const Row &row : rows_)
      places.push_back(row.s);
    result.kinks = sections_.kinks_under(solution_, places);
    double sum = 0, wheel_angle = 0, x = 0, y = 0;
    for (int j = 0; j < problem_.grid.my; ++j)
      for (int i = 0; i < problem_.grid.mx; ++i)
        if (const double p = solution_.pressure[i + problem_.grid.mx * j]; p > 0)
          {
            sum += p;
            // means over the pressure
            result.angle += p * rows_[j].angle;
            wheel_angle += p * rows_[j].slice.wheel_angle;
            x += p * problem_.grid.x(i);
            y += p * problem_.grid.y(j);
          }
    // the contact angle that is shown
    result.angle /= sum;
    // spin phi = sin(contact angle)/r, angle the mean over the pressure
    result.spin = std::sin(wheel_angle / sum) / geometry_.contact.rolling_radius;
    // the reference point is the centre of pressure
    const Row centre = row_at(y / sum);
    result.reference = reference_at(sections_,
                                    {x / sum, y / sum, centre.place, result.angle, centre.slice},
                                    forces_on_wheelset(),
                                    motion_,
                                    solution_);
    return result;
  }


  WheelRailSolution
  solve_bodies(const Scene         &scene,
               const SceneGeometry &geometry,
               const WheelRailLoad &load,
               const BodyTables    &tables)
  {
    // without offsets: where the bodies move to is part of the solution
    BodyContact contact(scene, geometry, tables);
    contact.carry(load);
    return contact.result();
  }


  WheelRailSolution
  solve_wheel_rail(const Scene          &scene,
                   const SceneGeometry  &geometry,
                   const WheelRailLoad  &load,
                   const SectionOffsets &offsets)
  {
    // tables of both bodies are read where they are kept, else made (0.3 s)
    const auto        begin = std::chrono::steady_clock::now();
    WheelRailSolution result =
      scene.halfspace_bodies == ContactBodies::real
        ? solve_bodies(scene, geometry, load, make_body_tables(scene, geometry, kept_tables_folder()))
        : solve_halfspaces(scene, geometry, load, offsets);
    name_made_up(geometry, result);
    result.time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
  }
} // namespace wheelrail
