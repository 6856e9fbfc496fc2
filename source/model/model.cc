#include <wheelrail/base/errors.h>
#include <wheelrail/contact/make_law.h>
#include <wheelrail/mesh/lattice.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/model.h>
#include <wheelrail/solid/highest_frequency.h>

#include <cmath>

namespace wheelrail
{
  namespace
  {
    SolidChoice
    bodies_of(const Scene &scene)
    {
      return {{material_law(scene.rail_material), material_law(scene.wheel_material)},
              {scene.rail_element.value_or(scene.element), scene.wheel_element.value_or(scene.element)},
              scene.bulk_viscosity};
    }

    ContactLaw
    make_law(const Scene &scene, const Solid &solid)
    {
      const auto body = [](const ElementBlocks &blocks) {
        return ContactBody{blocks.elasticity(), blocks.form};
      };
      return make_contact_law({body(solid.blocks.rail), body(solid.blocks.wheel)},
                              {scene.penalty_scale,
                               scene.cell_size,
                               scene.contact_damping,
                               friction_law(scene),
                               scene.surface_filter},
                              solid.stable.step);
    }

    /// Between the running surfaces of the plan, with a window that holds the longest patch and two cells on
    /// either side of it; to be prepared.
    std::unique_ptr<Contact>
    make_contact(const Scene &scene, const Model &model, MPI_Comm communicator)
    {
      const RunningSurfaces &surfaces = model.forest->plan().surfaces;
      const double           half_window =
        half_length_bound(model.expected_approach, surfaces.rolling_radius) + 2 * scene.cell_size;
      return std::make_unique<Contact>(surfaces, make_law(scene, model.solid), half_window, communicator);
    }

    /// The axle without its torque, which follows from the load.
    AxleData
    make_axle(const Scene &scene, const ContactGeometry &geometry)
    {
      AxleData axle;
      axle.centre        = {geometry.axle.x, geometry.axle.y, 0};
      axle.axis          = {std::cos(geometry.wheel.angle), std::sin(geometry.wheel.angle), 0};
      axle.mass          = scene.axle_mass;
      axle.pitch_inertia = scene.axle_pitch_inertia;
      axle.sprung_mass   = scene.sprung_mass;
      axle.stiffness     = scene.suspension_stiffness;
      axle.damping       = scene.suspension_damping;
      axle.gravity       = scene.gravity;
      axle.velocity      = scene.velocity;
      axle.rate_held     = scene.drive == Drive::rate;
      return axle;
    }

    /// The sprung mass that brings the wheel load of the scene on the rail, with `unsprung` [kg] of wheel and
    /// half axle.
    double
    sprung_mass_for(const Scene &scene, const double unsprung)
    {
      const double mass = scene.wheel_load / scene.gravity - unsprung;
      if (mass < 0)
        throw InputError(load_too_small(scene, unsprung * scene.gravity));
      return mass;
    }

    /// The largest step within the wanted fraction of the stable one that divides the rolling distance.
    double
    time_step(const Scene &scene, const StableStep &stable)
    {
      const double steps =
        std::ceil(scene.rolling_distance / (scene.velocity * scene.time_step_factor * stable.step));
      return scene.rolling_distance / (scene.velocity * steps);
    }
  } // namespace


  Elasticity
  elasticity(const MaterialData &material)
  {
    return {material.youngs_modulus, material.poissons_ratio, material.density};
  }


  MaterialLaw
  material_law(const MaterialData &material)
  {
    return material_law(elasticity(material),
                        {material.yield_stress, material.tangent_modulus, material.kinematic_hardening});
  }


  TimeScheme
  time_scheme(const Scene &scene, const Model &model)
  {
    return {model.time_step, scene.bulk_viscosity, 0};
  }


  SweepPlan
  sweep_plan(const Scene &scene, const SceneGeometry &geometry)
  {
    WheelDimensions wheel = scene.wheel;
    wheel.nominal_radius  = scene.track.nominal_radius;
    SweepSizes sizes;
    sizes.cell        = scene.cell_size;
    sizes.coarse      = scene.coarse_cell_size;
    sizes.fine_depth  = scene.depth_of_fine_cells();
    sizes.fine_margin = scene.fine_margin;
    sizes.approach    = expected_approach(scene, geometry.contact.rolling_radius);
    sizes.distance    = scene.mesh_distance();
    sizes.rail_length = scene.rail_length;
    return make_sweep_plan(geometry, wheel, sizes);
  }


  void
  prepare(const Scene &scene, Model &model, MPI_Comm communicator)
  {
    prepare(model.solid, model.forest->local_mesh(), communicator);
    lower_stable_step(model.solid, scene.bulk_viscosity, communicator);
    if (!model.contact)
      model.contact = make_contact(scene, model, communicator);
    const SweepPlan &plan    = model.forest->plan();
    const Lattice    lattice = make_lattice(plan);
    const auto       collect = [&](const Body body) {
      return make_surface(model.solid.mesh, body, plan.surfaces, lattice, communicator);
    };
    model.contact->prepare(collect(Body::rail), collect(Body::wheel));
    for (const Body body : both_bodies)
      add_surface_mass(
        model.contact->surface(body), model.contact->law().added_mass, model.solid.added_mass.data());
  }


  Model
  make_model(const Scene &scene, const SceneGeometry &geometry, MPI_Comm communicator)
  {
    Model model;
    model.geometry          = geometry.contact;
    model.expected_approach = expected_approach(scene, geometry.contact.rolling_radius);
    model.forest            = std::make_unique<Forest>(communicator, sweep_plan(scene, geometry));
    model.solid.choice      = bodies_of(scene);
    prepare(scene, model, communicator);
    model.axle = make_axle(scene, geometry.contact);
    const double unsprung =
      scene.axle_mass + mass_properties(model.solid, Body::wheel, model.axle.centre, communicator).mass;
    if (scene.wheel_load > 0)
      model.axle.sprung_mass = sprung_mass_for(scene, unsprung);
    model.wheel_load  = (model.axle.sprung_mass + unsprung) * scene.gravity;
    model.axle.torque = scene.traction_coefficient * model.wheel_load * geometry.contact.rolling_radius;
    model.time_step   = time_step(scene, model.solid.stable);
    return model;
  }
} // namespace wheelrail
