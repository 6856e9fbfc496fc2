#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <wheelrail/solid/element_blocks.h>
#include <wheelrail/statics/band_cholesky.h>
#include <wheelrail/statics/swept_solver.h>

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <stdexcept>

// Exact solution of the coarse blocks (doc/theory/rolling.md, Static start, 4). A rail: a band matrix as wide
// as two sections. A wheel: equal sectors, in axes that turn with them, make a block-circulant matrix, which
// Fourier's series over the sectors splits into one band matrix for each harmonic.

namespace wheelrail
{
  namespace
  {
    using Complex   = std::complex<double>;
    using Stiffness = std::array<double, 24 * 24>; // row-major, row = 3 vertex + component

    /// Places of the corners of a section in an order that keeps neighbours near (Cuthill and McKee 1969).
    struct CornerOrder
    {
      std::vector<unsigned int> place; ///< of each corner
      unsigned int              band = 0;

      explicit CornerOrder(const SweptGrid &grid)
        : place(grid.n_corners())
      {
        // Band width of a section = largest distance of two corners of a block in this order; the cost of a
        // factor grows with the square of the whole band.
        dealii::DynamicSparsityPattern touching(grid.n_corners(), grid.n_corners());
        for (int b = 0; b < grid.n_blocks(); ++b)
          for (const unsigned int p : grid.corners(b))
            for (const unsigned int q : grid.corners(b))
              // corners of one block are coupled
              touching.add(p, q);
        std::vector<dealii::types::global_dof_index> order(place.size());
        dealii::SparsityTools::reorder_Cuthill_McKee(touching, order);
        std::copy(order.begin(), order.end(), place.begin());
        for (const auto &entry : touching)
          band = std::max(
            band, static_cast<unsigned int>(std::abs(int(place[entry.row()]) - int(place[entry.column()]))));
      }
    };

    /// Stiffness of a coarse block, each vertex in the directions of its section.
    Stiffness
    block_stiffness(const SweptGrid  &grid,
                    const int         block,
                    const int         column,
                    const Elasticity &material,
                    const ElementForm form)
    {
      // K of the element at rest [N/m], vertices 0 to 3 on the section before, 4 to 7 on that behind; columns
      // of a wheel are alike but for the directions
      const Stiffness K =
        element_stiffness(element_geometry(grid.coarse_vertices(block, column)), material, form);
      // rotations of displacements and forces alike, so that K stays symmetric
      const std::array<Vector3, 3> axes[2] = {grid.axes(column), grid.axes(column + 1)};
      Stiffness                    turned;
      for (int row = 0; row < 24; ++row)
        for (int at = 0; at < 24; ++at)
          {
            const int a = row / 3, b = at / 3;
            double    sum = 0;
            for (int k = 0; k < 3; ++k)
              for (int l = 0; l < 3; ++l)
                // A_a K_ab A_b': the axes of the section of each vertex
                sum += axes[a / 4][row % 3][k] * K[24 * (3 * a + k) + 3 * b + l] * axes[b / 4][at % 3][l];
            turned[24 * row + at] = sum;
          }
      return turned;
    }

    /// Adds the lower half of a block's stiffness for the vertices that are not held. Functions of vertices
    /// give the first of their rows, whether they are held, and the factor between two of them.
    template <typename Number, typename Row, typename Held, typename Factor>
    void
    add_stiffness(BandCholesky<Number> &matrix,
                  const Stiffness      &K,
                  const Row            &row,
                  const Held           &held,
                  const Factor         &factor)
    {
      for (int p = 0; p < 8; ++p)
        for (int q = 0; q < 8; ++q)
          {
            // lower half alone; rows and columns of held vertices stay empty, and hold() puts 1 on their
            // diagonal
            if (held(p) || held(q) || row(p) < row(q))
              continue;
            const Number share = factor(p, q);
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j)
                if (row(p) + i >= row(q) + j)
                  matrix(row(p) + i, row(q) + j) += share * K[24 * (3 * p + i) + 3 * q + j];
          }
    }

    /// The equations of a node that does not move.
    template <typename Number>
    void
    hold(BandCholesky<Number> &matrix, const std::size_t row)
    {
      for (int i = 0; i < 3; ++i)
        matrix(row + i, row + i) = 1;
    }

