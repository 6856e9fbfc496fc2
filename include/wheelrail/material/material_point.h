#pragma once

#include <wheelrail/material/material_law.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// Six components xx, yy, zz, yz, xz, xy of a strain [1] or a stress [Pa].
  using SixNumbers = std::array<double, 6>;

  /// Names of these components.
  constexpr std::array<const char *, 6> component_names = {"xx", "yy", "zz", "yz", "xz", "xy"};

  /// Where a point is driven to: each component by its strain or by its stress.
  struct PointTarget
  {
    SixNumbers          value{};     ///< strains (tensor components) [1] and stresses [Pa]
    std::array<bool, 6> of_stress{}; ///< whether the value is a stress
  };

  /// One point of a body, driven through strains and stresses by the law of the elements.
  class MaterialPoint
  {
  public:
    explicit MaterialPoint(const MaterialLaw &law);

    /// Goes to the target in one step of the law. Strains whose stresses are given are found by Newton's
    /// method to 1e-10 of the elastic stress of a strain of 0.001. Throws RunError when no strain gives these
    /// stresses.
    void
    go_to(const PointTarget &target);

    const SixNumbers &
    strain() const
    {
      return strain_;
    }
    /// [Pa]
    const SixNumbers &
    stress() const
    {
      return stress_;
    }
    SixNumbers
    plastic_strain() const;

    /// Integral of sqrt(2/3 dE_p : dE_p) [1].
    double
    accumulated() const
    {
      return accumulated_;
    }
    /// Integral of S : dE_p [J/m3], and what hardening stores of it.
    double
    plastic_work() const
    {
      return work_;
    }
    double
    hardening_energy() const
    {
      return hardening_;
    }

  private:
    /// What a strain leads to from the present history.
    struct Response
    {
      SixNumbers          stress{};
      std::vector<double> rows;
      double              accumulated = 0, work = 0, hardening = 0;
    };
    Response
    respond(const SixNumbers &strain) const;

    /// How the stresses that are asked for change with the strains that are `free`: a row for each of these.
    std::vector<std::vector<double>>
    slope_of_stress(const SixNumbers               &strain,
                    const Response                 &response,
                    const std::vector<std::size_t> &free,
                    const std::vector<double>      &miss) const;

    MaterialLaw         law_;
    std::vector<double> rows_; ///< the history
    SixNumbers          strain_{}, stress_{};
    double              accumulated_ = 0, work_ = 0, hardening_ = 0;
  };
} // namespace wheelrail
