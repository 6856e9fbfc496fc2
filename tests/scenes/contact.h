#pragma once

// The program's contact operator in idealised scenes: an elastic block as rail under a wheel that is
// rigid or elastic. Axes as in the program: X lateral, Y up, Z along the track; the rail's top is y = 0
// and the wheel touches it in the origin.

#include "dynamics.h"
#include "mirrored.h"

#include <wheelrail/contact/contact.h>
#include <wheelrail/output/fields.h>

#include <array>

namespace scenes
{
  using wheelrail::Contact;
  using wheelrail::ContactSums;
  using wheelrail::FrictionLaw;
  using wheelrail::Lattice;
  using wheelrail::RunningSurfaces;
  using wheelrail::Surface;

  /// A wheel of revolution about the line y = `radius`, z = 0 above a flat rail; its profile is a line
  /// (`crown` = 0) or an arc of radius `crown` [m], tabulated for |x| <= `half_width` [m].
  RunningSurfaces
  wheel_on_plane(double radius, double crown, double half_width);

  /// A lattice with nodes at multiples of the cell size along, from `begin` to `end`, and across.
  struct CellRange
  {
    double begin, end, size; ///< size: of a cell [m]
  };
  Lattice
  make_lattice(const CellRange &along, const CellRange &across);

  /// Breakpoints from `begin` upwards: cells of equal size up to `fine` [m], then each `growth` times
  /// as long as the one before, at most `largest`, up to about `total` [m].
  std::vector<double>
  fine_then_coarse(double size, double fine, double total, double growth = 1.2, double largest = 1);

  /// The same to both sides of zero.
  std::vector<double>
  both_sides(const std::vector<double> &breakpoints);

  /// A block of the breakpoints given across (x), downwards (depth >= 0) and along (z); its top, where
  /// both neighbouring breakpoints lie in the fine zone, carries the mark of a running surface.
  LocalMesh
  rail_block(const std::vector<double> &across,
             const std::vector<double> &depth,
             const std::vector<double> &along);

  /// The same block bent to a piece of the wheel's rim.
  LocalMesh
  wheel_block(const RunningSurfaces     &surfaces,
              const std::vector<double> &across,
              const std::vector<double> &depth,
              const std::vector<double> &along);

  /// The nodes of the wheel's exact surface on a lattice, as a rigid body; `local` is -1.
  Surface
  rigid_surface(const RunningSurfaces &surfaces, const Lattice &lattice);

  /// Motion of a rigid wheel: translation of its axle and rotation about it.
  struct RigidWheel
  {
    Vector3 move{}, velocity{};  ///< [m], [m/s]
    double  angle = 0, rate = 0; ///< [rad], [rad/s]
  };

  struct ContactSetup
  {
    double      scale         = 10;   ///< f
    double      cell_size     = 1e-3; ///< h of the penalty [m]
    double      damping_ratio = 0.3;
    FrictionLaw friction;
    double      half_window = 1;    ///< [m]
    bool        filter      = true; ///< of elastic bodies, as in the program
    bool        added_mass  = true; ///< without it the step must be shortened by the caller
    Symmetry    symmetry;           ///< of the elastic bodies
  };

  /// Contact between nodes of a scene's mesh and a wheel, added to the forces of every step. Bodies cut at
  /// planes of symmetry touch with their whole surfaces: sums and energies are those of whole bodies.
  class ContactPair
  {
  public:
    ContactPair(Dynamics              &scene,
                const RunningSurfaces &surfaces,
                const Surface         &rail,
                const Surface         &wheel,
                const ContactSetup    &setup);
    ContactPair(const ContactPair &) = delete;

    /// Moves a rigid wheel from the full step at `time` to the next; the force of this step is in `sums`.
    std::function<void(double time, RigidWheel &wheel)> drive;

    /// Place of the window along the rail and arc coordinate of the wheel there, minus it [m].
    std::function<std::array<double, 2>(double time)> follow;

    Contact     contact;
    RigidWheel  wheel;
    ContactSums sums;
    double      friction_energy = 0, damping_energy = 0; ///< up to the last half step [J]
    double      work = 0;                                ///< of the contact forces on both bodies [J]

    wheelrail::PatchFields
    patch() const;

  private:
    void
    add_forces(double time, const Solid &solid, double *force);

    Dynamics               &scene_;
    std::vector<NodeSource> sources_; ///< of the nodes of the rail, then of the wheel
    std::vector<Vector3>    rigid_;
    std::vector<double>     displacement_, velocity_, velocity_before_, force_;
  };

  /// Elastic half-space under an elliptic pressure, rolled up from point loads: the displacement at the
  /// depth -y below the surface per unit of load, for boundaries of a finite block (Boussinesq 1885).
  Vector3
  boussinesq(const Vector3 &X, const Elasticity &material);

  /// Displacement at X under the Hertz pressure with semi-axes a (along z) and b (along x) of unit load.
  Vector3
  under_ellipse(const Vector3 &X, double a, double b, const Elasticity &material);

  /// Hertz's contact of a wheel (radii along, across) on a plane.
  struct Hertz
  {
    double a, b, peak, approach; ///< semi-axes along and across [m], [Pa], [m]
  };

  /// `modulus`: E*. Solved numerically from Hertz's integrals (Johnson, Contact Mechanics, 1985, 4.2).
  Hertz
  hertz(double load, double radius_along, double radius_across, double modulus);
} // namespace scenes
