#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <wheelrail/track/pad_damping.h>

#include <cmath>

namespace wheelrail
{
  std::complex<double>
  PadDamping::dynamic_stiffness(const std::complex<double> angular_frequency) const
  {
    const std::complex<double> iw        = std::complex<double>(0, 1) * angular_frequency;
    std::complex<double>       stiffness = 1. + iw * damper;
    for (const Branch &branch : branches)
      stiffness += branch.share * iw * branch.time / (1. + iw * branch.time);
    return stiffness;
  }


  double
  PadDamping::highest_stiffness() const
  {
    double sum = 1;
    for (const Branch &branch : branches)
      sum += branch.share;
    return sum;
  }


  PadDamping
  matched_damper(const double loss_factor, const double frequency)
  {
    return {loss_factor / (2 * M_PI * frequency), {}};
  }


  PadDamping
  constant_loss(const double loss_factor)
  {
    constexpr double relaxation[3] = {500. / 6, 500, 500. * 6}; // [Hz]
    constexpr int    samples       = 40;
    // (Im - loss Re) of 1 + sum of shares is zero at every frequency
    dealii::SymmetricTensor<2, 3> normal;
    dealii::Tensor<1, 3>          right;
    for (int k = 0; k <= samples; ++k)
      {
        const double frequency =
          constant_loss_from * std::pow(constant_loss_to / constant_loss_from, double(k) / samples);
        double row[3];
        for (int i = 0; i < 3; ++i)
          {
            const double x = frequency / relaxation[i];
            row[i]         = (x - loss_factor * x * x) / (1 + x * x);
          }
        for (int i = 0; i < 3; ++i)
          {
            right[i] += loss_factor * row[i];
            for (int j = 0; j <= i; ++j)
              normal[i][j] += row[i] * row[j];
          }
      }
    const dealii::Tensor<1, 3> share = dealii::invert(normal) * right;
    PadDamping                 damping;
    for (int i = 0; i < 3; ++i)
      damping.branches.push_back({share[i], 1 / (2 * M_PI * relaxation[i])});
    return damping;
  }
} // namespace wheelrail
