#pragma once

namespace wheelrail
{
  /// Finds the force to press with under which the contacts of a wheel carry a vertical load: secants, from
  /// that load on, inside what is left.
  class LoadSearch
  {
  public:
    explicit LoadSearch(const double load)
      : load_(load)
      , pressed_(load)
    {
    }

    /// To be tried now [N].
    double
    pressed() const
    {
      return pressed_;
    }

    /// Tells what came of it [N]; whether it is within 1e-4 of the load.
    bool
    carried(double vertical);

    /// By how much that missed the load, over the load.
    double
    missed() const
    {
      return missed_ / load_;
    }

  private:
    double load_, pressed_, before_ = 0, missed_ = 0;
    double slope_ = 1;          ///< of the vertical force over the one that presses
    double low_ = 0, high_ = 0; ///< between which it lies; 0: not known [N]
    int    passed_ = 0;         ///< how often in a row a secant led beyond a bound
  };

  /// Finds the creepage at which a force or torque that grows with it is reached: steps that grow until the
  /// sign changes, then secants inside what is left. What is searched may move a little meanwhile.
  class CreepageSearch
  {
  public:
    explicit CreepageSearch(const double first)
      : creepage_(first)
    {
    }

    /// To be tried now.
    double
    creepage() const
    {
      return creepage_;
    }

    /// False: a locked wheel (-1), or one twice as fast (1), still misses.
    bool
    carried() const
    {
      return carried_;
    }

    /// Tells what came of it, over what was asked for: positive when it was too much.
    void
    missed(double miss);

  private:
    double creepage_, step_ = 1e-4;
    double before_ = 0, miss_before_ = 0;
    double low_ = -1, high_ = 1; ///< between which it lies
    bool   below_ = false, above_ = false, first_ = true, carried_ = true;
    int    passed_ = 0; ///< how often in a row a secant led beyond a bound
  };
} // namespace wheelrail
