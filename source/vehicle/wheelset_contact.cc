#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/input/subject_checks.h>
#include <wheelrail/scene/one_wheel.h>
#include <wheelrail/vehicle/pair_root.h>
#include <wheelrail/vehicle/wheelset_contact.h>
#include <wheelrail/wheel/coarse_halfspaces.h>

#include <cmath>
#include <limits>
#include <string>

namespace wheelrail
{
  namespace
  {
    constexpr double shift_limit = 12e-3; ///< of Wheelset/Lateral shift [m]
    constexpr double yaw_limit   = 50e-3; ///< of Wheelset/Yaw [rad]

    /// What turns the axle: its torque, the traction coefficient as that of both wheels, or the creepage.
    AxleDrive
    axle_drive(const WheelOnAxle &right, const WheelOnAxle &left, const std::optional<double> &torque)
    {
      const auto driven = [](const WheelOnAxle &wheel) {
        return wheel.scene.traction_coefficient * wheel.load * wheel.geometry.contact.rolling_radius;
      };
      AxleDrive drive;
      drive.torque    = torque ? *torque : driven(right) + driven(left);
      drive.rate_held = !torque && right.scene.drive == Drive::rate;
      drive.creepage  = right.scene.creepage;
      return drive;
    }

    /// A wheelset whose pose can be changed.
    class PosedWheelset
    {
    public:
      PosedWheelset(const Scene                 &right,
                    const Scene                 &left,
                    const WheelsetProfiles      &profiles,
                    const std::optional<double> &torque,
                    const unsigned int           threads)
        : right_(right)
        , left_(left)
        , profiles_(profiles)
        , torque_(torque)
        , threads_(threads)
      {
      }

      /// In a pose; throws InputError where the profiles do not touch.
      WheelsetSolution
      solve(const Pair &pose) const
      {
        WheelsetSolution wheelset = placed(pose);
        WheelOnAxle     &right = wheelset.right, &left = wheelset.left;
        if (right_.rigid_axle)
          wheelset.axle = solve_axle(right, left, axle_drive(right, left, torque_), threads_);
        else
          {
            wheelset.axle.right = solve_alone(right, torque_);
            wheelset.axle.left  = solve_alone(left, torque_);
            wheelset.axle.rate  = std::numeric_limits<double>::quiet_NaN();
            sum_up(wheelset.axle);
          }
        wheelset.lateral_missed = wheelset.axle.lateral - wheelset.loads.lateral -
                                  right_.lateral_stiffness * (pose[0] - right_.lateral_shift);
        wheelset.yaw_missed = wheelset.axle.yaw_moment - right_.yaw_stiffness * (pose[1] - right_.yaw);
        return wheelset;
      }

      /// By how much the rolling radii of a pose miss the rolling line: (r_right - r_left) / (r_right +
      /// r_left) - b / R. Nothing where the profiles do not touch.
      std::optional<double>
      off_rolling_line(const double shift) const
      {
        try
          {
            const WheelsetSolution wheelset = placed({shift, right_.yaw});
            const double           right    = wheelset.right.geometry.contact.rolling_radius,
                         left               = wheelset.left.geometry.contact.rolling_radius;
            return (right - left) / (right + left) -
                   half_base(wheelset.right.geometry, wheelset.left.geometry) / right_.track_radius;
          }
        catch (const InputError &)
          {
            return {};
          }
      }

    private:
      WheelsetSolution
      placed(const Pair &pose) const
      {
        const auto wheel = [&](const Scene &scene, const SceneProfiles &profiles) {
          Scene at         = scene;
          at.lateral_shift = pose[0];
          at.yaw           = pose[1];
          return WheelOnAxle{at, make_geometry(at, profiles), at.wheel_load};
        };
        WheelsetSolution wheelset{wheel(right_, profiles_.right), wheel(left_, profiles_.left), {}, {}};
        wheelset.loads      = curve_loads(right_,
                                     wheelset.right.load,
                                     wheelset.left.load,
                                     half_base(wheelset.right.geometry, wheelset.left.geometry));
        wheelset.right.load = wheelset.loads.right;
        wheelset.left.load  = wheelset.loads.left;
        return wheelset;
      }

      Scene                        right_, left_;
      const WheelsetProfiles      &profiles_;
      const std::optional<double> &torque_;
      unsigned int                 threads_;
    };

    /// The lateral shift at which the rolling radii roll round the curve, or the nearest to it at which the
    /// profiles touch, and the yaw of the scene.
    Pair
    rolling_line(const PosedWheelset &wheelset, const double yaw)
    {
      const auto here = wheelset.off_rolling_line(0);
      if (!here || *here == 0)
        return {0, yaw};
      // the farther to the left, the larger the radius of the left-hand wheel
      const double step = std::copysign(0.5e-3, *here);
      double       near = 0, far = step;
      auto         there = wheelset.off_rolling_line(far);
      while (there && *there * *here > 0 && std::abs(far) < shift_limit)
        {
          near = far;
          far += step;
          there = wheelset.off_rolling_line(far);
        }
      while (std::abs(far - near) > 1e-5)
        {
          const double middle                        = 0.5 * (near + far);
          const auto   value                         = wheelset.off_rolling_line(middle);
          (value && *value * *here > 0 ? near : far) = middle;
        }
      return {near, yaw};
    }

