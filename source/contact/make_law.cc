#include <wheelrail/contact/make_law.h>
#include <wheelrail/contact/surface_response.h>
#include <wheelrail/solid/element_blocks.h>

#include <algorithm>
#include <array>
#include <cmath>

// Penalty stiffness, damper and added mass (doc/theory/contact.md, Pressure, Added mass; Askes,
// Caramés-Saddler and Rodríguez-Ferran 2010): with the mass the springs alone are stable at the step of the
// elements, and so is the sum (Irons).

namespace wheelrail
{
  namespace
  {
    double
    bulk_modulus(const PerBody<ContactBody> &bodies)
    {
      // K = E/(3 (1 - 2 nu)), mean of the elastic bodies
      if (bodies.wheel.rigid)
        return bodies.rail.material.bulk_modulus();
      if (bodies.rail.rigid)
        return bodies.wheel.material.bulk_modulus();
      return 0.5 * (bodies.rail.material.bulk_modulus() + bodies.wheel.material.bulk_modulus());
    }

    SurfaceFilter
    filter_of(const ContactBody &body)
    {
      // each body has the filter of its own element form and Poisson's ratio
      std::array<Vector3, 8> cube;
      for (int a = 0; a < 8; ++a)
        // a cube of edge 1 m: weights of the filter have no unit
        cube[a] = {double(a & 1), double(a >> 1 & 1), double(a >> 2)};
      return surface_filter(element_stiffness(element_geometry(cube), body.material, body.form),
                            body.material);
    }
  } // namespace


  ContactLaw
  make_contact_law(const PerBody<ContactBody> &bodies, const ContactChoice &choice, const double step)
  {
    const double z = choice.damping_ratio;
    // nodes that open and close gain energy near the limit of stability, whatever the damping
    // L of doc/theory/contact.md, Added mass: omega dt <= 2 (sqrt(1 + z^2) - z), damper at the half step
    // behind, 1.488 for z = 0.3; 1.5 at most
    const double limit = std::min(1.5, 2 * (std::sqrt(1 + z * z) - z));
    ContactLaw   law;
    // eps = f K/h [Pa/m]: one spring between the surfaces, f is the effective scale
    law.stiffness = choice.penalty_scale * bulk_modulus(bodies) / choice.cell_size;
    // m = 2 eps dt^2/L^2 [kg/m2]: two masses m on a spring eps swing at omega^2 = 2 eps/m
    law.added_mass = 2 * law.stiffness * std::pow(step / limit, 2);
    // d = 2 z sqrt(eps m/2) [Pa s/m]: of the pair's reduced mass m/2
    law.damping  = 2 * z * std::sqrt(law.stiffness * law.added_mass / 2);
    law.friction = choice.friction;
    for (const Body body : both_bodies)
      // a rigid surface answers no load
      if (choice.surface_filter && !bodies[body].rigid)
        law.filter[body] = filter_of(bodies[body]);
    return law;
  }
} // namespace wheelrail