    class RailSolver : public SweptSolver
    {
    public:
      RailSolver(const SweptGrid                  &grid,
                 const Elasticity                 &material,
                 const ElementForm                 form,
                 const std::vector<unsigned char> &held,
                 const std::vector<Vector3>       &ground)
        : order_(grid)
        // band of 3 (corners + band of a section): unknowns of one section follow one another, blocks join
        // two
        , n_sections_(grid.n_sections())
      {
        const std::size_t n_corners = order_.place.size();
        matrix_ = BandCholesky<double>(3 * n_corners * n_sections_, 3 * (n_corners + order_.band) + 2);
        sorted_.resize(3 * n_corners * n_sections_);
        // 1. Elements, column by column along the rail
        for (int column = 0; column < grid.n_columns(); ++column)
          for (int b = 0; b < grid.n_blocks(); ++b)
            {
              const auto &corner = grid.corners(b);
              // vertices 0 to 3 and 4 to 7 of a block are the same corners of the section, one sector apart
              add_stiffness(
                matrix_,
                block_stiffness(grid, b, column, material, form),
                [&](const int v) { return index(corner[v % 4], column + v / 4); },
                [&](const int v) { return held[n_corners * (column + v / 4) + corner[v % 4]]; },
                // no phase: vertices of both sections are unknowns of their own
                [](int, int) { return 1.; });
            }
        // 2. Held nodes and springs to the ground
        for (int section = 0; section < n_sections_; ++section)
          for (unsigned int c = 0; c < n_corners; ++c)
            if (const std::size_t n = n_corners * section + c; held[n])
              hold(matrix_, index(c, section));
            else if (!ground.empty())
              for (int i = 0; i < 3; ++i)
                // diagonal springs of the ground [N/m]
                matrix_(index(c, section) + i, index(c, section) + i) += ground[n][i];
        // 3. L L', once a mesh
        matrix_.factorise();
      }

      void
      solve(std::vector<double> &x) override
      {
        // into the order of the band, solved there, and back
        exchange(x, [](double &from, double &to) { to = from; });
        matrix_.solve(sorted_.data());
        exchange(x, [](double &to, double &from) { to = from; });
      }

    private:
      std::size_t
      index(const unsigned int corner, const int section) const
      {
        return 3 * (order_.place.size() * section + order_.place[corner]);
      }

      template <typename Function>
      void
      exchange(std::vector<double> &x, const Function &function)
      {
        const std::size_t n_corners = order_.place.size();
        for (int section = 0; section < n_sections_; ++section)
          for (unsigned int c = 0; c < n_corners; ++c)
            for (int i = 0; i < 3; ++i)
              function(x[3 * (n_corners * section + c) + i], sorted_[index(c, section) + i]);
      }

      CornerOrder          order_;
      int                  n_sections_;
      BandCholesky<double> matrix_;
      std::vector<double>  sorted_;
    };

    /// Transforms over the sectors of a ring, of all unknowns of a section at once.
    class RingTransform
    {
    public:
      RingTransform(const int n_sectors, const int n_unknowns)
        // Layout: unknown fastest, sector slowest (stride n_unknowns, distance 1), so that a harmonic of all
        // unknowns follows in one piece. FFTW: X_m = sum x_k exp(-2 pi i m k/n), no factor 1/n.
        : real(fftw_alloc_real(std::size_t(n_sectors) * n_unknowns))
        , spectrum(fftw_alloc_complex(std::size_t(n_sectors / 2 + 1) * n_unknowns))
        , forward(fftw_plan_many_dft_r2c(1,
                                         &n_sectors,
                                         n_unknowns,
                                         real,
                                         nullptr,
                                         n_unknowns,
                                         1,
                                         spectrum,
                                         nullptr,
                                         n_unknowns,
                                         1,
                                         FFTW_ESTIMATE))
        , backward(fftw_plan_many_dft_c2r(1,
                                          &n_sectors,
                                          n_unknowns,
                                          spectrum,
                                          nullptr,
                                          n_unknowns,
                                          1,
                                          real,
                                          nullptr,
                                          n_unknowns,
                                          1,
                                          FFTW_ESTIMATE))
      {
      }
      RingTransform(const RingTransform &) = delete;
      RingTransform &
      operator=(const RingTransform &) = delete;
      ~RingTransform()
      {
        fftw_destroy_plan(forward);
        fftw_destroy_plan(backward);
        fftw_free(real);
        fftw_free(spectrum);
      }

      Complex *
      harmonic(const std::size_t first)
      {
        return reinterpret_cast<Complex *>(spectrum + first);
      }

      double       *real;
      fftw_complex *spectrum;
      fftw_plan     forward, backward;
    };

