#pragma once

#include <wheelrail/contactfiles/curved_patch.h>
#include <wheelrail/halfspace/kernels.h>

#include <vector>

namespace wheelrail
{
  /// Solves patches of a case of module 1 at a pose of its wheelset, seen on the right-hand side.
  class PatchSolver
  {
  public:
    /// All must outlive it; `before`: the case from which shifts and transient rolling go on, null: none.
    PatchSolver(const ContactCase   &one,
                const RailShape     &rail,
                const WheelShape    &wheel,
                const WheelRailPose &pose,
                const WheelRailCase *before);

    /// The patch of that number, without friction where it is not to roll. `last`: a solution like it, null:
    /// none; `kernels`: those of its influence functions afterwards, too.
    WheelRailPatch
    solve(const std::vector<PatchPlace> &places,
          bool                           rolls,
          std::size_t                    number,
          const HalfspaceSolution       *last,
          KeptKernels                   &kernels) const;

  private:
    /// The rows of a patch in its plane, or on its curved surface of reference.
    CurvedRows
    rows_of(const PatchPlace &place, const HalfspaceGrid &grid, WheelRailPatch &patch) const;
    /// Where a patch lies, in the axes of track, rail and wheel.
    void
    set_place(const PatchPlace &place, WheelRailPatch &patch) const;
    void
    set_motion(const PatchPlace      &place,
               const CurvedRows      &rows,
               const SurfaceDistance &surfaces,
               HalfspaceProblem      &problem,
               WheelRailPatch        &patch) const;
    /// The angle of a surface of the patch in the axes of the wheel's section.
    double
    wheel_angle(PatchPlace place, double angle) const;
    /// The state that patches of the case before leave under this one; its grid is enlarged over it. Where
    /// an earlier patch has split, the last of its parts sees what lies on its own grid alone, as in
    /// CONTACT.
    HalfspaceSolution
    earlier_state(const std::vector<PatchPlace> &places,
                  std::size_t                    number,
                  WheelRailPatch                &patch,
                  HalfspaceGrid                 &grid) const;
    void
    set_forces(const PatchPlace &place, const CurvedRows &rows, WheelRailPatch &patch) const;

    const ContactCase   &one_;
    const RailShape     &rail_;
    const WheelShape    &wheel_;
    const WheelRailPose &pose_;
    const WheelRailCase *before_;
    bool                 shift_, transient_;
  };

  /// The case seen in a mirror along the track.
  void
  mirror(WheelRailCase &result);
} // namespace wheelrail
