#include <wheelrail/contactfiles/case_problem.h>
#include <wheelrail/contactfiles/gap_mesh.h>
#include <wheelrail/contactfiles/patch_solver.h>
#include <wheelrail/contactfiles/wheel_rail_case.h>
#include <wheelrail/halfspace/kernels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {

    /// Heights and pitch rates of one case, and what they give.
    class CaseSolver
    {
    public:
      CaseSolver(const ContactCase &one, const WheelRailCase *before, WheelRailStart &start)
        : one_(one)
        , rail_(one)
        , wheel_(one)
        , pose_(wheel_rail_pose(one, rail_.middle()))
        , asked_(pose_.height)
        , patches_(one, rail_, wheel_, pose_, before ? &before_ : nullptr)
        , start_(start)
      {
        touching_ = 1;
        if (one.digits.forces == 3 && one.digits.normal == 0)
          spring_ = one.track.springs[2] / millimetre;
        if (meshed())
          {
            mesh_ =
              gap_mesh(pose_, rail_, wheel_, millimetre * one.elements.dx, millimetre * one.elements.ds);
            touching_ = mesh_.least();
          }
        else
          gaps_ = gap_places(pose_, rail_.middle(), wheel_.middle(), 0.3 * millimetre * one.elements.ds);
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
        else if (one_.digits.normal == 0 && spring_ == 0)
          {
            guess_ = at(pose_.height, false);
            result = at(pose_.height, true);
          }
        else if (spring_ > 0 && wanted(touching_) <= 0) // it holds the rail below the wheel
          result = at(asked_ - one_.track.springs[3] / spring_, true);
        else if (one_.digits.forces != 1)
          result = carry(first_height());
        else
          result = drive();
        result.touching = touching_;
        if (spring_ > 0)
          take_down(asked_ - result.height, result);
        if (pose_.left)
          mirror(result);
        return result;
      }

    private:
      /// Whether overlaps are found on a mesh, not along the contact locus.
      bool
      meshed() const
      {
        return (rail_.varies() && !(pose_.roller && one_.digits.grid != 5)) || wheel_.out_of_round();
      }

      /// The vertical force asked for at a height over the rail: FZ or, of a rail on springs under a wheelset
      /// of given height, what bends the spring so far [N].
      double
      wanted(const double height) const
      {
        return spring_ > 0 ? spring_ * (asked_ - height) - one_.track.springs[3] : one_.wheelset.position[2];
      }

      /// The rail, and the contact with it, have gone down by so much.
      static void
      take_down(const double down, WheelRailCase &result)
      {
        result.height += down;
        result.touching += down;
        result.deflection[2] = down;
        for (WheelRailPatch &patch : result.patches)
          patch.in_track[2] += down;
      }

      /// What a height of the wheelset gives; without friction where it is not to roll.
      WheelRailCase
      at(const double height, const bool rolls)
      {
        pose_.height = height;
        WheelRailCase result;
        result.height     = height;
        result.pitch_rate = pose_.wheelset_motion.rotation[1];
        const auto places = meshed() ? patch_places(mesh_, pose_, rail_, one_.elements)
                                     : patch_places(gaps_, pose_, rail_.middle(), one_.elements);
        for (std::size_t k = 0; k < places.size(); ++k)
          {
            const HalfspaceSolution *const last =
              k < guess_.patches.size() ? &guess_.patches[k].solution : nullptr;
            result.patches.push_back(
              patches_.solve(places, rolls && one_.digits.motion != 0, k, last, start_.kernels));
            add(result.force_track, 1, result.patches.back().force_track);
            add(result.force_wheelset, 1, result.patches.back().force_wheelset);
            if (result.patches.back().backwards && one_.digits.motion == 2)
              result.refused =
                "a wheel that rolls backwards with T = 2 is not computed; taken are T = 3, and forward "
                "rolling";
            if (one_.digits.influence == 4 && !places[k].divisions.empty())
              result.refused =
                "C = 4 (angle correction) of overlaps nearer than D_SEP that make one patch is not "
                "computed; taken are single ones, D_COMB = D_SEP";
            result.not_reached += result.patches.back().solution.not_reached;
          }
        return result;
      }

      /// The height at which the pressures alone carry the load, by secants of force to the power 2 / 3 over
      /// depth, which Hertz's law makes a line.
      double
      first_height()
      {
        const double E = contact_modulus_of_case(), F = wanted(touching_);
        if (start_.guess && !start_.guess->patches.empty() && start_.guess->height > start_.guess->touching)
          {
            guess_ = *start_.guess;
            if (pose_.left)
              mirror(guess_);
            double pressed = 0;
            for (const WheelRailPatch &patch : guess_.patches)
              pressed += patch.normal_force * std::cos(patch.angle);
            if (guess_.force_track[2] > 0)
              share_ = std::clamp(pressed / guess_.force_track[2], 0.5, 2.);
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

      struct ForceAtHeight
      {
        double height, force; ///< [m], [N]
      };

      /// Takes the slope of force over height from the last two heights where it is near the one known.
      void
      follow_slope(std::optional<ForceAtHeight> &last, const ForceAtHeight &here)
      {
        if (last && here.height != last->height)
          if (const double s = (here.force - last->force) / (here.height - last->height);
              s > 0.2 * slope_ && s < 5 * slope_)
            slope_ = s;
        last = here;
      }

      /// From a height to the one at which the pressures alone carry their share of the load, by secants: a
      /// solution without friction takes a third of one with it.
      double
      lowered(double height)
      {
        std::optional<ForceAtHeight> last;
        for (int k = 0; k < 6; ++k)
          {
            pressed_            = at(height, false).force_track[2];
            const double missed = pressed_ - share_ * wanted(height);
            if (std::abs(missed) < 1e-6 * std::abs(wanted(height)))
              break;
            follow_slope(last, {height, pressed_});
            const double next = height - missed / (slope_ + spring_);
            if (!(next > touching_))
              break;
            height = next;
          }
        return height;
      }

      /// Carries the load (N = 1) from a first height on.
      WheelRailCase
      carry(double height)
      {
        constexpr double             enough = 2e-6; // of the load
        WheelRailCase                here;
        double                       low = touching_, high = 1;
        std::optional<ForceAtHeight> last;
        for (int k = 0; k < 40; ++k)
          {
            if (k < 3 && share_ > 0) // else the first height is near
              height = lowered(height);
            here            = at(height, true);
            guess_          = here;
            const double Fz = here.force_track[2];
            if (k < 3 && share_ > 0 && pressed_ > 0 && Fz > 0)
              share_ = pressed_ / Fz;
            const double missed = Fz - wanted(height);
            if (std::abs(missed) < enough * std::abs(wanted(height)))
              return here;
            (missed < 0 ? low : high) = height;
            follow_slope(last, {height, Fz});
            height -= missed / (slope_ + spring_);
            if (!(height > low && height < high))
              height = 0.5 * (low + std::min(high, low + 2e-3));
            if (high - low < 1e-12)
              break;
          }
        if (std::abs(here.force_track[2] - wanted(here.height)) > 1e-4 * std::abs(wanted(here.height)))
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
        rate = pose_.roller ? -pose_.roller_turning[1] * one_.track.roller_radius / one_.wheelset.radius
                            : -forward / pose_.wheel_radius;
        WheelRailCase here = carry(height);
        if (!here.patches.empty()) // free rolling of the first patch
          {
            rate *= 1 + here.patches.front().creepage;
            here = carry(here.height);
          }
        constexpr double enough = 1e-5; // of the load
        const double     load   = wanted(height);
        double           missed = here.force_wheelset[0] - F, step = 1e-4 * std::abs(rate), low = 0, high = 0;
        bool             has_low = false, has_high = false;
        double           at_low = 0, at_high = 0;
        for (int k = 0; k < 60 && std::abs(missed) > enough * load; ++k)
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
        if (std::abs(missed) > 1e-3 * load)
          here.not_reached += "Friction does not carry FX_WS. ";
        return here;
      }

      const ContactCase    &one_;
      RailShape             rail_;
      WheelShape            wheel_;
      WheelRailPose         pose_;
      double                asked_;      ///< height given (N = 0) [m]
      double                spring_ = 0; ///< KZRAIL where it counts [N/m]
      std::vector<GapPlace> gaps_;       ///< where the rail is one section all along
      GapMesh               mesh_;       ///< else
      PatchSolver           patches_;
      double                touching_ = 0, slope_ = 0;
      /// Of the load, what pressures carry without friction (0: not known), and that force [N].
      double          share_ = 0, pressed_ = 0;
      WheelRailCase   before_, guess_;
      WheelRailStart &start_;
    };


    /// A rail on springs (F = 3) stands where FY(dy) + FYRAIL = KYRAIL dy, the lateral force on the rail at
    /// the place across that it has moved to. The force falls with dy: by false position (Illinois).
    WheelRailCase
    solve_on_springs(const ContactCase &one, WheelRailStart &start)
    {
      const double  stiffness = one.track.springs[0], pull = one.track.springs[1];
      ContactCase   moved = one;
      WheelRailCase here;
      const auto    missed = [&](const double across) { // [mm], [N]
        moved.track.deviation[0] = one.track.deviation[0] + across;
        here                     = CaseSolver(moved, nullptr, start).run();
        here.deflection[1]       = millimetre * across;
        start.guess              = &here;
        return here.force_track[1] + pull - stiffness * across;
      };
      const WheelRailCase *const given  = start.guess;
      const auto                 enough = [&](const double r) {
        return std::abs(r) < 1e-5 * std::max(std::abs(here.force_track[2]), std::abs(pull));
      };
      double a = 0, at_a = missed(a), b = a, at_b = at_a, step = at_a > 0 ? 1 : -1;
      while (at_a * at_b > 0 && std::abs(step) < 1e3)
        {
          a    = b;
          at_a = at_b;
          at_b = missed(b = a + step);
          step *= 2;
        }
      for (int k = 0; k < 60 && !enough(at_b) && std::abs(b - a) > 1e-9; ++k)
        {
          const double c = b - at_b * (b - a) / (at_b - at_a), at_c = missed(c);
          if (at_c * at_b < 0)
            {
              a    = b;
              at_a = at_b;
            }
          else
            at_a *= 0.5;
          b    = c;
          at_b = at_c;
        }
      start.guess = given;
      if (!enough(at_b))
        here.not_reached += "The place across at which the springs hold the rail was not found. ";
      return here;
    }
  } // namespace


  WheelRailCase
  solve_wheel_rail(const ContactCase &one, const WheelRailCase *before, WheelRailStart &start)
  {
    WheelRailCase result =
      one.digits.forces == 3 ? solve_on_springs(one, start) : CaseSolver(one, before, start).run();
    result.along = millimetre * one.wheelset.position[0];
    return result;
  }

  WheelRailCase
  solve_wheel_rail(const ContactCase &one, const WheelRailCase *before)
  {
    WheelRailStart start;
    return solve_wheel_rail(one, before, start);
  }
} // namespace wheelrail
