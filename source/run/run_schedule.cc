#include <wheelrail/model/model.h>
#include <wheelrail/run/run_schedule.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  RunSchedule::RunSchedule(const Scene &scene, const Model &model, const unsigned long stop_after_steps)
    : steps_(std::lround(model.duration / model.time_step))
    , record_every_(std::max<unsigned long>(1, steps_ / 1000))
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
