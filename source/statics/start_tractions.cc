#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/planes/common_creepage.h>
#include <wheelrail/planes/rigid_slip.h>
#include <wheelrail/statics/facing_surfaces.h>
#include <wheelrail/statics/start_tractions.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

// Tractions of the start: steady rolling of half-spaces under the pressures found (doc/theory/rolling.md,
// Shear tractions, What half-spaces lack). 1. elements of the patches, pressures between nodes; 2. rigid slip
// with the stretch of the tread; 3. half-space solution at a force or a creepage; 4. tractions back to the
// nodes, half an element back.

namespace wheelrail
{
  namespace
  {
    /// The wheel's surface at s, in the plane across the track through the first contact point.
    WheelPlace
    wheel_place(const RunningSurfaces &surfaces, const double s)
    {
      // angle of the tread at s, and angle of its normal against the axle: sin(angle) = t . a with the
      // tangent t turned by a right angle
      const double  tangent = inclination(surfaces, s);
      const Vector3 axis    = surfaces.pose().axis();
      const double  sine    = std::sin(tangent) * axis[0] - std::cos(tangent) * axis[1];
      return {0, tangent, std::asin(sine), {}, surfaces.rolling(s, 0)};
    }

    /// When the wheel turns without creepage: a larger local radius runs backwards, ahead of the axle the
    /// wheel's surface still descends, which slides it along its inclination, and a wheel with yaw slides
    /// aside. The steel of a surface stretched by e passes a place that stands still with (1 + e) of its
    /// speed. `aside`: of the wheel's steel that faces the rows, on its profile [m].
    void
    set_slip(const RunningSurfaces &surfaces,
             const StartMotion     &start,
             const StartGrid       &loaded,
             const double           aside,
             HalfspaceProblem      &problem)
    {
      // The rail is body 1, so that the slip is that of the rail against the wheel over V
      // (doc/theory/halfspace.md, Frame and signs); a driving wheel has a positive creepage c. s + aside is
      // where the row's steel lies on the wheel's profile: radius and angle are those there.
      WheelMotion motion;
      motion.forward_radius   = surfaces.forward_radius;
      motion.lateral_creepage = start.lateral_creepage;
      for (int j = 0; j < problem.grid.my; ++j)
        {
          const RowSlip slip = row_slip(wheel_place(surfaces, loaded.s(j) + aside), motion, 0);
          for (int i = 0; i < problem.grid.mx; ++i)
            {
              // w_x = r(s)/r - 1 + e, w_s = (z/r) sin(angle(s)); c is xi of the solver
              // (doc/theory/rolling.md, Shear tractions)
              problem.rigid_slip_x.push_back(slip.along + start.stretch);
              problem.rigid_slip_y.push_back(slip.lateral_at(problem.grid.x(i)));
            }
        }
    }

    /// What the bodies give way beyond half-spaces under tractions. Under pressure it is in the stretch of
    /// the tread, and taken off here.
    void
    add_bodies(const std::shared_ptr<const AddedInfluence> &added, HalfspaceProblem &problem)
    {
      problem.added = added;
      if (!added)
        return;
      std::vector<double> x(problem.grid.size(), 0.), y(x);
      // slip of the remainder D (doc/theory/bodies.md) under the pressures, which the solution does not
      // change
      added->add_slip({{nullptr, nullptr, &problem.pressure}}, {{&x, &y, nullptr}});
      for (std::size_t e = 0; e < x.size(); ++e)
        {
          // what the solver would add of the pressure, (u - u')/dx of the remainder
          problem.rigid_slip_x[e] -= x[e];
          problem.rigid_slip_y[e] -= y[e];
        }
    }

    /// The half-space problem of the patches in one plane; force or creepage are still to be given.
    struct StartPlane
    {
      StartGrid                         loaded;
      HalfspaceProblem                  problem;
      std::vector<double>               pressure; ///< of the elements [Pa]; the problem's are half a step on
      std::shared_ptr<HalfspaceKernels> kernels;
      HalfspaceSolution                 solution;