    /// Tells the solutions of both wheels that they do not balance, and by how much, which says more than
    /// what else was not found in a pose that nothing holds.
    void
    print_unbalanced(WheelsetSolution &wheelset)
    {
      const Scene &pose = wheelset.right.scene;
      const bool   at_bound =
        std::abs(pose.lateral_shift) > 0.95 * shift_limit || std::abs(pose.yaw) > 0.95 * yaw_limit;
      const std::string what = "No shift and yaw were found at which the forces on the wheelset balance: " +
                               text("%.3g kN across and %.3g kN m about the vertical are left over. ",
                                    1e-3 * wheelset.lateral_missed,
                                    1e-3 * wheelset.yaw_missed) +
                               (at_bound ? "It went to the end of what is searched, 12 mm of shift and 50 "
                                           "mrad of yaw. "
                                         : "");
      for (auto *wheel : {&wheelset.axle.right, &wheelset.axle.left})
        if (*wheel)
          {
            (*wheel)->solution.coupling_converged = false;
            (*wheel)->solution.not_reached        = what;
          }
    }

    /// `fine` and `coarse`: the wheelset with bodies and elements of its scene, and see coarse_halfspaces().
    WheelsetSolution
    solve_balanced(const WheelsetSettings &scene, const PosedWheelset &fine, const PosedWheelset &coarse)
    {
      std::optional<WheelsetSolution> last; // in the pose that was tried last
      const auto                      missed = [&](const PosedWheelset &wheelset) {
        return [&](const Pair &pose) -> std::optional<Pair> {
          if (std::abs(pose[0]) > shift_limit || std::abs(pose[1]) > yaw_limit)
            return {};
          try
            {
              last              = wheelset.solve(pose);
              const double load = last->right.load + last->left.load,
                           base = half_base(last->right.geometry, last->left.geometry);
              return Pair{last->lateral_missed / load, last->yaw_missed / (load * base)};
            }
          catch (const InputError &)
            {
              return {};
            }
        };
      };
      PairSearch search{{0.1e-3, 0.2e-3}, {1e-3, 3e-3}, 3e-3, 40};
      const bool free = scene.lateral_stiffness == 0 && scene.yaw_stiffness == 0;
      const Pair given{scene.lateral_shift, scene.yaw};
      auto root = find_pair_root({free ? rolling_line(coarse, 0) : given, {}, {}}, search, missed(coarse));
      if (!root)
        return fine.solve(given);
      if (root->found)
        {
          search.enough     = 1e-4;
          search.most_calls = 12;
          root              = find_pair_root(*root, search, missed(fine), missed(coarse));
        }
      // a search that ends well ends in the pose that it tried last, with the elements of the scene
      const bool       ends_well = root && root->found;
      WheelsetSolution found     = root && !ends_well ? fine.solve(root->at) : std::move(*last);
      // forces of a narrow patch jump by some 1e-4 where elements come into contact
      constexpr double nearly = 1e-3;
      if (!ends_well && !(root && larger_magnitude(root->left) < nearly))
        print_unbalanced(found);
      return found;
    }
  } // namespace


  WheelRailLoad
  load_of_wheel(const WheelOnAxle &wheel, const double rate, const std::optional<double> &torque)
  {
    if (std::isfinite(rate))
      return rolling_load(wheel, rate);
    Scene scene        = wheel.scene;
    scene.wheel_load   = wheel.load;
    WheelRailLoad load = scene_load(scene, wheel.geometry);
    if (torque)
      {
        load.rate_held    = false;
        load.longitudinal = *torque / wheel.geometry.contact.rolling_radius;
      }
    return load;
  }


  std::optional<WheelRailSolution>
  solve_alone(const WheelOnAxle &wheel, const std::optional<double> &torque)
  {
    if (wheel.load == 0)
      return {};
    Scene scene      = wheel.scene;
    scene.wheel_load = wheel.load;
    return solve_wheel_rail(scene,
                            wheel.geometry,
                            load_of_wheel(wheel, std::numeric_limits<double>::quiet_NaN(), torque),
                            scene_offsets(scene));
  }


  double
  half_base(const SceneGeometry &right, const SceneGeometry &left)
  {
    const auto to_middle = [](const ContactGeometry &contact) {
      return contact.axis.middle.x - contact.frame.origin.x;
    };
    return 0.5 * (to_middle(right.contact) + to_middle(left.contact));
  }


  WheelsetSolution
  solve_wheelset(const Scene                 &right,
                 const Scene                 &left,
                 const WheelsetProfiles      &profiles,
                 const std::optional<double> &torque,
                 const unsigned int           threads)
  {
    const PosedWheelset wheelset(right, left, profiles, torque, threads);
    if (const std::string lifted = right.pose_balances ? lifted_in_curve(right) : ""; !lifted.empty())
      throw InputError(lifted +
                       ": the vehicle tips over, and no Wheelset/Pose = equilibrium exists; write given, "
                       "or change radius, cant or velocity");
    if (right.pose_balances)
      return solve_balanced(
        right,
        wheelset,
        PosedWheelset(coarse_halfspaces(right), coarse_halfspaces(left), profiles, torque, threads));
    return wheelset.solve({right.lateral_shift, right.yaw});
  }


  Scene
  single_wheel(const WheelsetSolution &wheelset, const bool left)
  {
    const WheelOnAxle     &wheel   = left ? wheelset.left : wheelset.right;
    const ContactGeometry &contact = wheel.geometry.contact;
    Scene                  scene   = wheel.scene;
    const double comes = 1 + path_curvature(scene) * (contact.axis.middle.x - contact.frame.origin.x);
    leave_wheelset(scene);
    scene.wheel_load = wheel.load;
    if (std::isfinite(wheelset.axle.rate))
      {
        scene.drive    = Drive::rate;
        scene.creepage = wheelset.axle.rate * contact.forward_radius / comes - 1;
      }
    return scene;
  }
} // namespace wheelrail
