#pragma once

#include <wheelrail/solid/part.h>

#include <utility>
#include <vector>

namespace wheelrail
{
  /// Boundaries that do not move, such as the rail's foot and ends: their nodes stay where they are.
  class Supports : public Part
  {
  public:
    explicit Supports(std::vector<Boundary> marks)
      : marks_(std::move(marks))
    {
    }

    void
    prepare(const Solid &solid, std::vector<NodeInertia> &inertia) override;

  private:
    std::vector<Boundary> marks_;
  };

  /// The weight of one body: a steady force on its nodes, and its potential energy [J], zero where nothing is
  /// displaced.
  class Weight : public Part
  {
  public:
    /// `gravity`: [m/s2], along -Y.
    Weight(const Body body, const double gravity)
      : body_(body)
      , gravity_(gravity)
    {
    }

    void
    prepare(const Solid &solid, std::vector<NodeInertia> &inertia) override;
    void
    enter(EnergyBalance &energies) override;
    void
    add_forces(const Instant &now, Solid &solid) override;

  private:
    Body        body_;
    double      gravity_;
    EnergyTerm *potential_ = nullptr;
  };
} // namespace wheelrail
