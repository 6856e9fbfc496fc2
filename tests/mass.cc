// Mass, centre of gravity and inertia of the swept meshes from their lumped masses against the exact
// sections, and what the chords of coarse blocks cost.

#include <wheelrail/model/model.h>

#include "parallel.h"
#include "section_properties.h"
#include "small_scene.h"

#include <array>
#include <cmath>
#include <map>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  const std::string body_name[2] = {"rail", "wheel"};
  constexpr double  density      = 7900;

  /// Exact integrals over a body of density 1.
  struct Exact
  {
    double  volume = 0, inertia = 0; ///< about the axle (wheel only)
    Vector3 centre{};
  };

  /// Integrals of 1, x, y, y x, y^3 over a section (y the radius of the wheel) whose blocks are divided
  /// into m x m quadrilaterals with straight sides; Gauss's rule with 3 x 3 points is exact on them.
  std::array<double, 5>
  polygon_integrals(const Section &section, const unsigned int m)
  {
    const double place[3]  = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)},
                 weight[3] = {5. / 18, 8. / 18, 5. / 18};
    std::array<double, 5> sums{};
    const auto            add_quadrilateral = [&](const std::array<Point2, 4> &p) {
      for (int g = 0; g < 9; ++g)
        {
          const double x = place[g % 3], y = place[g / 3];
          const Point2 along = (1 - y) * (p[1] - p[0]) + y * (p[3] - p[2]),
                       up    = (1 - x) * (p[2] - p[0]) + x * (p[3] - p[1]);
          const Point2 q = (1 - y) * ((1 - x) * p[0] + x * p[1]) + y * ((1 - x) * p[2] + x * p[3]);
          const double dA   = weight[g % 3] * weight[g / 3] * std::abs(cross(along, up));
          const double f[5] = {1, q.x, q.y, q.x * q.y, q.y * q.y * q.y};
          for (int k = 0; k < 5; ++k)
            sums[k] += dA * f[k];
        }
    };
    for (unsigned int b = 0; b < section.blocks.size(); ++b)
      for (unsigned int i = 0; i < m; ++i)
        for (unsigned int j = 0; j < m; ++j)
          {
            const auto at = [&](unsigned int k, unsigned int l) {
              return section.position(b, double(i + k) / m, double(j + l) / m);
            };
            add_quadrilateral({at(0, 0), at(1, 0), at(0, 1), at(1, 1)});
          }
    return sums;
  }

  /// The same over the exact section: the chords' error of order 1/m^2 extrapolated away.
  std::array<double, 5>
  section_integrals(const Section &section)
  {
    static std::map<const Section *, std::array<double, 5>> known; // sections of this test live to its end
    if (const auto found = known.find(&section); found != known.end())
      return found->second;
    const auto coarse = polygon_integrals(section, 24);
    auto       fine   = polygon_integrals(section, 48);
    for (int k = 0; k < 5; ++k)
      fine[k] += (fine[k] - coarse[k]) / 3;
    return known[&section] = fine;
  }

  /// The rail as a prism, the wheel as a solid of revolution (Pappus).
  Exact
  exact_body(const SweepPlan &plan, const AxleData &axle, const Body body)
  {
    Exact exact;
    if (body == Body::rail)
      {
        const auto   I      = section_integrals(plan.rail);
        const double length = plan.rail_stations.back() - plan.rail_stations.front();
        exact.volume        = I[0] * length;
        exact.centre        = {
                 I[1] / I[0], I[2] / I[0], 0.5 * (plan.rail_stations.back() + plan.rail_stations.front())};
        return exact;
      }
    const auto I  = section_integrals(plan.wheel);
    exact.volume  = 2 * M_PI * I[2];
    exact.inertia = 2 * M_PI * I[4];
    exact.centre  = axle.centre + (I[3] / I[2]) * axle.axis;
    return exact;
  }

  /// Relative errors of mass and inertia, and of the centre [m].
  struct Errors
  {
    double mass = 0, inertia = 0, centre = 0;
  };

  Errors
  mass_errors(const Model &model, const Body body, MPI_Comm communicator)
  {
    const Exact          exact = exact_body(model.discretization->plan(), model.axle, body);
    const MassProperties mass  = mass_properties(model.solid, body, model.axle.centre, communicator);
    Errors               errors;
    errors.mass   = mass.mass / (density * exact.volume) - 1;
    errors.centre = norm(mass.centre - exact.centre);
    if (body == Body::wheel)
      errors.inertia = mass.inertia / (density * exact.inertia) - 1;
    return errors;
  }

  /// Mass against that of the coarse blocks with straight sides: by refinement next to nothing changes.
  double
  polygon_mass_error(const Model &model, const Body body, const Errors &errors)
  {
    const SweepPlan &plan    = model.discretization->plan();
    const Section   &section = body == Body::rail ? plan.rail : plan.wheel;
    const auto       polygon = polygon_integrals(section, 1), exact = section_integrals(section);
    if (body == Body::rail)
      return (1 + errors.mass) * exact[0] / polygon[0] - 1;
    const double sector = 2 * M_PI / plan.sectors;
    return (1 + errors.mass) * exact[2] * sector / (polygon[2] * std::sin(sector)) - 1;
  }

  void
  mass_properties_converge(const Model &model)
  {
    const test::SectionProperties outline = test::section_properties(rail_profile("54E1").outline);
    BOOST_TEST(near(section_integrals(model.discretization->plan().rail)[0] / outline.area,
                    1,
                    2e-3,
                    "area of the rail's blocks"));

    const Model fine = test::small_model(MPI_COMM_WORLD, 4e-3, 8e-3);
    // what the chords of the coarse blocks cost, most of it at the concave fillets, whose rows are 8 mm tall
    // at most
    const double mass_limit[2] = {3e-3, 2e-3}, centre_limit[2] = {1.5e-3, 0.5e-3};
    for (const Body body : {Body::rail, Body::wheel})
      {
        const int          k = static_cast<int>(body);
        const std::string &n = body_name[k];
        const Errors       e = mass_errors(model, body, MPI_COMM_WORLD),
                     f       = mass_errors(fine, body, MPI_COMM_WORLD);
        BOOST_TEST(near(e.mass, 0, mass_limit[0], n + ": mass error, 16 mm blocks"));
        BOOST_TEST(near(f.mass, 0, mass_limit[1], n + ": mass error, 8 mm blocks"));
        BOOST_TEST(
          near(e.centre, 0, centre_limit[0], n + ": error of the centre of gravity [m], 16 mm blocks"));
        BOOST_TEST(
          near(f.centre, 0, centre_limit[1], n + ": error of the centre of gravity [m], 8 mm blocks"));
        BOOST_TEST(near(polygon_mass_error(model, body, e),
                        0,
                        4e-3,
                        n + ": mass against that of straight-sided blocks, 16 mm"));
        BOOST_TEST(near(polygon_mass_error(fine, body, f),
                        0,
                        5e-4,
                        n + ": mass against that of straight-sided blocks, 8 mm"));
        if (body == Body::wheel)
          {
            BOOST_TEST(near(e.inertia, 0, 10e-3, n + ": error of the inertia about the axle, 16 mm blocks"));
            BOOST_TEST(near(f.inertia, 0, 3e-3, n + ": error of the inertia about the axle, 8 mm blocks"));
          }
        // rows of the web are 8 mm tall in both meshes, and so are those in the fillets of the disc, whose
        // surplus is all that the mass of the wheel is off
        BOOST_TEST(std::abs(f.mass) < (body == Body::rail ? 0.6 : 1) * std::abs(e.mass),
                   n + ": the mass error falls with the blocks");
        BOOST_TEST(f.centre < 0.5 * e.centre, n + ": the error of the centre falls with the blocks");
      }
  }

  /// Straight-sided blocks come to the exact section by the square of their size.
  void
  chords_converge(const SweepPlan &plan)
  {
    for (const Body body : {Body::rail, Body::wheel})
      {
        const Section &section = body == Body::rail ? plan.rail : plan.wheel;
        const auto     exact   = section_integrals(section);
        const int      moment  = body == Body::rail ? 0 : 4;
        // the rail's small roundings come into play only with short chords
        const double e1 = polygon_integrals(section, 8)[moment] / exact[moment] - 1;
        const double e2 = polygon_integrals(section, 16)[moment] / exact[moment] - 1;
        BOOST_TEST(near(e1 / e2,
                        4,
                        1,
                        body_name[static_cast<int>(body)] + (moment == 0 ? ": area" : ": third moment") +
                          " error of 2 mm chords over that of 1 mm"));
      }
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(mass, test::Parallel)
{
  const Model model = test::small_model(MPI_COMM_WORLD, 4e-3);
  chords_converge(model.discretization->plan());
  mass_properties_converge(model);
}
