#pragma once

#include <wheelrail/damage/wear_profile.h>
#include <wheelrail/dynamics/rolling.h>
#include <wheelrail/model/model.h>
#include <wheelrail/output/fields.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/sampling/steadiness.h>

#include <mpi.h>

#include <utility>

namespace wheelrail
{
  /// Collects the history of a run and forms the means over its last stretch.
  class Recorder
  {
  public:
    explicit Recorder(const Model &model);

    /// Adds a row: forces on the wheel, axle, contact, energies. `Rolling` must just have made a step
    /// with energy. Over irregular surfaces also the largest stresses of all ranks. Collective.
    void
    add(const Rolling &rolling, const Axle &axle, MPI_Comm communicator);

    /// Adds the figures of a patch, and what it wears off across the rail, to the means; they have rows of
    /// their own.
    void
    add_patch(const PatchFields &patch, const WearProfile &wear);

    /// The rows of add() and of add_patch() so far.
    struct State
    {
      History history, patches;
      History wear; ///< depth and work of each row of the patch across the rail, one after the other
    };
    const State &
    state() const
    {
      return state_;
    }
    void
    set_state(State state)
    {
      state_ = std::move(state);
    }

    /// Means, standard deviations and standard errors (KnownResult) over the stretch that the scene takes its
    /// means over, the number of separate patches in the last one added ("patches"), the rolled distance from
    /// which all reported figures are steady ("settled_after_m", null when one is not), and the largest swing
    /// of one of them in that stretch ("largest_swing", see settling()); and whether a run until steady has
    /// become so.
    void
    fill(Summary &summary, const Scene &scene) const;

    /// The stretch that a scene takes its means over, of the rows so far [m]: the steady one of a run that
    /// ends by itself, if it has come to that; around Run/Evaluate at as soon as the wheel has come so far,
    /// else the last one.
    Range
    averaging_stretch(const Scene &scene) const;

    /// Wear across the rail, means over averaging_stretch(); empty without rows.
    WearProfile
    wear(const Scene &scene) const;

    /// Whether the rows so far are enough for a run that ends by itself, see judge_steadiness().
    Steadiness
    steadiness(const Scene &scene) const;

  private:
    SteadyBasis
    basis(const Scene &scene) const;
    /// Whether rail or wheel have irregularities: the history then shows them under the wheel.
    bool
    irregular() const;
    void
    fill_settling(Summary &summary, const Steadiness &known) const;
    /// How many patches there are and how many cells lie across the highest pressure, at the end of a stretch
    /// [m].
    void
    fill_grid(Summary &summary, const Range &stretch) const;

    const Model &model_;
    State        state_;
  };
} // namespace wheelrail
