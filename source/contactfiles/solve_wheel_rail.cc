#include <wheelrail/contactfiles/case_problem.h>
#include <wheelrail/contactfiles/patch_problem.h>
#include <wheelrail/contactfiles/solve_cases.h>
#include <wheelrail/contactfiles/wheel_rail_case.h>
#include <wheelrail/halfspace/kernels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {

    /// The patch seen in a mirror along the track.
    void
    mirror(WheelRailPatch &patch)
    {
      HalfspaceSolution &s = patch.solution;
      s.grid.y0            = -s.grid.y(s.grid.my - 1);
      const auto turn_rows = [&](auto &field) {
        for (int j = 0; field.size() == std::size_t(s.grid.size()) && j < s.grid.my / 2; ++j)
          std::swap_ranges(field.begin() + s.grid.mx * j,
                           field.begin() + s.grid.mx * (j + 1),
                           field.begin() + s.grid.mx * (s.grid.my - 1 - j));
      };
      for (auto *field : {&s.pressure,
                          &s.traction_x,
                          &s.traction_y,
                          &s.displacement_n,
                          &s.displacement_x,
                          &s.displacement_y,
                          &s.gap,
                          &s.slip_x,
                          &s.slip_y,
                          &s.friction,
                          &s.yield_stress,
                          &s.plastic_x,
                          &s.plastic_y})
        turn_rows(*field);
      turn_rows(s.state);
      for (auto *field : {&s.traction_y, &s.displacement_y, &s.slip_y, &s.plastic_y})
        for (double &value : *field)
          value = -value;
      for (double *value : {&s.fy,
                            &s.eta,
                            &s.phi,
                            &s.spin_moment,
                            &patch.angle,
                            &patch.lateral_creepage,
                            &patch.spin,
                            &patch.origin_y,
                            &patch.spin_moment})
        *value = -*value;
      for (Vector3 *vector :
           {&patch.in_track, &patch.on_rail, &patch.on_wheel, &patch.force_track, &patch.force_wheelset})
        (*vector)[1] = -(*vector)[1];
      for (Vector3 *moment : {&patch.moment_rail, &patch.moment_wheelset})
        *moment = {-(*moment)[0], (*moment)[1], -(*moment)[2]};
      std::swap(patch.y_low, patch.y_high);
      patch.y_low  = -patch.y_low;
      patch.y_high = -patch.y_high;
    }

    void
    mirror(WheelRailCase &result)
    {
      for (WheelRailPatch &patch : result.patches)
        mirror(patch);
      for (Vector3 *force : {&result.force_track, &result.force_wheelset})
        (*force)[1] = -(*force)[1];
    }

    /// The rows and columns of a grid that a solution has in contact, as the grid of their elements.
    HalfspaceGrid
    contact_of(const HalfspaceSolution &s)
    {
      int low_x = s.grid.mx, high_x = -1, low_y = s.grid.my, high_y = -1;
      for (int j = 0; j < s.grid.my; ++j)
        for (int i = 0; i < s.grid.mx; ++i)
          if (s.pressure[std::size_t(i) + std::size_t(s.grid.mx) * j] > 0)
            {
              low_x  = std::min(low_x, i);
              high_x = std::max(high_x, i);
              low_y  = std::min(low_y, j);
              high_y = std::max(high_y, j);
            }
      HalfspaceGrid grid = s.grid;
      grid.mx            = std::max(0, high_x - low_x + 1);
      grid.my            = std::max(0, high_y - low_y + 1);
      grid.x0            = s.grid.x(low_x);
      grid.y0            = s.grid.y(low_y);
      return grid;
    }

    /// A grid that covers another of equal elements, too.
    void
    cover(HalfspaceGrid &grid, const HalfspaceGrid &other)
    {
      if (other.size() == 0)
        return;
      const auto left = [](double a, double b, double d) {
        return std::max(0, int(std::lround((a - b) / d)));
      };
      const int    x = left(grid.x0, other.x0, grid.dx), y = left(grid.y0, other.y0, grid.dy);
      const double last_x = std::max(grid.x(grid.mx - 1), other.x(other.mx - 1)),
                   last_y = std::max(grid.y(grid.my - 1), other.y(other.my - 1));
      grid.x0 -= x * grid.dx;
      grid.y0 -= y * grid.dy;
      grid.mx = int(std::lround((last_x - grid.x0) / grid.dx)) + 1;
      grid.my = int(std::lround((last_y - grid.y0) / grid.dy)) + 1;
    }

    /// Elements of the problem beyond its patch, which the state before reached, do not touch.
    void
    keep_within(const HalfspaceGrid &patch, HalfspaceProblem &problem)
    {
      const HalfspaceGrid &grid = problem.grid;
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i)
          {
            const double x = (grid.x(i) - patch.x0) / grid.dx, y = (grid.y(j) - patch.y0) / grid.dy;
            if (x < -0.5 || y < -0.5 || x > patch.mx - 0.5 || y > patch.my - 0.5)
              problem.undeformed_distance[std::size_t(i) + std::size_t(grid.mx) * j] = 1;
          }
    }

    /// Heights and pitch rates of one case, and what they give.
    class CaseSolver
    {
    public:
      CaseSolver(const ContactCase &one, const WheelRailCase *before, WheelRailStart &start)
        : one_(one)
        , rail_(section_line(one.track.profile, false))
        , wheel_(section_line(one.wheelset.profile, true))
        , pose_(wheel_rail_pose(one, rail_))
        , gaps_(gap_places(pose_, rail_, wheel_, 0.3 * millimetre * one.elements.ds))
        , shift_(one.digits.motion == 1)
        , transient_(shift_ || one.digits.motion == 2)
        , start_(start)
        , kernels_(start.kernels)
      {
        touching_ = 1;
        for (const GapPlace &gap : gaps_)
          touching_ = std::min(touching_, gap.gap);
        if (before)
          {
            before_ = *before;
            if (pose_.left)
              mirror(before_);
          }
      }

      WheelRailCase
      run()
      {
        WheelRailCase result;
        if (touching_ >= 1)
          result.not_reached = "Wheel and rail lie beside each other. ";
        else if (one_.digits.normal == 0)
          {
            guess_ = at(pose_.height, false);
            result = at(pose_.height, true);
          }
        else if (one_.digits.forces != 1)
          result = carry(first_height());
        else
          result = drive();
        result.touching = touching_;
        if (pose_.left)
          mirror(result);
        start_.kernels = kernels_;
        return result;
      }

    private:
      double
      wanted() const
      {
        return one_.wheelset.position[2];
      }

      /// What a height of the wheelset gives; without friction where it is not to roll.
      WheelRailCase
      at(const double height, const bool rolls)
      {
        pose_.height = height;
        WheelRailCase result;
        result.height     = height;
        result.pitch_rate = pose_.wheelset_motion.rotation[1];
        const auto places = patch_places(gaps_, pose_, rail_, one_.elements);
        kernels_.resize(std::max(kernels_.size(), places.size()));
        for (std::size_t k = 0; k < places.size(); ++k)
          {
            result.patches.push_back(patch(places, rolls && one_.digits.motion != 0, k));
            add(result.force_track, 1, result.patches.back().force_track);
            add(result.force_wheelset, 1, result.patches.back().force_wheelset);
            if (result.patches.back().backwards)
              result.refused =
                "a wheel that rolls backwards is not computed; taken are those that roll forward";
            result.not_reached += result.patches.back().solution.not_reached;
          }
        return result;
      }

      WheelRailPatch
      patch(const std::vector<PatchPlace> &places, const bool rolls, const std::size_t number)
      {
        const PatchPlace &place = places[number];
        WheelRailPatch    patch;
        set_place(place, patch);
        HalfspaceProblem problem;
        set_bodies(one_, problem);
        problem.grid = patch_grid(one_, place, patch.origin_x, patch.origin_y);
        const HalfspaceSolution earlier =
          rolls && transient_ ? earlier_state(places, number, patch, problem.grid) : HalfspaceSolution();
        const HalfspaceGrid own = patch_grid(one_, place, patch.origin_x, patch.origin_y);
        problem.undeformed_distance =
          patch_distance(pose_, rail_, wheel_, place, problem.grid, patch.origin_x, patch.origin_y);
        keep_within(own, problem);
        const double nearest =
          *std::min_element(problem.undeformed_distance.begin(), problem.undeformed_distance.end());
        for (double &h : problem.undeformed_distance)
          h -= nearest;
        problem.force_given = false;
        problem.approach    = std::max(0., -nearest);
        if (rolls)
          set_motion(place, problem, patch);
        else
          problem.motion = HalfspaceMotion::none;
        if (rolls && transient_ && !earlier.pressure.empty())
          problem.previous = &earlier;
        const HalfspaceSolution *guess = nullptr;
        HalfspaceSolution        moved;
        if (number < guess_.patches.size())
          {
            const HalfspaceSolution &last = guess_.patches[number].solution;
            if (std::abs(last.grid.dx - problem.grid.dx) < 1e-9 &&
                std::abs(last.grid.dy - problem.grid.dy) < 1e-9)
              {
                moved = on_grid(last, problem.grid);
                guess = &moved;
              }
          }
        std::vector<RowDivision> divisions = place.divisions;
        for (RowDivision &d : divisions)
          d.place = (d.place - place.reference[1]) / std::cos(place.angle) + patch.origin_y;
        patch.solution = divisions.empty() ? solve_rolling(problem, kernels_[number], guess)
                                           : solve_weakened(problem, divisions, kernels_[number], guess);
        if (problem.max_coupling_rounds == 1 && patch.solution.normal_converged &&
            (!rolls || patch.solution.tangential_converged))
          {
            patch.solution.coupling_converged = true;
            patch.solution.not_reached.clear();
          }
        set_forces(place, patch);
        return patch;
      }

      /// Where a patch lies, in the axes of track, rail and wheel.
      void
      set_place(const PatchPlace &place, WheelRailPatch &patch) const
      {
        patch.in_track = place.reference;
        patch.on_rail  = pose_.rail.back(place.reference);
        patch.on_wheel = pose_.wheel_to_track().back(place.reference);
        patch.angle    = place.angle;
        patch.y_low    = place.y_low;
        patch.y_high   = place.y_high;
        patch.arc      = rail_.arc(place.line);
        if (transient_)
          {
            patch.origin_x = shift_ ? millimetre * one_.wheelset.position[0] + place.reference[0] : 0;
            patch.origin_y = patch.arc;
          }
      }

      void
      set_motion(const PatchPlace &place, HalfspaceProblem &problem, WheelRailPatch &patch) const
      {
        const RigidMotion wheel  = pose_.wheel_to_track();
        const RigidMotion axes   = patch_axes(place);
        const auto        column = [&](const int k) {
          return wheel.rows[0][k] * axes.rows[0][1] + wheel.rows[1][k] * axes.rows[1][1] +
                 wheel.rows[2][k] * axes.rows[2][1];
        };
        problem.friction               = patch_friction(one_, std::atan2(column(2), column(1)));
        patch.friction                 = problem.friction.at(0);
        const PatchCreepages creepages = patch_creepages(pose_, place, problem.approach, shift_);
        patch.velocity                 = creepages.velocity;
        patch.backwards                = creepages.backwards;
        patch.creepage                 = creepages.x;
        patch.lateral_creepage         = creepages.y;
        patch.spin                     = creepages.spin;
        problem.motion                 = shift_       ? HalfspaceMotion::shift
                                         : transient_ ? HalfspaceMotion::transient
                                                      : HalfspaceMotion::steady;
        problem.velocity               = creepages.velocity;
        // creepages count at the contact reference, those of the problem at its origin
        problem.xi  = creepages.x + creepages.spin * patch.origin_y;
        problem.eta = creepages.y - creepages.spin * patch.origin_x;
        problem.phi = creepages.spin;
        if (one_.digits.motion == 2 || one_.digits.solver == 2)
          problem.step = one_.elements.relative_step * problem.grid.dx;
        patch.step = shift_ ? 1 : problem.step > 0 ? problem.step : problem.grid.dx;
      }

      /// The state that patches of the case before leave under this one; its grid is enlarged over it. Where
      /// an earlier patch has split, the last of its parts sees what lies on its own grid alone, as in
      /// CONTACT.
      HalfspaceSolution
      earlier_state(const std::vector<PatchPlace> &places,
                    const std::size_t              number,
                    WheelRailPatch                &patch,
                    HalfspaceGrid                 &grid) const
      {
        std::vector<HalfspaceSolution> states;
        for (std::size_t k = 0; k < before_.patches.size(); ++k)
          {
            const WheelRailPatch &old     = before_.patches[k];
            const auto            goes_on = [&](const PatchPlace &place) {
              return place.y_low <= old.y_high && place.y_high >= old.y_low;
            };
            if (!goes_on(places[number]))
              continue;
            const auto here = places.begin() + std::ptrdiff_t(number);
            const bool last_of_it =
              std::any_of(places.begin(), here, goes_on) && std::none_of(here + 1, places.end(), goes_on);
            patch.earlier.push_back(int(k) + 1);
            HalfspaceSolution state = old.solution;
            if (old.origin_x == 0 && old.origin_y == 0) // of steady rolling: to the fixed grid
              {
                const double x = shift_ ? before_.along + old.in_track[0] : 0;
                state.grid.x0 += std::round(x / grid.dx) * grid.dx;
                state.grid.y0 += std::round(old.arc / grid.dy) * grid.dy;
              }
            if (!last_of_it)
              cover(grid, contact_of(state));
            states.push_back(std::move(state));
          }
        HalfspaceSolution sum;
        for (const HalfspaceSolution &state : states)
          {
            const HalfspaceSolution moved = on_grid(state, grid);
            if (sum.pressure.empty())
              {
                sum = moved;
                continue;
              }
            for (std::size_t e = 0; e < moved.pressure.size(); ++e)
              {
                sum.pressure[e] += moved.pressure[e];
                sum.traction_x[e] += moved.traction_x[e];
                sum.traction_y[e] += moved.traction_y[e];
              }
          }
        return sum;
      }

      void
      set_forces(const PatchPlace &place, WheelRailPatch &patch) const
      {
        const HalfspaceSolution &s        = patch.solution;
        const RigidMotion        axes     = patch_axes(place);
        const RigidMotion        wheelset = pose_.wheelset_to_track(), wheel = pose_.wheel_to_track();
        patch.spin_moment = s.spin_moment - patch.origin_x * s.fy + patch.origin_y * s.fx;
        // moments of the pressure about the axes in the plane, through the contact reference
        Vector3 moment{0, 0, patch.spin_moment};
        for (int j = 0; j < s.grid.my; ++j)
          for (int i = 0; i < s.grid.mx; ++i)
            {
              const double force =
                s.pressure[std::size_t(i) + std::size_t(s.grid.mx) * j] * s.grid.element_area();
              moment[0] += (s.grid.y(j) - patch.origin_y) * force;
              moment[1] -= (s.grid.x(i) - patch.origin_x) * force;
            }
        moment            = axes.turned(moment);
        patch.force_track = axes.turned({s.fx, s.fy, s.fn});
        const auto back   = [&](const Vector3 &v) { // to the axes of the wheelset
          return wheelset.back(v + wheelset.move);
        };
        patch.force_wheelset  = back(patch.force_track);
        patch.moment_rail     = cross(place.reference - pose_.rail.move, patch.force_track) + moment;
        patch.moment_wheelset = back(cross(place.reference - wheel.move, patch.force_track) + moment);
      }

      /// The height at which the pressures alone carry the load, by secants of force to the power 2 / 3 over
      /// depth, which Hertz's law makes a line.
      double
      first_height()
      {
        const double E = contact_modulus_of_case(), F = wanted();
        if (start_.guess && !start_.guess->patches.empty() && start_.guess->height > start_.guess->touching)
          {
            guess_ = *start_.guess;
            if (pose_.left)
              mirror(guess_);
            const double as_deep = guess_.height - guess_.touching;
            slope_               = 1.5 * F / as_deep;
            return touching_ + as_deep;
          }
        double depth = std::pow(0.75 * F / (E * std::sqrt(0.3)), 2. / 3), low = 0, high = 1;
        for (int k = 0; k < 40; ++k)
          {
            WheelRailCase here = at(touching_ + depth, false);
            const double  Fz   = here.force_track[2];
            guess_             = std::move(here);
            slope_             = 1.5 * std::max(Fz, 1e-3 * F) / depth;
            if (std::abs(Fz - F) < 1e-4 * F)
              break;
            (Fz < F ? low : high) = depth;
            depth *= std::clamp(std::pow(F / std::max(Fz, 1e-6 * F), 2. / 3), 0.2, 4.);
            if (!(depth > low && depth < high))
              depth = high < 1 ? 0.5 * (low + high) : 2 * low;
          }
        return touching_ + depth;
      }

      double
      contact_modulus_of_case() const
      {
        const ContactMaterial &m = one_.material;
        return contact_modulus(1e6 * m.shear[0], m.poisson[0], 1e6 * m.shear[1], m.poisson[1]);
      }

      /// Carries the load (N = 1) from a first height on.
      WheelRailCase
      carry(double height)
      {
        constexpr double enough = 2e-6; // of the load
        WheelRailCase    here;
        double           low = touching_, high = 1, before = 0, force_before = 0;
        for (int k = 0; k < 40; ++k)
          {
            here                = at(height, true);
            guess_              = here;
            const double Fz     = here.force_track[2];
            const double missed = Fz - wanted();
            if (std::abs(missed) < enough * wanted())
              return here;
            (missed < 0 ? low : high) = height;
            if (k > 0 && height != before)
              if (const double s = (Fz - force_before) / (height - before);
                  s > 0.2 * slope_ && s < 5 * slope_)
                slope_ = s;
            before       = height;
            force_before = Fz;
            height -= missed / slope_;
            if (!(height > low && height < high))
              height = 0.5 * (low + std::min(high, low + 2e-3));
            if (high - low < 1e-12)
              break;
          }
        if (std::abs(here.force_track[2] - wanted()) > 1e-4 * wanted())
          here.not_reached += "The height that carries FZ was not found. ";
        return here;
      }

      /// Finds the pitch rate of a longitudinal force (F = 1), too.
      WheelRailCase
      drive()
      {
        const double F       = one_.wheelset.velocity[5];
        const double forward = pose_.wheelset_motion.velocity[0];
        double      &rate    = pose_.wheelset_motion.rotation[1];
        double       height  = first_height();
        rate                 = -forward / pose_.wheel_radius;
        WheelRailCase here   = carry(height);
        if (!here.patches.empty()) // free rolling of the first patch
          {
            rate *= 1 + here.patches.front().creepage;
            here = carry(here.height);
          }
        constexpr double enough = 1e-5; // of the load
        double           missed = here.force_wheelset[0] - F, step = 1e-4 * std::abs(rate), low = 0, high = 0;
        bool             has_low = false, has_high = false;
        double           at_low = 0, at_high = 0;
        for (int k = 0; k < 60 && std::abs(missed) > enough * wanted(); ++k)
          {
            // the force grows with the rate
            if (missed < 0)
              {
                low = rate, at_low = missed, has_low = true;
              }
            else
              {
                high = rate, at_high = missed, has_high = true;
              }
            if (has_low && has_high)
              {
                double part = at_low / (at_low - at_high);
                if (k % 3 == 2)
                  part = 0.5 * (part + 0.5);
                rate = low + part * (high - low);
                if (std::abs(high - low) < 1e-12 * std::abs(rate))
                  break;
              }
            else
              {
                rate += missed < 0 ? step : -step;
                step *= 2.5;
                if (step > 3 * std::abs(rate))
                  break;
              }
            here   = carry(here.height);
            missed = here.force_wheelset[0] - F;
          }
        if (std::abs(missed) > 1e-3 * wanted())
          here.not_reached += "Friction does not carry FX_WS. ";
        return here;
      }

      const ContactCase                             &one_;
      ProfileLine                                    rail_, wheel_;
      WheelRailPose                                  pose_;
      std::vector<GapPlace>                          gaps_;
      bool                                           shift_, transient_;
      double                                         touching_ = 0, slope_ = 0;
      WheelRailCase                                  before_, guess_;
      WheelRailStart                                &start_;
      std::vector<std::shared_ptr<HalfspaceKernels>> kernels_;
    };
  } // namespace


  WheelRailCase
  solve_wheel_rail(const ContactCase &one, const WheelRailCase *before, WheelRailStart &start)
  {
    WheelRailCase result = CaseSolver(one, before, start).run();
    result.along         = millimetre * one.wheelset.position[0];
    return result;
  }

  WheelRailCase
  solve_wheel_rail(const ContactCase &one, const WheelRailCase *before)
  {
    WheelRailStart start;
    return solve_wheel_rail(one, before, start);
  }
} // namespace wheelrail