      StartPlane(const Contact          &contact,
                 const StartGrid        &grid,
                 const HalfspaceSteels  &bodies,
                 const StartMotion      &motion,
                 const BeyondHalfspaces &beyond)
        : loaded(grid)
        , problem(wheel_on_rail(bodies, contact.law().friction, motion.velocity))
      {
        problem.grid = loaded.grid;
        // the static search asks for tractions again until they stay within 1e-5
        problem.coupling_tolerance = 1e-5;
        // 1. Pressures of the elements [Pa], between the nodes
        pressure = element_pressures(contact, loaded);
        for (int j = 0; j < loaded.grid.my; ++j)
          for (int i = 0; i < loaded.grid.mx; ++i)
            // force of a node over the area of its elements
            pressure[i + std::size_t(loaded.grid.mx) * j] *=
              area_ratio(contact, i / loaded.parts, j / loaded.parts);
        // bounds mu p half an element on, where the particles of the step are in the mean
        // (doc/theory/accuracy.md, Edges of the patch)
        // 2. Bound and rigid slip
        problem.pressure = in_midst_of_step(loaded.grid, pressure);
        set_slip(contact.surfaces(), motion, loaded, facing_after_shift(contact, loaded), problem);
        if (beyond)
          add_bodies(beyond(loaded), problem);
      }

      /// Nodes of inclined facets have more area than their elements.
      double
      area_ratio(const Contact &contact, const int i, const int j) const
      {
        // so that pressure times element area is the force of the node
        // a facet inclined by a against the plane has 1/cos(a) of the area
        return contact.rail().area[loaded.node(contact.lattice(), i, j)] /
               (loaded.grid.element_area() * loaded.parts * loaded.parts);
      }

      void
      solve()
      {
        // tractions of the last creepage are the first guess for the next
        const HalfspaceSolution before = std::move(solution);
        solution                       = solve_rolling(problem, kernels, &before);
      }
    };

    /// The patches of one wheel, with one creepage.
    class StartPlanes
    {
    public:
      StartPlanes(const Contact          &contact,
                  const HalfspaceSteels  &bodies,
                  const StartMotion      &motion,
                  const BeyondHalfspaces &beyond)
        : contact_(contact)
      {
        // without friction there are no tractions, and no creepage follows from a force
        if (contact.law().friction.at(0) > 0)
          for (const StartGrid &grid : start_grids(contact))
            planes_.emplace_back(contact, grid, bodies, motion, beyond);
      }

      void
      roll(const double creepage)
      {
        // the creepage c is one number for all patches: all turn with the wheel
        for (StartPlane &plane : planes_)
          {
            plane.problem.longitudinal_force_given = false;
            plane.problem.xi                       = creepage;
            plane.solve();
          }
      }

      /// With a longitudinal force on the wheel [N]; false: friction does not carry it, or the solver did not
      /// reach its tolerance.
      bool
      drive(const double force)
      {
        if (planes_.empty())
          return true;
        if (planes_.size() == 1)
          {
            StartPlane &plane                      = planes_.front();
            plane.problem.longitudinal_force_given = true;
            // the rail is body 1: its force is minus that on the wheel
            plane.problem.fx = -force;
            plane.solve();
            return plane.solution.within_friction && plane.solution.tangential_converged;
          }
        // planes have one creepage: root of sum of forces - force (several patches)
        // [N]: forces are compared with the bound of all planes together
        const double close = 1e-6 * bound();
        // from the creepage of the last force on
        const CreepageFound found = find_creepage(
          [&](const double creepage) {
            roll(creepage);
            const double missed = this->force() - force;
            return std::abs(missed) < close ? 0 : missed;
          },
          creepage_);
        roll(creepage_ = found.carried ? found.creepage : 0);
        return found.carried && std::all_of(planes_.begin(), planes_.end(), [](const StartPlane &plane) {
                 return plane.solution.tangential_converged;
               });
      }

      /// Tractions of the elements as means over the nodes; none without patches.
      StartTractions
      tractions() const
      {
        StartTractions result;
        result.traction.assign(contact_.nodes().size(), {0, 0, 0});
        for (const StartPlane &plane : planes_)
          {
            result.creepage = plane.solution.xi;
            result.force -= plane.solution.fx;
            result.converged = result.converged && plane.solution.converged();
            add_tractions(plane, result.traction);
          }
        return result;
      }

    private:
      double
      force() const
      {
        double sum = 0;
        for (const StartPlane &plane : planes_)
          // on the wheel
          sum -= plane.solution.fx;
        return sum;
      }

      double
      bound() const
      {
        double sum = 0;
        for (const StartPlane &plane : planes_)
          sum += std::accumulate(plane.pressure.begin(), plane.pressure.end(), 0.) *
                 plane.loaded.grid.element_area();
        return contact_.law().friction.at(0) * sum;
      }

