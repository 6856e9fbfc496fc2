#include <wheelrail/contact/contact_law.h>

#include <algorithm>

// Pressure and friction of a node (doc/theory/contact.md, Pressure, Friction). k = eps is `stiffness` [Pa/m],
// c = d is `damping` [Pa s/m], g the gap (negative in contact), s = v_s `slip` and dg/dt `opening` [m/s], e
// the traction of the shear spring `elastic`, t `traction` on the rail [Pa]. The shear spring is as stiff as
// the normal one: a softer one would soften the creep curve.
// Checked: Cattaneo's spheres, stick radius -1.1 %; Carter's force, -0.2 %; a million steps to and fro
// (doc/theory/contact.md, Checked).

namespace wheelrail
{
  ContactSums &
  ContactSums::operator+=(const ContactSums &other)
  {
    add(force, 1, other.force);
    add(moment, 1, other.moment);
    normal_force += other.normal_force;
    stored_energy += other.stored_energy;
    friction_power += other.friction_power;
    damping_power += other.damping_power;
    largest_pressure = std::max(largest_pressure, other.largest_pressure);
    nodes += other.nodes;
    at_border = at_border || other.at_border;
    return *this;
  }


  ContactForces
  apply_law(const ContactLaw    &law,
            const ContactMotion &motion,
            const double         time_step,
            const double         area,
            ContactNode         &node,
            ContactSums         &sums)
  {
    const Vector3 n = node.normal;
    // p = max(0, -k g - c dg/dt): spring and damper of the penalty layer, no suction
    const double spring = -law.stiffness * node.gap;
    node.pressure       = std::max(0., spring - law.damping * motion.opening);

    // shear: elastic trial e + k s dt in the tangent plane (on the rail, so along the wheel's slip s), the
    // damper's c s on top, return to the Coulomb bound mu(|s|) p along the trial (Ma et al. 2017)
    const Vector3 before = node.elastic - dot(node.elastic, n) * n;
    // history projected on the tangent plane of now: the normal turns as the wheel rolls
    Vector3 trial = before;
    add(trial, law.stiffness * time_step, motion.slip);
    Vector3 total = trial;
    // mu at the slip speed of the half step behind: an implicit one has several solutions once p |dmu/dv| > k
    // dt
    const double bound = law.friction.at(norm(motion.slip)) * node.pressure;
    if (time_step > 0)
      add(total, law.damping, motion.slip);
    // slipping where |t| > mu p: t = mu p t/|t|, and the history becomes t, damper included, so that its
    // spring never holds more than the bound
    const double size = norm(total);
    node.slipping     = size > bound;
    if (node.slipping)
      {
        const double factor = size > 0 ? bound / size : 0;
        total               = factor * total;
        trial               = total;
      }
    // sticking: the history is the trial without the damper, which is no state
    node.elastic  = trial;
    node.traction = total;
    // what the spring does not take: s - (de/dt) / k
    node.slip = motion.slip;
    if (time_step > 0)
      add(node.slip, -1 / (law.stiffness * time_step), trial - before);

    // on the wheel: p A along the true normal out of the rail, -t A; minus both on the rail
    const ContactForces forces{(node.pressure * area) * (n + motion.tilt), -area * total};
    add(sums.force, 1, forces.push + forces.drag);
    sums.normal_force += node.pressure * area;
    // the balance: (k g)^2 / 2k + e^2 / 2k in the springs, t . slip by friction, the rest of p dg/dt and of
    // t . s in the dampers
    sums.stored_energy += area * (spring * spring + dot(trial, trial)) / (2 * law.stiffness);
    sums.friction_power += area * dot(total, node.slip);
    sums.damping_power += area * (spring - node.pressure) * motion.opening;
    sums.damping_power += area * dot(total - trial, motion.slip - node.slip);
    sums.largest_pressure = std::max(sums.largest_pressure, node.pressure);
    ++sums.nodes;
    return forces;
  }
} // namespace wheelrail
