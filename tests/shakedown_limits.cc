// label: long

// Shakedown and ratcheting of a strip under a travelling Hertzian line load, at the program's own elements
// and laws: first yield, limits of shakedown without and with full slip (Melan's theorem; Johnson, Contact
// Mechanics, 1985, section 9.2), kinds of hardening, and Chaboche's law in both elements. Twenty passes each.

#include "scenes/rolled_strip.h"

#include "parallel.h"
#include "strip_steel.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

using namespace scenes;
using namespace wheelrail;
using test::near;

namespace
{
  const double k = test::strip_k;

  /// What grows per pass, the largest over depth [1].
  struct Growth
  {
    double strain, shear;
  };

  /// Passes over one strip.
  struct Passes
  {
    std::vector<Growth> each;
    Growth              late; ///< means of the second half
  };

  Passes
  roll(const std::string                &name,
       const LineLoad                   &load,
       const Setup                      &setup,
       const unsigned int                n,
       const std::optional<MaterialLaw> &law = std::nullopt)
  {
    RolledStrip            strip(load, setup, law);
    Passes                 passes;
    std::vector<StripPass> states = {{std::vector<double>(strip.depth.size(), 0.), {}}};
    states[0].shear               = states[0].strain;
    for (unsigned int i = 1; i <= n; ++i)
      {
        states.push_back(strip.pass());
        passes.each.push_back({growth(states[i - 1].strain, states[i].strain, 1),
                               growth(states[i - 1].shear, states[i].shear, 1)});
      }
    passes.late = {growth(states[n / 2].strain, states[n].strain, n - n / 2),
                   growth(states[n / 2].shear, states[n].shear, n - n / 2)};
    std::cout << "        " << name << ": " << load.peak / k << " k, traction " << load.traction
              << std::setprecision(3) << "; growth per pass [1e-6] of passes 2, 10, " << n << ": strain "
              << 1e6 * passes.each[1].strain << ", " << 1e6 * passes.each[9].strain << ", "
              << 1e6 * passes.each[n - 1].strain << "; shear " << 1e6 * passes.each[1].shear << ", "
              << 1e6 * passes.each[9].shear << ", " << 1e6 * passes.each[n - 1].shear << std::endl;
    BOOST_TEST(near(strip.scene.energy().error(), 0, 1e-3, "energy error"));
    return passes;
  }

  /// p0 over k at first yield.
  double
  first_yield(const double traction, const unsigned int cells)
  {
    RolledStrip strip({k, traction, cells, 24}, Setup());
    return std::sqrt(3.) / strip.largest_stresses()[0];
  }

  void
  first_yields()
  {
    BOOST_TEST(near(first_yield(0, 10) / 3.107, 1, 0.02, "first yield without friction over 3.107 k"));
    BOOST_TEST(near(first_yield(0.2, 10) / 2.936, 1, 0.02, "with full slip at 0.2, over 2.936 k"));
    // It begins at the surface; the nearest middles of elements lie half a cell deeper, where the stresses of
    // the half-space (integrals of the load's line forces) reach yield at 2.702 k.
    const double fine = first_yield(0.3, 20);
    BOOST_TEST(near(fine / 2.598, 1, 0.05, "at 0.3, 20 cells, over 2.598 k"));
    BOOST_TEST(near(fine / 2.702, 1, 0.01, "the same over that of the half-space at a/40"));
  }

  /// Five per cent below and above the limit of shakedown.
  void
  limit(const double traction, const double pressure)
  {
    const std::string text = " the limit, full slip at " + std::to_string(traction).substr(0, 3);
    const Passes      down = roll("below", {0.95 * pressure * k, traction}, test::strip_steel(), 20),
                 on        = roll("above", {1.05 * pressure * k, traction}, test::strip_steel(), 20);
    BOOST_TEST(down.each[1].strain > 1e-5, "flows at first below" + text);
    BOOST_TEST(near(down.each[19].strain / down.each[1].strain,
                    0,
                    1e-3,
                    "the last pass below" + text + ", over the second"));
    BOOST_TEST(down.each[19].strain < 0.1 * down.each[9].strain,
               "and growth has fallen tenfold since the tenth");
    BOOST_TEST(on.late.strain > 0.4 * on.each[1].strain,
               "passes 10 to 20 above" + text +
                 ", over the second: " + std::to_string(on.late.strain / on.each[1].strain));
  }

  void
  hardening()
  {
    const LineLoad load{3.6 * k, 0.2, 6};
    const Passes   perfect = roll("perfectly plastic", load, test::strip_steel(), 20),
                 kinematic = roll("kinematic, linear", load, test::strip_steel(10e9, 1), 20);
    BOOST_TEST(near(
      perfect.each[19].shear / perfect.each[9].shear, 1, 0.15, "without hardening shear goes on as it does"));
    BOOST_TEST(near(kinematic.each[19].shear / kinematic.each[1].shear,
                    0,
                    0.01,
                    "with linear kinematic hardening it ends, the last pass over the second"));
    const Passes isotropic = roll("isotropic", {4.2 * k, 0, 6}, test::strip_steel(21e9, 0), 20);
    BOOST_TEST(near(isotropic.each[19].strain / isotropic.each[1].strain,
                    0,
                    1e-3,
                    "isotropic hardening ends all flow, the last pass over the second"));
  }

  /// The rates of both elements where back stresses saturate below what the load asks for.
  void
  elements()
  {
    CyclicHardening h;
    h.yield_stress     = test::strip_yield_stress;
    h.moduli           = {25e9};
    h.rates            = {25e9 / (0.2 * test::strip_yield_stress)};
    Setup      one     = test::strip_steel();
    const auto law     = ChabocheLaw(one.material, h);
    const auto reduced = roll("Chaboche, reduced", {4.2 * k, 0.2}, one, 12, law);
    one.form           = ElementForm::full;
    const auto full    = roll("Chaboche, full", {4.2 * k, 0.2}, one, 12, law);
    BOOST_TEST(reduced.late.shear > 1e-5, "Chaboche's steel ratchets");
    BOOST_TEST(near(reduced.late.shear / full.late.shear, 1, 0.1, "rate of reduced over full"));
    BOOST_TEST(near(reduced.late.strain / full.late.strain, 1, 0.1, "the same of the accumulated strain"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(shakedown_limits, test::Parallel)
{
  first_yields();
  limit(0, 4);
  limit(0.2, 3.202);
  limit(0.3, 2.900);
  hardening();
  elements();
}
