// Time of the geometry of the profiles: evaluations, closest points, undeformed distances, contact points
// with the roll of the wheelset.

#include <wheelrail/geometry/contact_geometry.h>

#include <chrono>
#include <cstdio>
#include <functional>

using namespace wheelrail;

namespace
{
  /// Prints the time of one of `times` calls, and a sum that depends on all of them.
  void
  row(const char *name, const int times, const std::function<double(int)> &call)
  {
    const auto start = std::chrono::steady_clock::now();
    double     sum   = 0;
    for (int i = 0; i < times; ++i)
      sum += call(i);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%-40s %12.3f us   sum %.6g\n", name, 1e6 * seconds / times, sum);
  }
} // namespace


int
main()
{
  const RailProfile      rail  = rail_profile("54E1");
  const WheelProfile     wheel = wheel_profile("S1002");
  const TrackDimensions  track;
  const ContactGeometry  contact = find_contact(rail, wheel, track, {0, RollMode::none});
  const FrameProfile     tread(wheel.tread, contact.wheel, contact.frame);
  const FrameProfile     head(rail.head, contact.rail, contact.frame);
  constexpr unsigned int n = 100000;
  row("point of S1002", n, [&](const int i) { return wheel.tread.at(9e-5 * i).position.y; });
  row("closest point of S1002", n, [&](const int i) {
    return wheel.tread.closest({0.06 - 1.2e-6 * i, 0.001});
  });
  row("undeformed distance", n, [&](const int i) {
    return undeformed_distance(tread, head, -0.02 + 4e-7 * i);
  });
  row("contact point with roll", 10, [&](const int i) {
    return find_contact(rail, wheel, track, {1e-4 * i, RollMode::from_contact}).rolling_radius;
  });
}
