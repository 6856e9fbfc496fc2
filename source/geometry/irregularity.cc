#include <wheelrail/geometry/irregularity.h>

#include <algorithm>

namespace wheelrail
{
  namespace
  {
    void
    add(const Irregularity &one,
        const double        circumference,
        const double        across,
        const double        along,
        IrregularHeight    &sum)
    {
      const double middle = 0.5 * (one.begin + one.end);
      // of all turns of the wheel the one that comes nearest
      const double place = circumference > 0 ? middle + std::remainder(along - middle, circumference) : along;
      const bool   beyond = place < one.begin || place > one.end;
      if (beyond && !one.endless)
        return;
      const IrregularHeight here = one.at(across, std::clamp(place, one.begin, one.end));
      sum.height += here.height;
      sum.across += here.across;
      sum.along += beyond ? 0 : here.along;
    }
  } // namespace


  IrregularHeight
  height_at(const Irregularities &irregularities,
            const double          circumference,
            const double          across,
            const double          along)
  {
    IrregularHeight sum;
    for (const Irregularity &one : irregularities)
      add(one, circumference, across, along, sum);
    return sum;
  }


  IrregularHeight
  height_at(const Irregularities &irregularities,
            const CarriedBy       carried,
            const double          circumference,
            const double          across,
            const double          along)
  {
    IrregularHeight sum;
    for (const Irregularity &one : irregularities)
      if (one.carried == carried)
        add(one, circumference, across, along, sum);
    return sum;
  }
} // namespace wheelrail
