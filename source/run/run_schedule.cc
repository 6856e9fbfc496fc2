#include <wheelrail/model/model.h>
#include <wheelrail/run/run_schedule.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Rows of the history over the whole path: a thousand, or sixteen a cell where means over cells are to
    /// tell whether the run is steady.
    unsigned long
    rows(const Scene &scene)
    {
      constexpr double usual = 1000, of_cell = 16;
      return static_cast<unsigned long>(
        scene.until_steady() ? std::max(usual, std::ceil(of_cell * scene.path() / scene.cell_size)) : usual);
    }

    /// How many of these rows lie on the length of a cell, about.
    unsigned long
    rows_of_cell(const Scene &scene, const unsigned long steps, const unsigned long record_every)
    {
      return std::max(1L,
                      std::lround(double(steps) * scene.cell_size / (scene.path() * double(record_every))));
    }
  } // namespace


  RunSchedule::RunSchedule(const Scene &scene, const Model &model, const unsigned long stop_after_steps)
    : steps_(std::lround(model.duration / model.time_step))
    , record_every_(std::max<unsigned long>(1, steps_ / rows(scene)))
    , judge_every_(scene.until_steady() ? rows_of_cell(scene, steps_, record_every_) * record_every_ : 0)
    , ticks_(scene.ticks)
    , stop_after_(stop_after_steps)
    , evaluate_at_(scene.evaluate_at)
  {
  }


  bool
  RunSchedule::record(const unsigned long step) const
  {
    return step % record_every_ == 0 || step == 1 || step == steps_;
  }


  bool
  RunSchedule::judge(const unsigned long step) const
  {
    return judge_every_ > 0 && step % judge_every_ == 0;
  }


  bool
  RunSchedule::tick(const unsigned long step) const
  {
    return step * ticks_ / steps_ > (step - 1) * ticks_ / steps_;
  }


  bool
  RunSchedule::listen(const unsigned long step) const
  {
    return step % 20 == 0;
  }


  bool
  RunSchedule::break_off(const unsigned long step) const
  {
    return step == stop_after_;
  }


  bool
  RunSchedule::evaluate(const double before, const double now) const
  {
    return before < evaluate_at_ && now >= evaluate_at_;
  }
} // namespace wheelrail
