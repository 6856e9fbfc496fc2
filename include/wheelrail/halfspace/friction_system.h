#pragma once

#include <wheelrail/halfspace/tangential.h>

#include <array>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// The equations t = P(t - s / b) of one tangential task and their linearisation, b the influence of an
  /// element on its own slip. Vectors hold (x, y) of the n contact elements, then the unknown creepages.
  class FrictionSystem
  {
  public:
    FrictionSystem(InfluenceProducts           &products,
                   const TangentialTask        &task,
                   const std::array<double, 2> &creepage);

    /// Grid indices of the contact elements, directions (0, 1) of unknown creepages.
    std::vector<int> elements, forces;
    /// Of the last linearisation: does the element slip (1), or its layer yield (2)?
    std::vector<char> slipping;
    /// The yield stress of the layer at the end of the step [Pa], and the plastic share of the slip, of an
    /// element of the last residual.
    std::pair<double, double>
    yielded(std::size_t element, const std::vector<double> &slip) const;

    /// The rms error of the equations over the largest P, and the slip.
    double
    residual(const std::vector<double> &t, std::vector<double> &slip);

    /// Sets up the linear equations at t and their right-hand side. When `first`, only elements at their
    /// bound slip.
    void
    linearise(const std::vector<double> &t,
              const std::vector<double> &slip,
              bool                       first,
              std::vector<double>       &rhs);

    /// Product with the linearised equations, and with an approximate inverse of them.
    void
    multiply(const std::vector<double> &dt, std::vector<double> &result);
    void
    precondition(const std::vector<double> &r, std::vector<double> &result);

    /// Clips tractions to the bound.
    void
    project(std::vector<double> &t) const;

    /// Largest missing force over (number of elements times largest bound times element area).
    double
    force_error(const std::vector<double> &t) const;

    /// From now on slip + c (t - before) replaces the slip, and creepages are held likewise; c = 0: no
    /// longer.
    void
    hold(double c, const std::vector<double> &before);

  private:
    /// A symmetric 2 x 2 operator by its spectra, complex or real ones.
    template <typename Kernel>
    void
    apply(const Kernel &xx, const Kernel &xy, const Kernel &yy, VectorField &in, VectorField &out);
    /// The slip of the tractions in work_, to image_.
    void
    apply_slip();
    /// The bound of each element at tractions and slip: friction's, or that of a layer which yields first.
    void
    set_bounds(const std::vector<double> &t, const std::vector<double> &slip);
    /// Whether the material of an element was in the next one of its order a step before.
    bool
    follows(std::size_t element) const
    {
      const int k = elements[element];
      return task_.carried && element + 1 < n_ && elements[element + 1] == k + 1 &&
             (k + 1) % task_.grid.mx != 0;
    }
    /// Force asked for less that of tractions t, over the element area [Pa].
    double
    missing_force(const std::vector<double> &t, std::size_t f) const;
    /// How much unknown creepages are held [Pa].
    double
    creepage_grip() const;
    /// Approximate inverse of the rows of the elements: slip by its diagonal, adhesion by FFT.
    void
    inverse_block(const double *r, std::vector<double> &result);
    /// Of the rows in adhesion: sums slip against rolling, as if no adhesion lay ahead, then takes the
    /// inverse symbol of A on the whole periodic grid.
    void
    inverse_adhesion(const double *r, std::vector<double> &result);
    void
    set_responses();

    InfluenceProducts          &products_;
    const TangentialTask       &task_;
    const SlipKernels          &kernels_;
    std::array<double, 2>       creepage_;
    std::size_t                 n_       = 0;
    double                      largest_ = 0;
    double                      b_       = 0; ///< diagonal, c included [1/Pa]
    double                      c_       = 0; ///< [1/Pa]
    std::vector<double>         before_;
    VectorField                 work_, image_;
    InfluenceProducts::Spectrum sx_, sy_;
    std::vector<double>         nx_, ny_, stiffness_; ///< slip direction (of traction), |s| / bound
    /// |t| = bound + rise |s| in slip; the yield stress that the material brings along. All in Pa.
    std::vector<double> bound_, rise_, brought_;
    enum Yielding : char
    {
      none,   ///< friction's limit lies below the yield stress
      yields, ///< from the yield stress on, with its rise
      least,  ///< at the least yield stress
      slides  ///< hardened up to friction's limit
    };
    std::vector<Yielding>            yielding_;
    std::vector<std::vector<double>> response_; ///< of the preconditioner to unit creepages
  };


  template <typename Kernel>
  void
  FrictionSystem::apply(const Kernel &xx,
                        const Kernel &xy,
                        const Kernel &yy,
                        VectorField  &in,
                        VectorField  &out)
  {
    products_.forward(in[0], sx_);
    products_.forward(in[1], sy_);
    for (std::size_t m = 0; m < sx_.size(); ++m)
      {
        const auto a = sx_[m], b = sy_[m];
        // symmetric: A_xy = A_yx (Cerruti 1882)
        sx_[m] = times(xx[m], a) + times(xy[m], b);
        sy_[m] = times(xy[m], a) + times(yy[m], b);
      }
    products_.backward(sx_, out[0]);
    products_.backward(sy_, out[1]);
  }
} // namespace wheelrail
