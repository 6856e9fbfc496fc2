#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/contact/penalty.h>
#include <wheelrail/contact/surface_response.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_profiles.h>
#include <wheelrail/solid/highest_frequency.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Block borders along the rail: the wheel's spacing where it rolls, stretched to the given ends
    /// elsewhere.
    std::vector<double>
    rail_stations(const double begin,
                  const double end,
                  const double fine_begin,
                  const double fine_end,
                  const double spacing)
    {
      const long first = static_cast<long>(std::floor(fine_begin / spacing)) - 1;
      const long last  = static_cast<long>(std::ceil(fine_end / spacing)) + 1;
      if (first * spacing < begin + spacing || last * spacing > end - spacing)
        throw InputError(
          "Track/Rail length is too short: the rolled stretch with its fine cells reaches from " +
          in_mm(first * spacing) + " to " + in_mm(last * spacing) + ", the rail from " + in_mm(begin) +
          " to " + in_mm(end) + "; take a longer rail or a shorter Run/Rolling distance");
      std::vector<double> stations;
      const auto          fill = [&](const double from, const double to) {
        const int n = std::max(1, static_cast<int>(std::lround((to - from) / spacing)));
        for (int k = 0; k < n; ++k)
          stations.push_back(from + (to - from) * k / n);
      };
      fill(begin, first * spacing);
      for (long k = first; k < last; ++k)
        stations.push_back(k * spacing);
      fill(last * spacing, end);
      stations.push_back(end);
      return stations;
    }

    Lattice
    make_lattice(const SweepPlan &plan)
    {
      const double       parts  = std::pow(2., plan.levels);
      const unsigned int blocks = plan.strip.s.size() - 1;
      Lattice            lattice;
      lattice.spacing_along = 2 * M_PI * plan.surfaces.rolling_radius / (plan.sectors * parts);
      lattice.first_station = static_cast<int>(std::ceil(plan.fine_begin / lattice.spacing_along));
      lattice.n_along =
        static_cast<int>(std::floor(plan.fine_end / lattice.spacing_along)) - lattice.first_station + 1;
      lattice.s_begin         = plan.strip.s.front();
      lattice.n_lateral       = blocks * static_cast<unsigned int>(parts) + 1;
      lattice.spacing_lateral = (plan.strip.s.back() - plan.strip.s.front()) / (lattice.n_lateral - 1);
      return lattice;
    }

    std::array<Vector3, 8>
    unit_cube()
    {
      std::array<Vector3, 8> vertices;
      for (int a = 0; a < 8; ++a)
        vertices[a] = {double(a & 1), double(a >> 1 & 1), double(a >> 2)};
      return vertices;
    }

    /// The contact law of the scene; the surface nodes get their added mass.
    ContactLaw
    make_law(const Scene &scene, Solid &solid, const Surface &rail, const Surface &wheel)
    {
      const double  K = 0.5 * (elasticity(scene.rail_material).bulk_modulus() +
                              elasticity(scene.wheel_material).bulk_modulus());
      const Penalty penalty =
        make_penalty(scene.penalty_scale, K, scene.cell_size, scene.contact_damping, solid.stable.step);
      for (const Surface *surface : {&rail, &wheel})
        add_surface_mass(*surface, penalty.added_mass, solid.added_mass.data());
      ContactLaw law{penalty.stiffness, penalty.damping, friction_law(scene), {}};
      if (scene.surface_filter)
        for (const int body : {0, 1})
          {
            const ElementBlocks &blocks = solid.blocks[body];
            law.filter[body] =
              surface_filter(element_stiffness(element_geometry(unit_cube()), blocks.material, blocks.form),
                             blocks.material);
          }
      return law;
    }
  } // namespace


  Elasticity
  elasticity(const MaterialData &material)
  {
    return {material.youngs_modulus, material.poissons_ratio, material.density};
  }


  Plasticity
  plasticity(const MaterialData &material)
  {
    return {material.yield_stress, material.tangent_modulus, material.kinematic_hardening};
  }


  SweepPlan
  sweep_plan(const Scene &scene, const ContactGeometry &geometry, const double expected_approach)
  {
    const RailProfile  rail  = scene_rail(scene);
    const WheelProfile wheel = scene_wheel(scene);
    const FrameProfile rail_frame(rail.head, geometry.rail, geometry.frame);
    const FrameProfile wheel_frame(wheel.tread, geometry.wheel, geometry.frame);

    SweepPlan plan;
    plan.levels        = std::max(0L, std::lround(std::log2(scene.coarse_cell_size / scene.cell_size)));
    const double block = scene.cell_size * std::pow(2., plan.levels);
    plan.strip =
      make_fine_strip(geometry, wheel_frame, rail_frame, expected_approach, scene.fine_margin, block);
    plan.surfaces.frame           = geometry.frame;
    plan.surfaces.wheel_placement = geometry.wheel;
    plan.surfaces.nominal_radius  = scene.track.nominal_radius;
    plan.surfaces.rolling_radius  = geometry.rolling_radius;
    const double s0 =
      std::max({plan.strip.s.front() - scene.cell_size, rail_frame.s_min(), wheel_frame.s_min()});
    const double s1 =
      std::min({plan.strip.s.back() + scene.cell_size, rail_frame.s_max(), wheel_frame.s_max()});
    plan.surfaces.rail  = HeightTable(rail_frame, s0, s1);
    plan.surfaces.wheel = HeightTable(wheel_frame, s0, s1);

    plan.sectors         = std::lround(2 * M_PI * geometry.rolling_radius / block);
    const double reach   = half_length_bound(expected_approach, geometry.rolling_radius) + scene.fine_margin;
    plan.fine_begin      = -reach;
    plan.fine_end        = scene.mesh_distance() + reach;
    plan.fine_depth      = scene.fine_depth;
    const double spacing = 2 * M_PI * geometry.rolling_radius / plan.sectors;
    const double middle  = 0.5 * scene.mesh_distance();
    plan.rail_stations   = rail_stations(middle - 0.5 * scene.rail_length,
                                       middle + 0.5 * scene.rail_length,
                                       plan.fine_begin,
                                       plan.fine_end,
                                       spacing);

    WheelDimensions dimensions = scene.wheel;
    dimensions.nominal_radius  = scene.track.nominal_radius;
    plan.rail                  = make_rail_section(rail, geometry.rail, plan.strip, block);
    plan.wheel                 = make_wheel_section(wheel, dimensions, geometry.wheel, plan.strip, block);
    return plan;
  }


  Model
  make_model(const Scene &scene, MPI_Comm communicator)
  {
    Model model;
    model.geometry =
      find_contact(scene_rail(scene), scene_wheel(scene), scene.track, scene.lateral_shift, scene.roll);
    model.expected_approach = expected_approach(scene, model.geometry.rolling_radius);

    SweepPlan     plan    = sweep_plan(scene, model.geometry, model.expected_approach);
    const Lattice lattice = make_lattice(plan);
    model.forest          = std::make_unique<Forest>(communicator, std::move(plan));
    model.solid =
      make_solid(model.forest->local_mesh(),
                 elasticity(scene.rail_material),
                 elasticity(scene.wheel_material),
                 scene.bulk_viscosity,
                 communicator,
                 {plasticity(scene.rail_material), plasticity(scene.wheel_material)},
                 {scene.rail_element.value_or(scene.element), scene.wheel_element.value_or(scene.element)});
    lower_stable_step(model.solid, scene.bulk_viscosity, communicator);

    const RunningSurfaces &surfaces = model.forest->plan().surfaces;
    Surface                rail = make_surface(model.solid.mesh, Body::rail, surfaces, lattice, communicator);
    Surface          wheel = make_surface(model.solid.mesh, Body::wheel, surfaces, lattice, communicator);
    const ContactLaw law   = make_law(scene, model.solid, rail, wheel);
    const double     half_window =
      half_length_bound(model.expected_approach, surfaces.rolling_radius) + 2 * scene.cell_size;
    model.contact =
      std::make_unique<Contact>(std::move(rail), std::move(wheel), surfaces, law, half_window, communicator);

    AxleData &axle     = model.axle;
    axle.centre        = {model.geometry.axle.x, model.geometry.axle.y, 0};
    axle.axis          = {std::cos(model.geometry.wheel.angle), std::sin(model.geometry.wheel.angle), 0};
    axle.mass          = scene.axle_mass;
    axle.pitch_inertia = scene.axle_pitch_inertia;
    axle.sprung_mass   = scene.sprung_mass;
    axle.stiffness     = scene.suspension_stiffness;
    axle.damping       = scene.suspension_damping;
    axle.gravity       = scene.gravity;
    axle.velocity      = scene.velocity;
    axle.rate_held     = scene.drive == Drive::rate;
    model.wheel_load   = (scene.sprung_mass + scene.axle_mass +
                        mass_properties(model.solid, Body::wheel, axle.centre, communicator).mass) *
                       scene.gravity;
    axle.torque = scene.traction_coefficient * model.wheel_load * surfaces.rolling_radius;

    const double steps =
      std::ceil(scene.rolling_distance / (scene.velocity * scene.time_step_factor * model.solid.stable.step));
    model.time_step = scene.rolling_distance / (scene.velocity * steps);
    return model;
  }
} // namespace wheelrail
