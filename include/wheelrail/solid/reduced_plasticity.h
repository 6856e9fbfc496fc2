#pragma once

#include <wheelrail/material/law.h>
#include <wheelrail/solid/element_blocks.h>
#include <wheelrail/solid/reduced_element.h>

// Plastic flow of the `reduced` hexahedron; see doc/theory/element.md.

namespace wheelrail::reduced
{
  /// What W elements remember of a law with a history.
  template <typename Law, int W>
  struct CellHistory
  {
    typename Law::template History<Simd<W>> point;                         ///< at the centre
    int                                     point_rows;                    ///< numbers of that
    V3<W> p[4] = {{0., 0., 0.}, {0., 0., 0.}, {0., 0., 0.}, {0., 0., 0.}}; ///< plastic amplitudes

    explicit CellHistory(const Law &law)
      : point(law)
      , point_rows(law.history_rows())
    {
    }

    void
    load(const double *rows)
    {
      point.load(rows);
      for (int k = 0; k < ElementBlocks::amplitude_rows; ++k)
        p[k / 3][k % 3].copy_from(rows + (point_rows + k) * W, std::experimental::vector_aligned);
    }
    void
    store(double *rows) const
    {
      point.store(rows);
      for (int k = 0; k < ElementBlocks::amplitude_rows; ++k)
        p[k / 3][k % 3].copy_to(rows + (point_rows + k) * W, std::experimental::vector_aligned);
    }
  };

  /// Shape of the yield surface between a stress that is uniform over the cell and one that varies
  /// linearly: n^2 + m^2 + coupling n m = 1, both relative to the fully plastic state. Between the exact
  /// surface of a plate, m = 1 - n^2, and a circle, so that beams of few layers bear their plastic moment;
  /// see doc/theory/element.md.
  constexpr double yield_coupling = 0.25;

  /// Returns the state of strain E and amplitudes p to the yield surface of the cell.
  ///
  /// Yield sees the stress at the centre and the hourglass stresses together, and both flow back by
  /// the same fraction, so that a cell whose centre yields keeps the tangent stiffness of flow in its
  /// hourglass patterns too, and a cell that bends about a stress-free centre bears no more than its
  /// fully plastic moment. Returns whether any lane flowed; only then was anything changed: the
  /// history, and `work`, to which the plastic work is added [J]. Q becomes the hourglass stresses of
  /// the trial state.
  template <int W, typename Law>
  inline bool
  return_to_yield(const Law       &law,
                  const Packed<W> &g,
                  const Simd<W> (&E)[6],
                  const V3<W> (&p)[4],
                  CellHistory<Law, W> &history,
                  V3<W> (&Q)[4],
                  Simd<W> &work)
  {
    namespace stdx = std::experimental;
    Simd<W>       deviator[6], hourglass;
    const Simd<W> n2     = law.trial(E, history.point, deviator);
    const double  factor = 1 + law.back_ratio;
    V3<W>         trial[4];
    for (int m = 0; m < 4; ++m)
      for (int k = 0; k < 3; ++k)
        trial[m][k] = p[m][k] - factor * history.p[m][k];
    hourglass_stress<W>(g, trial, law.elasticity, Q, hourglass);
    // 4/9 = 1/1.5^2: a plate is fully plastic at 1.5 times the moment of first yield at its faces
    // and `hourglass` has the factor V / 3; lanes that fill up a batch have no volume and no stress
    const Simd<W> m2    = (4. / 3) * hourglass / stdx::max(g.volume(), Simd<W>(1e-300));
    const Simd<W> limit = law.limit(history.point);
    if (!stdx::any_of((1 + 0.5 * yield_coupling) * (n2 + m2) > limit * limit))
      return false; // since 2 n m <= n^2 + m^2
    const Simd<W> equivalent = square_root(n2 + m2 + yield_coupling * square_root(n2 * m2));
    if (!stdx::any_of(equivalent > limit))
      return false;

    const auto flow = law.flow(equivalent, deviator, history.point);
    Simd<W>    relative(0.), back(0.); // works of Q by stress relative to back stress and by the latter
    for (int m = 0; m < 4; ++m)
      for (int k = 0; k < 3; ++k)
        {
          relative += Q[m][k] * trial[m][k];
          back += Q[m][k] * (history.p[m][k] + 0.5 * flow.part * trial[m][k]);
          history.p[m][k] += flow.part * trial[m][k];
        }
    work += g.volume() * flow.work + flow.part * (flow.middle * relative + law.back_ratio * back);
    return true;
  }
} // namespace wheelrail::reduced