    class WheelSolver : public SweptSolver
    {
    public:
      WheelSolver(const SweptGrid                  &grid,
                  const Elasticity                 &material,
                  const ElementForm                 form,
                  const std::vector<unsigned char> &held)
        : order_(grid)
        , n_sectors_(grid.n_columns())
        , n_unknowns_(3 * grid.n_corners())
        , transform_(n_sectors_, n_unknowns_)
      {
        const std::size_t n_corners = grid.n_corners();
        // 1. The bore is held all around, or the matrix were not circulant
        for (std::size_t n = n_corners; n < held.size(); ++n)
          if (held[n] != held[n % n_corners])
            throw std::logic_error("a wheel is held at a part of a circle");
        // 2. Axes of each sector's section, and one sector's elements
        for (int k = 0; k < n_sectors_; ++k)
          axes_.push_back(grid.axes(k));
        std::vector<Stiffness> blocks;
        for (int b = 0; b < grid.n_blocks(); ++b)
          blocks.push_back(block_stiffness(grid, b, 0, material, form));
        // hermitian matrix of each harmonic, phase 2 pi m/n from sector to sector
        for (int m = 0; m <= n_sectors_ / 2; ++m)
          {
            // u_k = sum over m of U_m exp(i m 2 pi k/n): equal sectors, in axes that turn with them, leave
            // each m by itself; K_m = sum of blocks times exp(i (q - p) 2 pi m/n), p, q the sides of the
            // block. Real fields need m = 0 ... n/2.
            // band of one section: a sector is coupled to its neighbours by the phase alone, which adds no
            // unknowns
            auto &matrix = harmonics_.emplace_back(n_unknowns_, 3 * order_.band + 2);
            for (int b = 0; b < grid.n_blocks(); ++b)
              add(matrix, blocks[b], grid.corners(b), held, 2 * M_PI * m / n_sectors_);
            for (unsigned int c = 0; c < n_corners; ++c)
              if (held[c])
                hold(matrix, 3 * order_.place[c]);
            matrix.factorise();
          }
      }

      void
      solve(std::vector<double> &x) override
      {
        // in the directions of the track sectors would not be alike
        turn(x, [](const Vector3 &axis, double *of_track, double &own) {
          // components in the axes of the sector
          own = axis[0] * of_track[0] + axis[1] * of_track[1] + axis[2] * of_track[2];
        });
        // forces f_k to F_m; K_m U_m = F_m for each harmonic; displacements U_m back to u_k
        fftw_execute(transform_.forward);
        for (std::size_t m = 0; m < harmonics_.size(); ++m)
          harmonics_[m].solve(transform_.harmonic(m * n_unknowns_));
        fftw_execute(transform_.backward);
        std::fill(x.begin(), x.end(), 0.);
        turn(x, [this](const Vector3 &axis, double *of_track, const double own) {
          for (int i = 0; i < 3; ++i)
            // FFTW's transforms there and back multiply by n
            of_track[i] += axis[i] * own / n_sectors_;
        });
      }

    private:
      /// The part of a block in the matrix for displacements that turn by `phase` from sector to sector.
      void
      add(BandCholesky<Complex>             &matrix,
          const Stiffness                   &stiffness,
          const std::array<unsigned int, 4> &corner,
          const std::vector<unsigned char>  &held,
          const double                       phase) const
      {
        add_stiffness(
          matrix,
          stiffness,
          [&](const int v) { return 3 * order_.place[corner[v % 4]]; },
          [&](const int v) { return held[corner[v % 4]]; },
          // hermitian: the phases of (p, q) and (q, p) are conjugate, so that the lower half is enough
          [phase](const int p, const int q) { return std::polar(1., (q / 4 - p / 4) * phase); });
      }

      /// Calls a function for each axis of each node: with its three numbers in the directions of the track
      /// and the one along the axis.
      template <typename Function>
      void
      turn(std::vector<double> &x, const Function &function)
      {
        const std::size_t n_corners = order_.place.size();
        for (int k = 0; k < n_sectors_; ++k)
          for (unsigned int c = 0; c < n_corners; ++c)
            for (int i = 0; i < 3; ++i)
              function(axes_[k][i],
                       &x[3 * (n_corners * k + c)],
                       transform_.real[std::size_t(n_unknowns_) * k + 3 * order_.place[c] + i]);
      }

      CornerOrder                         order_;
      int                                 n_sectors_, n_unknowns_;
      RingTransform                       transform_;
      std::vector<std::array<Vector3, 3>> axes_; ///< of each section
      std::vector<BandCholesky<Complex>>  harmonics_;
    };
  } // namespace


  std::unique_ptr<SweptSolver>
  make_swept_solver(const SweptGrid                  &grid,
                    const Elasticity                 &material,
                    const ElementForm                 form,
                    const std::vector<unsigned char> &held,
                    const std::vector<Vector3>       &ground)
  {
    // a rail is open along the track, a wheel a closed ring
    if (grid.body() == Body::rail)
      return std::make_unique<RailSolver>(grid, material, form, held, ground);
    // springs of a wheel to the ground are left out: at a part of a circle they would spoil the circulant
    // matrix
    return std::make_unique<WheelSolver>(grid, material, form, held);
  }


  double
  swept_solver_memory(const SweptGrid &grid)
  {
    // numbers of the factors: unknowns times band
    const double n = 3. * grid.n_corners(), band = 3. * CornerOrder(grid).band;
    // n band^2-sized factors: complex ones for n/2 + 1 harmonics of a section, or one along all sections
    // [bytes]
    return grid.closed() ? sizeof(Complex) * (grid.n_columns() / 2 + 1) * n * band
                         : sizeof(double) * grid.n_sections() * n * (n + band);
  }
} // namespace wheelrail
