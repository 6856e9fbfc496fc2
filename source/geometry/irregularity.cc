#include <wheelrail/geometry/irregularity.h>

#include <algorithm>

namespace wheelrail
{
  IrregularHeight
  height_at(const Irregularities          &irregularities,
            const double                   circumference,
            const double                   across,
            const double                   along,
            const std::optional<CarriedBy> carried)
  {
    IrregularHeight sum;
    for (const Irregularity &one : irregularities)
      {
        if (carried && one.carried != *carried)
          continue;
        const double middle = 0.5 * (one.begin + one.end);
        // of all turns of the wheel the one that comes nearest
        const double place =
          circumference > 0 ? middle + std::remainder(along - middle, circumference) : along;
        const bool beyond = place < one.begin || place > one.end;
        if (beyond && !one.endless)
          continue;
        const IrregularHeight here = one.at(across, std::clamp(place, one.begin, one.end));
        sum.height += here.height;
        sum.across += here.across;
        sum.along += beyond ? 0 : here.along;
      }
    return sum;
  }
} // namespace wheelrail
