#include "contact.h"

#include <wheelrail/contact/make_law.h>
#include <wheelrail/geometry/frame_profile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace scenes
{
  using namespace wheelrail;

  RunningSurfaces
  wheel_on_plane(const double radius, const double crown, const double half_width)
  {
    // profiles run towards negative x, as those of the sections do in the track plane
    const auto profile = [&](const double arc) {
      const double x = 1.01 * half_width;
      Segment      segment;
      segment.name = "profile";
      if (arc > 0)
        {
          const double angle  = std::asin(x / arc);
          segment.kind        = Segment::Kind::arc;
          segment.centre      = {0, arc};
          segment.radius      = arc;
          segment.angle_start = -M_PI / 2 + angle;
          segment.angle_end   = -M_PI / 2 - angle;
          segment.start       = {x, arc - arc * std::cos(angle)};
          segment.end         = {-x, segment.start.y};
        }
      else
        {
          segment.start = {x, 0};
          segment.end   = {-x, 0};
        }
      return FrameProfile(Curve({segment}), Placement(), ContactFrame());
    };
    RunningSurfaces surfaces;
    WheelPose       pose;
    pose.nominal_radius = surfaces.rolling_radius = surfaces.forward_radius = radius;
    surfaces.rail    = RunningSurface(profile(0), ContactFrame(), Placement());
    surfaces.wheel   = RunningSurface(profile(crown), ContactFrame(), pose, radius);
    surfaces.outline = SectionHeights(profile(crown));
    surfaces.tabulate(-half_width, half_width);
    return surfaces;
  }


  Lattice
  make_lattice(const CellRange &along, const CellRange &across)
  {
    Lattice lattice;
    lattice.spacing_along   = along.size;
    lattice.first_station   = static_cast<int>(std::lround(along.begin / along.size));
    lattice.n_along         = std::lround((along.end - along.begin) / along.size) + 1;
    lattice.spacing_lateral = across.size;
    lattice.s_begin         = across.begin;
    lattice.n_lateral       = std::lround((across.end - across.begin) / across.size) + 1;
    return lattice;
  }


  std::vector<double>
  fine_then_coarse(const double size,
                   const double fine,
                   const double total,
                   const double growth,
                   const double largest)
  {
    std::vector<double> x    = {0};
    double              cell = size;
    while (x.back() < total - 0.3 * cell)
      {
        x.push_back(x.back() + cell);
        if (x.back() > fine - 0.5 * size)
          cell = std::min(growth * cell, largest);
      }
    return x;
  }


  std::vector<double>
  both_sides(const std::vector<double> &breakpoints)
  {
    std::vector<double> x;
    for (std::size_t k = breakpoints.size(); k-- > 1;)
      x.push_back(-breakpoints[k]);
    x.insert(x.end(), breakpoints.begin(), breakpoints.end());
    return x;
  }


  namespace
  {
    using Bend = std::function<Vector3(double across, double depth, double along)>;

    LocalMesh
    block(const std::vector<double> &across,
          const std::vector<double> &depth,
          const std::vector<double> &along,
          const Body                 body,
          const Bend                &bend)
    {
      const auto at = [](const std::vector<double> &x, const double u) {
        return x[std::lround(u * (x.size() - 1))];
      };
      const Cells cells = {static_cast<unsigned int>(across.size() - 1),
                           static_cast<unsigned int>(depth.size() - 1),
                           static_cast<unsigned int>(along.size() - 1)};
      // the wheel hangs over its surface, the rail stands below it: keep the orientation
      const bool  turned = body == Body::wheel;
      const Place place  = [=](const Vector3 &u) {
        return bend(at(across, u[0]), at(depth, turned ? u[1] : 1 - u[1]), at(along, u[2]));
      };
      return make_mesh({{cells, place}}, body);
    }
  } // namespace


  LocalMesh
  rail_block(const std::vector<double> &across,
             const std::vector<double> &depth,
             const std::vector<double> &along)
  {
    LocalMesh mesh = block(across, depth, along, Body::rail, [](double x, double d, double z) {
      return Vector3{x, -d, z};
    });
    mark_faces(mesh, Boundary::running, plane(1, 0));
    return mesh;
  }


  LocalMesh
  wheel_block(const RunningSurfaces     &surfaces,
              const std::vector<double> &across,
              const std::vector<double> &depth,
              const std::vector<double> &along)
  {
    const double R     = surfaces.rolling_radius;
    LocalMesh    mesh  = block(across, depth, along, Body::wheel, [&](double x, double d, double z) {
      const double r = surfaces.local_radius(x) - d;
      return Vector3{x, R - r * std::cos(z / R), r * std::sin(z / R)};
    });
    const double first = depth[1];
    mark_faces(mesh, Boundary::running, [&surfaces, first](const Vector3 &X) {
      return std::abs(surfaces.wheel.offset(X)) < 0.1 * first;
    });
    return mesh;
  }


  Surface
  rigid_surface(const RunningSurfaces &surfaces, const Lattice &lattice)
  {
    Surface           surface;
    const std::size_t n = std::size_t(lattice.n_along) * lattice.n_lateral;
    surface.body        = Body::wheel;
    surface.lattice     = lattice;
    surface.area.assign(n, lattice.spacing_along * lattice.spacing_lateral);
    surface.owner.assign(n, 0);
    surface.local.assign(n, -1);
    surface.global_node.assign(n, 0);
    for (unsigned int i = 0; i < lattice.n_along; ++i)
      for (unsigned int j = 0; j < lattice.n_lateral; ++j)
        {
          const double s = lattice.s_begin + j * lattice.spacing_lateral;
          const double angle =
            (lattice.first_station + int(i)) * lattice.spacing_along / surfaces.rolling_radius;
          const double r = surfaces.local_radius(s);
          surface.reference.push_back(
            {s, surfaces.pose().nominal_radius - r * std::cos(angle), r * std::sin(angle)});
        }
    return surface;
  }


  namespace
  {
    /// The whole surface, its nodes numbered from `first`, so that rigid ones fit in.
    Surface
    whole_surface(const Surface &part, const Symmetry &symmetry, const std::size_t first)
    {
      Surface surface = mirrored(part, symmetry).surface;
      surface.local.resize(surface.reference.size());
      for (std::size_t k = 0; k < surface.local.size(); ++k)
        surface.local[k] = first + k;
      surface.owner.assign(surface.local.size(), 0);
      return surface;
    }

    ContactLaw
    law_of(const Dynamics &scene, const ContactSetup &setup)
    {
      const auto body = [](const ElementBlocks &blocks) {
        return ContactBody{blocks.elasticity(), blocks.form, blocks.n_elements == 0};
      };
      return make_contact_law(
        {body(scene.solid.blocks.rail), body(scene.solid.blocks.wheel)},
        {setup.scale, setup.cell_size, setup.damping_ratio, setup.friction, setup.filter},
        scene.solid.stable.step);
    }
  } // namespace


  ContactPair::ContactPair(Dynamics              &scene,
                           const RunningSurfaces &surfaces,
                           const Surface         &rail,
                           const Surface         &wheel,
                           const ContactSetup    &setup)
    : follow([this](double) {
      const double radius = contact.surfaces().rolling_radius;
      return std::array<double, 2>{this->wheel.move[2], radius * this->wheel.angle - this->wheel.move[2]};
    })
    , contact(surfaces, law_of(scene, setup), setup.half_window, MPI_COMM_SELF)
    , scene_(scene)
  {
    contact.prepare(whole_surface(rail, setup.symmetry, 0),
                    whole_surface(wheel, setup.symmetry, mirrored(rail, setup.symmetry).sources.size()));
    for (const Surface *surface : {&rail, &wheel})
      {
        const WholeSurface whole = mirrored(*surface, setup.symmetry);
        sources_.insert(sources_.end(), whole.sources.begin(), whole.sources.end());
        rigid_.insert(rigid_.end(), whole.surface.reference.begin(), whole.surface.reference.end());
      }
    if (setup.added_mass)
      {
        for (BoundaryFace &face : scene.solid.mesh.faces)
          face.strip = face.mark == Boundary::running;
        add_band_mass(scene.solid, contact.law().added_mass);
      }
    displacement_.assign(4 * sources_.size(), 0);
    velocity_ = velocity_before_ = force_ = displacement_;
    scene.add_force(
      [this](const double time, const Solid &solid, double *force) { add_forces(time, solid, force); });
  }


  void
  ContactPair::add_forces(const double time, const Solid &solid, double *force)
  {
    velocity_before_     = velocity_;
    const Vector3 centre = {0, contact.surfaces().pose().nominal_radius, 0};
    for (std::size_t k = 0; k < sources_.size(); ++k)
      if (const NodeSource &from = sources_[k]; from.node >= 0)
        for (int i = 0; i < 3; ++i)
          {
            displacement_[4 * k + i] = from.sign[i] * solid.displacement[4 * from.node + i];
            velocity_[4 * k + i]     = from.sign[i] * solid.velocity[4 * from.node + i];
          }
      else
        {
          const Vector3 arm = Rotation({1, 0, 0}, wheel.angle)(rigid_[k] - centre);
          const Vector3 u   = centre + wheel.move + arm - rigid_[k];
          const Vector3 v   = wheel.velocity + wheel.rate * cross({1, 0, 0}, arm);
          for (int i = 0; i < 3; ++i)
            {
              displacement_[4 * k + i] = u[i];
              velocity_[4 * k + i]     = v[i];
            }
        }
    // the forces of the last step worked with the mean of the velocities before and after it
    const double last = scene_.steps() == 1 ? 0.5 * scene_.time_step : scene_.time_step;
    for (std::size_t k = 0; k < force_.size(); ++k)
      work += 0.5 * last * force_[k] * (velocity_before_[k] + velocity_[k]);
    const auto [along, ahead] = follow(time);
    contact.move_window(along, ahead);
    contact.gather(displacement_.data(), velocity_.data());
    sums = contact.evaluate(scene_.time_step);
    std::fill(force_.begin(), force_.end(), 0.);
    contact.add_forces(force_.data());
    for (std::size_t k = 0; k < sources_.size(); ++k)
      if (const NodeSource &to = sources_[k]; to.node >= 0)
        for (int i = 0; i < 3; ++i)
          force[4 * to.node + i] += to.share * force_[4 * k + i];
    const double step = scene_.steps() == 0 ? 0.5 * scene_.time_step : scene_.time_step;
    friction_energy += step * sums.friction_power;
    damping_energy += step * sums.damping_power;
    if (drive)
      drive(time, wheel);
  }


  PatchFields
  ContactPair::patch() const
  {
    const Lattice &lattice = contact.lattice();
    PatchFields    patch;
    patch.n_along   = lattice.n_along;
    patch.n_lateral = lattice.n_lateral;
    for (unsigned int i = 0; i < lattice.n_along; ++i)
      for (unsigned int j = 0; j < lattice.n_lateral; ++j)
        {
          const ContactNode &node = contact.nodes()[lattice.index(i, j)];
          patch.along.push_back((lattice.first_station + static_cast<int>(i)) * lattice.spacing_along);
          patch.lateral.push_back(lattice.s_begin + j * lattice.spacing_lateral);
          patch.gap.push_back(node.gap);
          patch.pressure.push_back(node.pressure);
          patch.traction_along.push_back(node.traction[2]);
          patch.traction_lateral.push_back(node.traction[0]);
          patch.slip_along.push_back(node.slip[2]);
          patch.slip_lateral.push_back(node.slip[0]);
          patch.state.push_back(node.pressure <= 0 ? 0 : node.slipping ? 2 : 1);
          patch.area.push_back(lattice.spacing_along * lattice.spacing_lateral);
        }
    return patch;
  }


  Vector3
  boussinesq(const Vector3 &X, const Elasticity &material)
  {
    const double nu = material.poissons_ratio, depth = -X[1];
    const double r = std::hypot(X[0], X[2]), rho = std::hypot(r, depth);
    const double factor = (1 + nu) / (2 * M_PI * material.youngs_modulus);
    const double down   = factor * (depth * depth / (rho * rho * rho) + 2 * (1 - nu) / rho);
    // outward displacement over r
    const double out = factor * (depth / (rho * rho * rho) - (1 - 2 * nu) / (rho * (rho + depth)));
    return {out * X[0], -down, out * X[2]};
  }


  Vector3
  under_ellipse(const Vector3 &X, const double a, const double b, const Elasticity &material)
  {
    // rings of equal load: within radius q the share 1 - (1 - q^2)^(3/2)
    constexpr int rings = 8, spokes = 16;
    Vector3       u{};
    for (int k = 0; k < rings; ++k)
      {
        const double q = std::sqrt(1 - std::pow(1 - (k + 0.5) / rings, 2. / 3));
        for (int m = 0; m < spokes; ++m)
          {
            const double angle = 2 * M_PI * (m + 0.5) / spokes;
            add(u,
                1. / (rings * spokes),
                boussinesq(X - Vector3{b * q * std::cos(angle), 0, a * q * std::sin(angle)}, material));
          }
      }
    return u;
  }


  Hertz
  hertz(const double load, const double radius_along, const double radius_across, const double modulus)
  {
    // gap z^2 A + x^2 B; with w = s^2: A = p0 a b/(2 E*) int 2 ds/((a^2+s^2)^(3/2) (b^2+s^2)^(1/2)), B with a
    // and b exchanged, approach with both roots. For b = 1 and k = a: A/B fixes k.
    const auto integral = [](const double k, const double power_a, const double power_b) {
      const int n   = 20000;
      double    sum = 0;
      for (int i = 0; i < n; ++i)
        {
          // s = tan(t) maps the half line to a quarter turn
          const double t = 0.5 * M_PI * (i + 0.5) / n, s = std::tan(t);
          sum += 0.5 * M_PI / n * (1 + s * s) * 2 / std::pow(k * k + s * s, power_a) /
                 std::pow(1 + s * s, power_b);
        }
      return sum;
    };
    const double A = 0.5 / radius_along, B = 0.5 / radius_across;
    double       low = 0.05, high = 20;
    for (int i = 0; i < 60; ++i)
      {
        const double k = std::sqrt(low * high);
        if (integral(k, 1.5, 0.5) / integral(k, 0.5, 1.5) > A / B)
          low = k;
        else
          high = k;
      }
    const double k = std::sqrt(low * high);
    // p0 = 3 F/(2 pi a b), a = k b: A = 3 F/(4 pi E*) I_A/b^3
    Hertz        result;
    const double c  = 3 * load / (4 * M_PI * modulus);
    result.b        = std::cbrt(c * integral(k, 1.5, 0.5) / A);
    result.a        = k * result.b;
    result.peak     = 1.5 * load / (M_PI * result.a * result.b);
    result.approach = c / result.b * integral(k, 0.5, 0.5);
    return result;
  }
} // namespace scenes