      void
      add_tractions(const StartPlane &plane, std::vector<Vector3> &to) const
      {
        const StartGrid  &loaded   = plane.loaded;
        const int         parts    = loaded.parts;
        const VectorField traction = at_elements(loaded.grid, plane.pressure, plane.solution);
        for (int i = 0; i < loaded.n_i; ++i)
          for (int j = 0; j < loaded.n_j; ++j)
            {
              double along = 0, lateral = 0;
              for (int a = 0; a < parts; ++a)
                for (int b = 0; b < parts; ++b)
                  {
                    const std::size_t e = loaded.element(i, j, a, b);
                    // mean over the parts x parts elements of a node
                    along += traction[0][e] / (parts * parts);
                    lateral += traction[1][e] / (parts * parts);
                  }
              // (x, y) of the plane in (X, Y, Z) of the track: y along (cos, sin) of the inclination; over
              // the ratio of areas, tractions per area of the node
              const double angle = inclination(contact_.surfaces(), loaded.s(parts * j + (parts - 1) / 2)),
                           ratio = plane.area_ratio(contact_, i, j);
              Vector3 &node      = to[loaded.node(contact_.lattice(), i, j)];
              node =
                node +
                Vector3{lateral / ratio * std::cos(angle), lateral / ratio * std::sin(angle), along / ratio};
            }
      }

      const Contact          &contact_;
      std::vector<StartPlane> planes_;
      double                  creepage_ = 0; ///< last found
    };

    /// The solution with the largest force up to the one wanted that friction falling with the slip
    /// carries, to one per cent of the bound at rest: bisection from the force that it carries at any speed.
    StartTractions
    drive_with_falling_friction(StartPlanes &planes, const double force, const double carried)
    {
      if (planes.drive(force))
        return planes.tractions();
      // friction d N is carried at any speed; more of it may have no steady solution
      double low = std::copysign(carried, force), high = force;
      // Friction that falls with the slip speed: mu(v) p. A force between d N and s N may have a steady
      // solution or none; where the slip that it needs lowers the bound below it, the wheel spins up.
      planes.drive(low);
      StartTractions best = planes.tractions();
      // bisection on the force
      while (std::abs(high - low) > 0.01 * std::abs(force))
        {
          const double middle = 0.5 * (low + high);
          if (planes.drive(middle))
            {
              low  = middle;
              best = planes.tractions();
            }
          else
            high = middle;
        }
      return best;
    }
  } // namespace


  StartTractions
  start_tractions_at_creepage(const Contact          &contact,
                              const double            creepage,
                              const HalfspaceSteels  &bodies,
                              const StartMotion      &motion,
                              const BeyondHalfspaces &beyond)
  {
    StartPlanes planes(contact, bodies, motion, beyond);
    planes.roll(creepage);
    StartTractions result = planes.tractions();
    result.creepage       = creepage;
    return result;
  }


  StartTractions
  start_tractions(const Contact          &contact,
                  const double            longitudinal_force,
                  const HalfspaceSteels  &bodies,
                  const StartMotion      &motion,
                  const BeyondHalfspaces &beyond)
  {
    // the last two per cent below full slip cost any creepage; a torque beyond them spins the wheel up
    constexpr double   full_slip = 0.98;
    const FrictionLaw &friction  = contact.law().friction;
    // sum of p A over the nodes: what bounds friction, not the vertical force
    double load = 0;
    for (std::size_t k = 0; k < contact.nodes().size(); ++k)
      load += contact.nodes()[k].pressure * contact.rail().area[k];
    // 98 % of mu times the sum of p A
    const double   bound = full_slip * friction.at(0) * load;
    const double   force = std::clamp(longitudinal_force, -bound, bound);
    StartPlanes    planes(contact, bodies, motion, beyond);
    StartTractions result;
    if (friction.steepest_fall() > 0)
      result = drive_with_falling_friction(
        planes, force, std::min(std::abs(force), full_slip * friction.sliding() * load));
    else
      {
        planes.drive(force);
        result = planes.tractions();
      }
    // one per cent and one newton: below that the force counts as found
    result.saturated = std::abs(result.force - longitudinal_force) > 0.01 * std::abs(longitudinal_force) + 1;
    return result;
  }
} // namespace wheelrail
