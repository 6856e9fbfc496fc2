#pragma once

#include <wheelrail/application/model.h>
#include <wheelrail/dynamics/rolling.h>
#include <wheelrail/output/fields.h>
#include <wheelrail/output/summary.h>

namespace wheelrail
{
  /// Collects the history of a run and forms the means over its last stretch.
  class Recorder
  {
  public:
    explicit Recorder(const Model &model);

    /// Adds a row: forces on the wheel, axle, contact, energies. `Rolling` must just have made a step
    /// with energy.
    void
    add(const Rolling &rolling, const Axle &axle);

    /// Adds the figures of a patch to the means; they have rows of their own.
    void
    add_patch(const PatchFields &patch);

    const History &
    history() const
    {
      return history_;
    }

    /// Means and standard deviations over the rows of the last `distance` [m].
    void
    fill(Summary &summary, double distance) const;

  private:
    void
    put(const std::string &name, const std::string &unit, double value);

    const Model        &model_;
    History             history_;
    std::vector<double> patch_distance_;
    std::vector<double> patch_area_, patch_width_, patch_length_, patch_shear_, patch_stick_, patch_pressure_,
      patch_fitted_, patch_along_, patch_lateral_;
    std::size_t column_ = 0;
  };

  /// Mean and standard deviation of the values whose distance is at least `from`.
  struct Mean
  {
    double mean = 0, deviation = 0;
  };
  Mean
  mean_from(const std::vector<double> &distance, const std::vector<double> &values, double from);
} // namespace wheelrail
