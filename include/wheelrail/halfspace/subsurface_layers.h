#pragma once

#include <wheelrail/halfspace/influence.h>
#include <wheelrail/halfspace/problem.h>
#include <wheelrail/halfspace/subsurface.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// Stresses of one layer below all element centres, x fastest [Pa].
  struct LayerStresses
  {
    std::vector<HalfspaceStress> body1, body2;
  };

  /// The stresses of subsurface_stresses() below all element centres of a solution at once, layer by layer
  /// and in both bodies: in a layer they are products of influence matrices with pressure and tractions, done
  /// by FFT. Bodies with one Poisson ratio have the influence of pressure in common, and that of tractions
  /// with the other sign.
  class SubsurfaceLayers
  {
  public:
    SubsurfaceLayers(const HalfspaceSolution &solution,
                     const HalfspaceBody     &body1,
                     const HalfspaceBody     &body2);

    /// At `depth` [m] below the centres in each body. Throws InputError for a negative depth.
    LayerStresses
    at(double depth);

  private:
    /// What tractions and what pressure do at a depth in a body with the Poisson ratio.
    std::array<std::vector<HalfspaceStress>, 2>
    shares(double poisson_ratio, double depth);

    HalfspaceGrid               grid_;
    double                      poisson_ratio1_, poisson_ratio2_;
    InfluenceProducts           products_;
    InfluenceProducts::Spectrum loads_[3]; ///< of traction along x and y on body 1 and of the pressure
  };
} // namespace wheelrail
