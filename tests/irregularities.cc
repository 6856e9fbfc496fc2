// label: fast

// Irregularities of running surfaces: their shapes, the surface that they make of a section, what a wheel of
// revolution is along the track, nodes that are moved, and the force of a slope that the contact carries as
// an offset.
#include "parallel.h"
#include "scenes/contact.h"

#include <wheelrail/geometry/irregular_shapes.h>
#include <wheelrail/geometry/running_surfaces.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  constexpr double radius = 0.46;

  std::shared_ptr<const Irregularities>
  list_of(Irregularity one)
  {
    return std::make_shared<const Irregularities>(Irregularities{std::move(one)});
  }

  struct Named
  {
    std::string  name;
    Irregularity shape;
    double       deepest; ///< [m]
  };

  std::vector<Named>
  all_shapes()
  {
    const IrregularSize size{0.1, 2e-3, 40e-3, 20e-3, 0.1e-3};
    const double        flat      = radius - std::sqrt(radius * radius - 0.25 * 40e-3 * 40e-3);
    IrregularSize       flat_size = size;
    flat_size.depth               = flat;
    return {{"dent", dent(size), 0.1e-3},
            {"squat", squat(size), 0.1e-3},
            {"corrugation", corrugation(size, 10e-3), 0.1e-3},
            {"dipped joint", dipped_joint(size), 0.1e-3},
            {"fresh flat", fresh_flat(flat_size, radius), flat},
            {"rounded flat", rounded_flat(size), 0.1e-3},
            {"polygon", polygon(size, 20, radius), 0.1e-3}};
  }

  /// Depths as they are asked for, slopes as differences have them, nothing at the ends.
  BOOST_FIXTURE_TEST_CASE(test_shapes, test::Parallel)
  {
    for (const Named &one : all_shapes())
      {
        const Irregularity &shape   = one.shape;
        double              deepest = 0, slope_error = 0, steepest = 0;
        const double d = 1e-8; // curvature jumps at borders, where differences err by d times half the jump
        for (double u = shape.begin + 2 * d; u < shape.end - 2 * d; u += 0.13e-3)
          for (double x = -6e-3; x <= 10e-3; x += 0.5e-3)
            {
              const IrregularHeight h = shape.at(x, u);
              deepest                 = std::max(deepest, -h.height);
              steepest                = std::max({steepest, std::abs(h.along), std::abs(h.across)});
              bool kink               = false;
              for (const auto &[at, unused] : shape.kinks)
                kink = kink || std::abs(u - at) < 2 * d;
              if (kink)
                continue;
              const double along  = (shape.at(x, u + d).height - shape.at(x, u - d).height) / (2 * d),
                           across = (shape.at(x + d, u).height - shape.at(x - d, u).height) / (2 * d);
              slope_error = std::max({slope_error, std::abs(h.along - along), std::abs(h.across - across)});
            }
        for (const auto &[at, unused] : shape.kinks) // which samples may miss
          deepest = std::max(deepest, -shape.at(2e-3, at).height);
        BOOST_TEST(near(deepest, one.deepest, 2e-3 * one.deepest, one.name + ": depth [m]"));
        BOOST_TEST(
          near(slope_error, 0, 1e-5 * steepest + 1e-9, one.name + ": slopes are those of the heights"));
        if (one.name != "polygon")
          for (const double end : {shape.begin, shape.end})
            BOOST_TEST(
              near(shape.at(2e-3, end).height, 0, 1e-12, one.name + ": comes down to 0 at its ends [m]"));
        BOOST_TEST(shape.shortest > 0, one.name + ": tells how short it is");
      }
    const IrregularSize joint{0, 0, 1, 0, 1e-3};
    const auto          dipped = dipped_joint(joint);
    BOOST_TEST(near(dipped.at(0, -1e-12).along - dipped.at(0, 1e-12).along,
                    -8e-3,
                    1e-9,
                    "dipped joint: its surface turns by 8 depth/length"));
    const double depth = radius - std::sqrt(radius * radius - 0.25 * 60e-3 * 60e-3);
    const auto   flat  = fresh_flat({0, 0, 60e-3, 0, depth}, radius);
    BOOST_TEST(
      near(-flat.at(0, 0).height, 60e-3 * 60e-3 / (8 * radius), 2e-6, "fresh flat: length^2/(8 R) [m]"));
    double worst = 0;
    for (double angle = -0.06; angle <= 0.06; angle += 1e-3)
      worst = std::max(
        worst, std::abs((radius + flat.at(0, radius * angle).height) * std::cos(angle) - (radius - depth)));
    BOOST_TEST(near(worst, 0, 1e-15, "fresh flat: a plane [m]"));
  }

  FrameProfile
  arc_profile(const double arc, const bool wheel)
  {
    Segment segment;
    segment.name   = "arc";
    segment.kind   = Segment::Kind::arc;
    segment.radius = arc;
    const double x = 0.03, angle = std::asin(x / arc);
    // from the field side on: a rail below its top, a wheel above its lowest line
    segment.centre      = {0, wheel ? arc : -arc};
    segment.angle_start = wheel ? -M_PI / 2 + angle : M_PI / 2 - angle;
    segment.angle_end   = wheel ? -M_PI / 2 - angle : M_PI / 2 + angle;
    segment.start       = {x, (wheel ? 1 : -1) * (arc - arc * std::cos(angle))};
    segment.end         = {-x, segment.start.y};
    return FrameProfile(Curve({segment}), Placement(), ContactFrame());
  }

  RunningSurface
  crowned(const double arc, const bool wheel)
  {
    WheelPose pose;
    pose.nominal_radius = radius;
    return wheel ? RunningSurface(arc_profile(arc, true), ContactFrame(), pose, radius)
                 : RunningSurface(arc_profile(arc, false), ContactFrame(), Placement());
  }

  /// An even layer on a circle is a circle; a sloping one has the slopes that differences find.
  BOOST_FIXTURE_TEST_CASE(test_surface, test::Parallel)
  {
    for (const bool wheel : {false, true})
      {
        const std::string name = wheel ? "wheel" : "rail";
        const double      arc = 80e-3, layer = 1e-3;
        RunningSurface    surface = crowned(arc, wheel);
        Irregularity      even;
        even.end = 1;
        even.at  = [layer](double, double) { return IrregularHeight{layer, 0, 0}; };
        surface.set_irregularities(list_of(even), 0.5);
        double worst = 0;
        for (double s = -20e-3; s <= 20e-3; s += 1e-3)
          {
            const double R = arc + layer, n = std::sqrt(R * R - s * s) - arc;
            worst = std::max(worst, std::abs(surface.at(s, 0).n - (wheel ? -n : n)));
          }
        BOOST_TEST(near(worst, 0, 1e-9, name + ": a layer of 1 mm on a circle of 80 mm [m]"));

        surface.set_irregularities(list_of(dent({0, 3e-3, 40e-3, 25e-3, 0.3e-3})));
        double error = 0, steepest = 0;
        for (double s = -9e-3; s <= 9e-3; s += 0.7e-3)
          for (double z = -18e-3; z <= 18e-3; z += 1.1e-3)
            {
              const double        d = 1e-6;
              const SurfaceHeight h = surface.at(s, z);
              steepest              = std::max(steepest, std::abs(h.slope_along));
              error                 = std::max(
                {error,
                                 std::abs(h.slope - (surface.at(s + d, z).n - surface.at(s - d, z).n) / (2 * d)),
                                 std::abs(h.slope_along - (surface.at(s, z + d).n - surface.at(s, z - d).n) / (2 * d))});
            }
        BOOST_TEST(near(error, 0, 0.01 * steepest, name + ": slopes of a dent on it"));
        BOOST_TEST(surface.kinks().empty(), name + ": a dent has no kinks");
        const auto curved = surface.curvature(-3e-3, 0, 1e-4);
        BOOST_TEST(near(curved.along,
                        (wheel ? 1 / radius : 0) - 2 * M_PI * M_PI * 0.3e-3 / (40e-3 * 40e-3),
                        0.05,
                        name + ": curvature along in the middle of the dent [1/m]"));
      }
    // a wheel is closed: the same place after a turn
    RunningSurface wheel = crowned(80e-3, true);
    wheel.set_irregularities(list_of(rounded_flat({0.1, 0, 50e-3, 0, 0.2e-3})));
    BOOST_TEST(near(wheel.at(0, 0.1 + 2 * M_PI * radius).n, wheel.at(0, 0.1).n, 1e-12, "a turn later [m]"));
    BOOST_TEST(near(wheel.at(0, 0.1).n, 0.2e-3, 1e-12, "a flat lies above the round wheel [m]"));
  }

  /// A wheel is an exact circle along the track; the parabola errs by z^4/(8 R^3).
  BOOST_FIXTURE_TEST_CASE(test_circle, test::Parallel)
  {
    const RunningSurfaces surfaces = scenes::wheel_on_plane(radius, 0, 0.02);
    double                worst = 0, parabola = 0;
    for (double z = -60e-3; z <= 60e-3; z += 5e-3)
      {
        const double exact = radius - std::sqrt(radius * radius - z * z);
        worst              = std::max(worst, std::abs(surfaces.distance(2e-3, z) - exact));
        parabola           = std::max(parabola, std::abs(z * z / (2 * radius) - exact));
      }
    BOOST_TEST(near(worst, 0, 1e-13, "distance of a cylinder from a plane [m]"));
    BOOST_TEST(near(parabola,
                    std::pow(60e-3, 4) / (8 * std::pow(radius, 3)),
                    0.5e-6,
                    "what a parabola misses at 60 mm [m]"));
    const double approach = 0.1e-3, half = half_length_bound(approach, radius);
    BOOST_TEST(near(
      radius - std::sqrt(radius * radius - half * half), approach, 1e-16, "half a chord dips in so far [m]"));
    // a crowned wheel is a torus: at height y over the lowest line
    const RunningSurfaces torus = scenes::wheel_on_plane(radius, 80e-3, 0.02);
    double                error = 0;
    for (double z = -30e-3; z <= 30e-3; z += 5e-3)
      for (double s = -10e-3; s <= 10e-3; s += 2e-3)
        {
          const double r     = radius - 80e-3 + std::sqrt(80e-3 * 80e-3 - s * s);
          const double exact = radius - std::sqrt(r * r - z * z);
          error              = std::max(error, std::abs(torus.distance(s, z) - exact));
        }
    BOOST_TEST(near(error, 0, 1e-11, "distance of a torus from a plane [m]"));
  }

  /// Nodes that are moved lie on the surface; below they are moved less, deep inside not at all.
  BOOST_FIXTURE_TEST_CASE(test_moved, test::Parallel)
  {
    for (const bool wheel : {false, true})
      {
        const std::string name    = wheel ? "wheel" : "rail";
        RunningSurface    surface = crowned(80e-3, wheel);
        Irregularity      shape   = dent({0.02, 0, 40e-3, 25e-3, 0.5e-3});
        shape.carried             = CarriedBy::mesh;
        surface.set_irregularities(list_of(shape));
        BOOST_TEST(surface.moves_mesh(), name + ": the mesh carries it");
        double on = 0, half = 0, deep = 0;
        for (double s = -9e-3; s <= 9e-3; s += 1e-3)
          for (double z = 2e-3; z <= 38e-3; z += 2e-3)
            {
              const double n  = surface.smooth(s).n;
              const auto   at = [&](const double depth) {
                if (!wheel)
                  return Vector3{s, n - depth, z};
                const double r = radius - n - depth, angle = z / radius;
                return Vector3{s, radius - r * std::cos(angle), r * std::sin(angle)};
              };
              const Vector3 top = at(0), middle = at(0.5 * RunningSurface::blend_depth),
                            below = at(1.01 * RunningSurface::blend_depth);
              on                  = std::max(on, std::abs(surface.offset(surface.moved(top))));
              half                = std::max(
                half, std::abs(norm(surface.moved(middle) - middle) - 0.5 * norm(surface.moved(top) - top)));
              deep = std::max(deep, norm(surface.moved(below) - below));
            }
        BOOST_TEST(near(on, 0, 2e-7, name + ": moved nodes lie on the surface [m]"));
        BOOST_TEST(near(half, 0, 1e-12, name + ": half way down they are moved half as far [m]"));
        BOOST_TEST(deep == 0, name + ": below not at all");
        BOOST_TEST((surface.offset_slopes({0, 0, 0.01}).along == 0),
                   name + ": the contact carries none of it");
      }
  }

  /// A rigid wheel pressed into a rigid rail by penalty alone: its energy, and the force on the wheel.
  ContactSums
  pressed(const RunningSurfaces &surfaces, const Vector3 &move)
  {
    const double  h       = 0.5e-3;
    const Lattice lattice = scenes::make_lattice({-30e-3, 30e-3, h}, {-8e-3, 8e-3, h});
    Surface       wheel = scenes::rigid_surface(surfaces, lattice), rail = wheel;
    const auto    n = wheel.reference.size();
    rail.body       = Body::rail;
    rail.area.assign(n, h * h);
    for (unsigned int i = 0; i < lattice.n_along; ++i)
      for (unsigned int j = 0; j < lattice.n_lateral; ++j)
        rail.reference[lattice.index(i, j)] = {
          lattice.s_begin + j * h, 0, (lattice.first_station + static_cast<int>(i)) * h};
    std::vector<double> displacement(8 * n, 0.), velocity(8 * n, 0.);
    for (std::size_t k = 0; k < n; ++k)
      {
        rail.local[k]  = static_cast<int>(k);
        wheel.local[k] = static_cast<int>(n + k);
        for (int i = 0; i < 3; ++i)
          displacement[4 * (n + k) + i] = move[i];
      }
    ContactLaw law;
    law.stiffness = 1e14;
    Contact contact(surfaces, law, 25e-3, MPI_COMM_SELF);
    contact.prepare(rail, wheel);
    contact.move_window(0, 0);
    contact.gather(displacement.data(), velocity.data());
    return contact.evaluate(0);
  }

  /// Forces of the contact are those of its energy, and on a plane rail nothing pushes a wheel without
  /// friction along, whatever its shape.
  BOOST_FIXTURE_TEST_CASE(test_slope_force, test::Parallel)
  {
    const double depth = 0.05e-3, length = 40e-3, slope = M_PI * depth / length, d = 2e-6;
    for (const bool on_wheel : {false, true})
      {
        const std::string name     = on_wheel ? "wheel" : "rail";
        RunningSurfaces   surfaces = scenes::wheel_on_plane(radius, 0.3, 0.02);
        (on_wheel ? surfaces.wheel : surfaces.rail)
          .set_irregularities(list_of(dent({10e-3, 0, length, 0, -depth})));
        const Vector3     down{0, -60e-6, 0};
        const ContactSums here  = pressed(surfaces, down);
        const double      ahead = pressed(surfaces, down + Vector3{0, 0, d}).stored_energy,
                     behind     = pressed(surfaces, down - Vector3{0, 0, d}).stored_energy,
                     above      = pressed(surfaces, down + Vector3{0, d, 0}).stored_energy,
                     below      = pressed(surfaces, down - Vector3{0, d, 0}).stored_energy;
        const double whole      = slope * here.force[1];
        BOOST_TEST(here.force[1] > 1e4, name + ": it presses");
        BOOST_TEST(
          near(here.force[1], (below - above) / (2 * d), 1e-3 * here.force[1], name + ": force upwards [N]"));
        BOOST_TEST(near(here.force[2], (behind - ahead) / (2 * d), 0.03 * whole, name + ": force along [N]"));
        if (on_wheel)
          BOOST_TEST(near(here.force[2], 0, 0.03 * whole, "wheel: no force along on a plane rail [N]"));
        else
          BOOST_TEST(here.force[2] < -0.4 * whole, "rail: a rise pushes the wheel back");
      }
  }
} // namespace
