#pragma once

// A contact whose pressure is elliptic, for tractions to start from.

#include <wheelrail/contact/contact.h>
#include <wheelrail/statics/start_tractions.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace test::elliptic
{
  using namespace wheelrail;

  inline constexpr double radius = 0.46, largest_pressure = 1e9, friction = 0.4,
                          stiffness          = 1e17; // hard, so that its layer does not matter
  inline constexpr double      shear_modulus = 210e9 / 2.6, velocity = 40;
  inline const HalfspaceSteels steel;

  /// Straight lines across the track: one, inclined by that of the frame, or two sides of a ridge, inclined
  /// by +-`side` to the horizontal, with heights 0 at X = +-`middle`.
  struct Outline
  {
    double side = 0, middle = 0;

    double
    height(const double X) const
    {
      return -std::tan(side) * (std::abs(X) - middle);
    }

    FrameProfile
    profile(const ContactFrame &frame) const
    {
      const double x = 0.03 * std::cos(frame.angle), y = -0.03 * std::sin(frame.angle);
      Segment      line;
      line.name  = "line";
      line.start = {x, y};
      line.end   = {-x, -y};
      if (side == 0)
        return FrameProfile(Curve({line}), Placement(), frame);
      Segment other = line;
      other.name    = "other";
      line.start    = {x, -height(x)};
      line.end      = {0, -height(0)};
      other.start   = line.end;
      other.end     = {-x, -height(x)};
      return FrameProfile(Curve({line, other}), Placement(), frame);
    }
  };

  /// A cone on a plane, both inclined by `angle` (a cylinder when it is zero), with rail nodes moved so
  /// that the pressure is elliptic with semi-axes `along` and `across` [m]; on a ridge on both sides.
  inline Contact
  elliptic_contact(const double       along,
                   const double       across,
                   const double       angle   = 0,
                   const FrictionLaw &law     = {friction},
                   const Outline     &outline = {})
  {
    constexpr double spacing  = 2.5e-4;
    const double     inclined = std::cos(angle + outline.side);
    Lattice          lattice;
    lattice.first_station = -static_cast<int>(along / spacing) - 6;
    lattice.n_along       = 1 - 2 * lattice.first_station;
    lattice.n_lateral     = 2 * static_cast<int>((across + outline.middle) / spacing) + 9;
    lattice.spacing_along = lattice.spacing_lateral = spacing;
    lattice.s_begin                                 = -0.5 * (lattice.n_lateral - 1) * spacing;

    RunningSurfaces surfaces;
    WheelPose       pose;
    surfaces.frame.angle = angle;
    pose.nominal_radius = surfaces.rolling_radius = surfaces.forward_radius = radius;
    const FrameProfile profile                                              = outline.profile(surfaces.frame);
    surfaces.rail    = RunningSurface(profile, surfaces.frame, Placement());
    surfaces.wheel   = RunningSurface(profile, surfaces.frame, pose, radius);
    surfaces.outline = SectionHeights(profile);
    surfaces.tabulate(-0.02, 0.02);
    const std::size_t n = std::size_t(lattice.n_along) * lattice.n_lateral;
    Surface           body[2];
    for (int b = 0; b < 2; ++b)
      {
        body[b].lattice = lattice;
        body[b].body    = b == 0 ? Body::rail : Body::wheel;
        body[b].area.assign(n, spacing * spacing / std::cos(outline.side));
        body[b].owner.assign(n, 0);
        body[b].local.resize(n);
        std::iota(body[b].local.begin(), body[b].local.end(), b * int(n));
        body[b].global_node.assign(body[b].local.begin(), body[b].local.end());
        for (unsigned int i = 0; i < lattice.n_along; ++i)
          for (unsigned int j = 0; j < lattice.n_lateral; ++j)
            {
              const double z = (lattice.first_station + int(i)) * spacing, s = lattice.s_begin + j * spacing,
                           ahead = z / radius, X = s * std::cos(angle),
                           Y = outline.side == 0 ? s * std::sin(angle) : outline.height(X), r = radius - Y;
              if (b == 0)
                body[b].reference.push_back({X, Y, z});
              else
                body[b].reference.push_back({X, radius - r * std::cos(ahead), r * std::sin(ahead)});
            }
      }
    Contact contact(surfaces, {stiffness, 0, law, {}}, along + 0.01, MPI_COMM_SELF);
    contact.prepare(body[0], body[1]);
    std::vector<double> displacement(8 * n, 0.), velocity(8 * n, 0.);
    contact.gather(displacement.data(), velocity.data());
    contact.evaluate(0);
    for (int round = 0; round < 16; ++round) // the closest points move with the nodes
      {
        for (std::size_t k = 0; k < n; ++k)
          {
            const Vector3 &X      = body[0].reference[k];
            const double   middle = std::copysign(outline.middle, X[0]),
                         inside =
                           1 - std::pow(X[2] / along, 2) - std::pow((X[0] - middle) / inclined / across, 2);
            const double gap = inside > 0 ? -largest_pressure * std::sqrt(inside) / stiffness : 1e-6;
            if (contact.nodes()[k].gap < 0.1) // else nothing is above
              displacement[4 * k + 1] += (contact.nodes()[k].gap - gap) / inclined;
            if (outline.side > 0 && std::abs(X[0]) < 2e-3) // what is nearest jumps over the ridge
              displacement[4 * k + 1] = -1e-3;
          }
        contact.gather(displacement.data(), velocity.data());
        contact.evaluate(0);
      }
    return contact;
  }

  inline double
  normal_force(const Contact &contact)
  {
    double sum = 0;
    for (std::size_t k = 0; k < contact.nodes().size(); ++k)
      sum += contact.nodes()[k].pressure * contact.rail().area[k];
    return sum;
  }
} // namespace test::elliptic
