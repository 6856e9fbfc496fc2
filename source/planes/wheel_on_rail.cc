#include <wheelrail/planes/wheel_on_rail.h>

namespace wheelrail
{
  HalfspaceProblem
  wheel_on_rail(const HalfspaceSteels &steels, const FrictionLaw &friction, const double velocity)
  {
    HalfspaceProblem problem;
    // rail as body 1: n points down, a driving wheel has fx < 0 and xi > 0 (doc/theory/halfspace.md, Frame
    // and signs)
    problem.body1    = {steels.rail.shear_modulus(), steels.rail.poissons_ratio};
    problem.body2    = {steels.wheel.shear_modulus(), steels.wheel.poissons_ratio};
    problem.friction = friction;
    problem.velocity = velocity;
    return problem;
  }
} // namespace wheelrail
