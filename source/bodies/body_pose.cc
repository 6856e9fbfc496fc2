#include <wheelrail/bodies/body_pose.h>
#include <wheelrail/bodies/body_tables.h>
#include <wheelrail/bodies/wave_element.h>
#include <wheelrail/bodies/wave_panels.h>
#include <wheelrail/bodies/wave_stiffness.h>
#include <wheelrail/model/scene_material.h>

#include <cmath>
#include <vector>

// Where head and rim move and turn to under the forces of the contact: displacements inside the sections at
// each wavenumber, added up at z = 0 as (3) of doc/theory/bodies.md, mean over a slab, and a rigid motion
// fitted by least squares. Parts across the track alone: even in z of forces across, odd of those along.

namespace wheelrail
{
  namespace
  {
    // where heads and rims are fitted, 22 mm and more from the contact, nothing is left above it [1/m]
    constexpr double highest = 250;

    /// What stands behind the fit of a body.
    struct BodyInContact
    {
      const SectionMesh &mesh;
      const Elasticity   elasticity;
      const Placement   &placement;
      const Curve       &profile;
      const BodyLoads   &loads;
      bool               wheel;
      double             nominal_radius, rate;
    };

    /// Waves of the sum over harmonics of a wheel and the integral beyond, (3) of doc/theory/bodies.md; of a
    /// rail the integral.
    std::vector<Wave>
    waves_of(const bool wheel, const double radius)
    {
      // the same as in the tables; at 22 mm and more from the contact shorter waves have died
      constexpr int    n_harmonics = 13;
      constexpr double longest     = 0.02; // of the slab [m]
      if (!wheel)
        return wave_panels(0, highest, 10, longest);
      std::vector<Wave> waves;
      for (int n = 0; n < n_harmonics; ++n)
        // Fourier's series around the wheel, cos(n theta)/pi, of n = 0 half; forces count for a radian
        waves.push_back({double(n), (n > 0 ? 1. : 0.5) / M_PI});
      for (const Wave &wave : wave_panels(n_harmonics - 0.5, highest * radius, 40, longest / radius))
        waves.push_back(wave);
      return waves;
    }

    /// The wave k of the forces on each row that moves the section at the contact point across the track:
    /// the even part of forces across, the odd part of those along it. In the axes of the section.
    std::vector<Vector3>
    wave_of_forces(const BodyInContact &body, const double k, const std::size_t n_rows)
    {
      // Fourier's transform of forces at places z_i: sum of f cos(k z_i) of those across, of f sin(k z_i) of
      // those along
      const double         c = std::cos(body.placement.angle), s = std::sin(body.placement.angle);
      std::vector<Vector3> forces(n_rows, Vector3{});
      for (std::size_t r = 0; r < body.loads.forces.size(); ++r)
        for (std::size_t i = 0; i < body.loads.along.size(); ++i)
          {
            const Vector3 &f    = body.loads.forces[r][i];
            const double   even = std::cos(k * body.loads.along[i]), odd = std::sin(k * body.loads.along[i]);
            const double   up = even * (c * f[1] - s * f[0]);
            add(forces[body.loads.first + r],
                1,
                // turned by -angle to the axes of the section, whose y is outwards, down, of a wheel; a force
                // along is i f_z exp(i k z), so that its real part is -f_z sin(k z)
                {even * (c * f[0] + s * f[1]), body.wheel ? -up : up, -odd * f[2]});
          }
      return forces;
    }

    /// Displacements of the nodes, mean over the slab, in the axes of the section.
    std::vector<Point2>
    slab_means(const BodyInContact &body, const double slab)
    {
      // 1. Growth; 2. each wave: forces, one solution with K(k), its share in the mean over the slab
      WaveStiffness                 stiffness(body.mesh, body.elasticity, body.wheel);
      const std::vector<SurfaceRow> rows =
        rows_on_profile(body.mesh, body.profile, body.wheel, body.nominal_radius, BodyTableSizes().cells);
      std::vector<Point2> means(body.mesh.nodes.size());
      const double        radius = body.wheel ? body.nominal_radius : 1;
      if (body.wheel)
        // growth of the turning wheel, rho omega^2 r
        means = stiffness.growth(body.rate, body.elasticity.density);
      for (const Wave &wave : waves_of(body.wheel, radius))
        {
          const auto u =
            stiffness.displacements(wave.k, rows, wave_of_forces(body, wave.k / radius, rows.size()));
          for (std::size_t n = 0; n < u.size(); ++n)
            {
              const double turn = wave.k * slab / (body.wheel ? body.mesh.nodes[n].y : 1);
              // mean of cos(k z) over -slab ... slab is sin(k slab)/(k slab); a node at the radius y sees k/y
              const double mean = wave.weight * (turn > 0 ? std::sin(turn) / turn : 1);
              means[n]          = means[n] + mean * Point2{u[n][0], u[n][1]};
            }
        }
      return means;
    }

    RigidPart
    fit(const BodyInContact &body, const PoseQuery &query)
    {
      // places in the axes of the track from the contact point; u likewise
      const std::vector<Point2> means = slab_means(body, query.slab);
      const double              c = std::cos(body.placement.angle), s = std::sin(body.placement.angle);
      RigidFit                  sums;
      int                       points = 0;
      for (const auto &cell : body.mesh.cells)
        for (int g = 0; g < 9; ++g)
          {
            // at the nine Gauss points of each cell, so that parts count by their area
            const WavePoint point = wave_point(body.mesh, cell, g);
            const Point2    place =
              body.placement.to_track(profile_place(point.place, body.wheel, body.nominal_radius));
            const double dx = place.x - query.contact[0], dy = place.y - query.contact[1];
            if (!fits_pose(query, body.wheel ? Body::wheel : Body::rail, dx, dy, point.place.y))
              continue;
            Point2 u;
            for (unsigned int n = 0; n < n_wave_nodes; ++n)
              u = u + point.value[n] * means[cell[n]];
            if (body.wheel)
              u.y = -u.y;
            // rigid motion (a - roll dy, b + roll dx) by least squares with the area as weight
            // (doc/theory/rolling.md, Position and angles)
            sums.add(dx, dy, c * u.x - s * u.y, s * u.x + c * u.y, point.weight);
            ++points;
          }
      return sums.solve(points);
    }
  } // namespace


  ContactPose
  body_pose(const Scene &scene, const SceneGeometry &geometry, const WheelRailSolution &result)
  {
    // the fit leaves out what lies nearer than 22 mm to the contact, as that of a run does
    // (doc/theory/rolling.md, Position and angles)
    const ContactGeometry &contact  = geometry.contact;
    const BodySections     sections = body_sections(scene, geometry);
    PoseQuery              query;
    query.contact          = {contact.frame.origin.x, contact.frame.origin.y, 0};
    query.rim_inner_radius = scene.wheel.rim_inner_radius;
    return {fit({sections.rail,
                 elasticity(scene.rail_material),
                 contact.rail,
                 geometry.rail.head,
                 result.body_loads[0],
                 false,
                 0,
                 0},
                query),
            fit({sections.wheel,
                 elasticity(scene.wheel_material),
                 contact.wheel,
                 geometry.wheel.tread,
                 result.body_loads[1],
                 true,
                 scene.wheel_dimensions().nominal_radius,
                 scene.velocity / contact.rolling_radius},
                query)};
  }
} // namespace wheelrail
