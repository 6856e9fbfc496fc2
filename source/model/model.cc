#include <wheelrail/base/errors.h>
#include <wheelrail/base/gather_all.h>
#include <wheelrail/contact/make_law.h>
#include <wheelrail/mesh/lattice.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/moved_cells.h>
#include <wheelrail/model/planned_strip.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/model/scene_motion.h>
#include <wheelrail/model/scene_parts.h>
#include <wheelrail/solid/highest_frequency.h>
#include <wheelrail/solid/point_state.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <variant>
#include <vector>

namespace wheelrail
{
  namespace
  {
    SolidChoice
    bodies_of(const Scene &scene)
    {
      return {{material_law(scene.rail_material), material_law(scene.wheel_material)},
              {scene.rail_element.value_or(scene.element), scene.wheel_element.value_or(scene.element)},
              scene.bulk_viscosity,
              highest_frequency(scene)};
    }

    ContactLaw
    make_law(const Scene &scene, const Solid &solid)
    {
      const auto body = [](const ElementBlocks &blocks) {
        return ContactBody{blocks.elasticity(), blocks.form};
      };
      return make_contact_law(
        {body(solid.blocks.rail), body(solid.blocks.wheel)},
        {scene.penalty_scale, scene.cell_size, scene.contact_damping, scene.friction, scene.surface_filter},
        solid.stable.step);
    }

    /// Between the running surfaces of the plan, with a window that holds the longest patch and two cells on
    /// either side of it; to be prepared.
    std::unique_ptr<Contact>
    make_contact(const Scene &scene, const Model &model, MPI_Comm communicator)
    {
      return std::make_unique<Contact>(model.discretization->plan().surfaces,
                                       make_law(scene, model.solid),
                                       model.reach + 2 * scene.cell_size,
                                       communicator);
    }

    /// The axle without its torque, which follows from the load.
    AxleData
    make_axle(const WheelsetSettings &scene, const WheelPose &wheel)
    {
      AxleData axle;
      axle.centre           = wheel.centre();
      axle.axis             = wheel.axis();
      axle.mass             = scene.axle_mass;
      axle.pitch_inertia    = scene.axle_pitch_inertia;
      axle.sprung_mass      = scene.sprung_mass;
      axle.stiffness        = scene.suspension_stiffness;
      axle.damping          = scene.suspension_damping;
      axle.gravity          = scene.gravity;
      axle.velocity         = scene.velocity;
      axle.lateral_creepage = lateral_creepage(scene);
      axle.rate_held        = scene.drive == Drive::rate;
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

    /// The largest step within the wanted fraction of the stable one that divides the time of the run.
    double
    time_step(const RunSettings &scene, const double duration, const StableStep &stable)
    {
      return duration / std::ceil(duration / (scene.time_step_factor * stable.step));
    }

    /// Where a column of the wheel's blocks lies along: they are counted against its arc coordinate, from the
    /// contact of the start on. In reverse it is the same.
    int
    wheel_column(const int column)
    {
      return -1 - column;
    }

    /// The same for the rail, whose blocks are counted from its begin.
    int
    rail_column(const SweepPlan &plan, const int column)
    {
      return static_cast<int>(std::lround(plan.rail_stations[column] / plan.block_length()));
    }

    PerBody<FineZone>
    zones_of(const SweepPlan &plan, const FineWindow &window)
    {
      PerBody<FineZone> zones;
      for (const Body body : both_bodies)
        zones[body] = window_zone(plan, window, body);
      return zones;
    }

    /// The contact on the mesh of the model's window, and the added mass.
    void
    prepare_contact(Model &model, const SweepPlan &plan, MPI_Comm communicator)
    {
      const Range across  = window_across(plan, model.window);
      const auto  collect = [&](const Body body) {
        const Lattice lattice = make_lattice(plan, body, window_range(plan, model.window, body), across);
        return make_surface(model.solid.mesh, body, plan.surfaces, lattice, communicator);
      };
      model.contact->prepare(collect(Body::rail), collect(Body::wheel));
      add_band_mass(model.solid, model.contact->law().added_mass);
    }

    /// Work of a cell: a body that may yield takes 30 % more time (doc/measured.md).
    int
    work_of_cell(const MaterialLaw &law)
    {
      return std::holds_alternative<ElasticLaw>(law) ? 10 : 13;
    }

    /// Bodies on the mesh that the model's window asks for.
    void
    prepare_solid(Model &model, MPI_Comm communicator)
    {
      const SweepPlan &plan     = model.discretization->plan();
      const auto      &material = model.solid.choice.material;
      model.discretization->lay(zones_of(plan, model.window),
                                {work_of_cell(material.rail), work_of_cell(material.wheel)});
      prepare(model.solid, model.discretization->local_mesh(), communicator);
    }

    /// Bodies and contact on the mesh of the start; the contact's law follows from it.
    void
    prepare_start(const Scene &scene, Model &model, MPI_Comm communicator)
    {
      const SweepPlan &plan = model.discretization->plan();
      prepare_solid(model, communicator);
      check_added_mass(scene, model.solid.quality);
      const double of_cells = model.solid.stable.step;
      lower_stable_step(model.solid, scene.bulk_viscosity, communicator);
      model.parts = scene_parts(scene, plan.start_block * plan.block_length(), communicator);
      prepare_parts(model.parts, model.solid);
      lower_stable_step(model.solid, model.parts);
      lower_step_to_path(scene, plan, of_cells, model.solid.stable);
      model.contact = make_contact(scene, model, communicator);
      prepare_contact(model, plan, communicator);
    }

    /// Columns of blocks in which a body has flowed, over all ranks, ascending.
    std::vector<int>
    flowed_columns(const SweepPlan &plan, const Solid &solid, const Body body, MPI_Comm communicator)
    {
      const ElementBlocks      &blocks = solid.blocks[body];
      const std::vector<double> strain = element_plastic_strain(blocks);
      std::set<int>             columns;
      for (std::size_t e = 0; e < blocks.n_elements; ++e)
        if (strain[e] > 0)
          {
            const CellPlace place = CellPlace::of_key(solid.mesh.cell_key[solid.block_cells[body][e]]);
            const int       k     = place.ancestor(0).k;
            columns.insert(body == Body::wheel ? wheel_column(k) : rail_column(plan, k));
          }
      const auto all = gather_all(std::vector<int>(columns.begin(), columns.end()), communicator);
      columns.insert(all.begin(), all.end());
      return {columns.begin(), columns.end()};
    }

    /// Columns that the window of a body covers, at least in part, and those that are kept already.
    std::vector<int>
    covered(const SweepPlan &plan, const FineWindow &window, const Body body)
    {
      const Range   range = window_range(plan, window, body);
      const int     n     = static_cast<int>(plan.sectors);
      std::set<int> all(window.kept[body].begin(), window.kept[body].end());
      for (int k = static_cast<int>(std::floor(range.s0 / plan.block_length()));
           k * plan.block_length() < range.s1;
           ++k)
        all.insert(body == Body::wheel ? (k % n + n) % n : k);
      return {all.begin(), all.end()};
    }
  } // namespace


  TimeScheme
  time_scheme(const RunSettings &scene, const Model &model)
  {
    return {model.time_step, scene.bulk_viscosity, 0};
  }


  namespace
  {
    /// The scene under the load that its fine cells are laid for.
    Scene
    under_planned_load(const Scene &scene)
    {
      Scene planned = scene;
      if (scene.planned_load > 0)
        planned.wheel_load = scene.planned_load;
      return planned;
    }

    SweepSizes
    sweep_sizes(const Scene &scene, const SceneGeometry &geometry, const std::vector<PathSample> &path)
    {
      SweepSizes sizes;
      sizes.cell        = scene.cell_size;
      sizes.coarse      = scene.coarse_cell_size;
      sizes.fine_depth  = scene.depth_of_fine_cells();
      sizes.fine_margin = scene.fine_margin;
      Scene planned     = under_planned_load(scene);
      for (const PathSample &sample : path)
        if (sample.scene.wheel_load > 0)
          planned.wheel_load = std::max(planned.wheel_load, sample.scene.wheel_load);
      sizes.approach    = expected_approach(planned, geometry.contact.rolling_radius);
      sizes.distance    = scene.mesh_distance();
      sizes.rail_length = scene.rail_length;
      sizes.start       = scene.start_offset;
      if (scene.second_rail != "none") // its surface ends with the path
        sizes.onward = 0;
      sizes.moving = scene.window == MeshWindow::moving;
      plan_for_path(geometry, path, sizes);
      plan_for_irregularities(geometry, sizes);
      if (!path.empty()) // overlaps are those of the start's place across
        sizes.overlaps.clear();
      return sizes;
    }

    SweepPlan
    plan_of(const Scene &scene, const SceneGeometry &geometry, SweepSizes sizes)
    {
      const WheelDimensions wheel = scene.wheel_dimensions();
      if (scene.planned_strip.empty())
        return make_sweep_plan(geometry, wheel, sizes);
      // whatever wheel passes, at whatever place: the rail stays the same
      Scene planned                    = under_planned_load(scene);
      planned.wheel_material           = planned.rail_material;
      sizes.approach                   = expected_approach(planned, scene.track.nominal_radius);
      const PlannedStrip planned_strip = plan_strip(scene, geometry);
      sizes.strip                      = planned_strip.s;
      return make_sweep_plan(planned_strip.profiles, wheel, sizes);
    }

    /// The path over which a run until steady is brought to the balance of its torque, one and a half lengths
    /// of the patch (see run_in()) [m]; 0 where there is none to come to: at a given rate, with more torque
    /// than friction carries, and of starts that are to settle by themselves.
    double
    run_in_length(const Scene &scene, const SceneGeometry &geometry)
    {
      constexpr double most_of_friction = 0.95, too_long = 0.9; // of the expected patch
      if (!scene.until_steady() || scene.drive != Drive::torque ||
          scene.start != StartState::steady_rolling || scene.friction.kind != FrictionKind::constant ||
          !(std::abs(scene.traction_coefficient) < most_of_friction * scene.friction.at(0)))
        return 0;
      return 1.5 * too_long * expected_patch(scene, geometry).length;
    }

    /// Sprung mass, load and drive of the axle, once the mass of the wheel is known.
    void
    load_axle(const Scene                   &scene,
              const SceneGeometry           &geometry,
              const std::vector<PathSample> &path,
              Model                         &model,
              MPI_Comm                       communicator)
    {
      model.axle = make_axle(scene, model.contact->surfaces().pose());
      // the highest S(s, z) over the wheel rises as S does where they touch, at s = 0 (envelope)
      model.axle.rise =
        model.contact->surfaces().rail.at(0, 0).slope_along / std::cos(geometry.contact.angle);
      const double unsprung =
        scene.axle_mass + mass_properties(model.solid, Body::wheel, model.axle.centre, communicator).mass;
      if (scene.wheel_load > 0)
        model.axle.sprung_mass = sprung_mass_for(scene, unsprung);
      model.wheel_load = (model.axle.sprung_mass + unsprung) * scene.gravity;
      model.axle.torque =
        drive_torque(geometry.contact, scene.traction_coefficient * model.wheel_load, model.wheel_load);
      model.axle.torque_ramp = run_in_length(scene, geometry);
      if (!path.empty())
        model.axle.path = std::make_shared<GuidedPath>(make_path(scene, path, model.wheel_load));
    }
  } // namespace


  SweepPlan
  sweep_plan(const Scene &scene, const SceneGeometry &geometry)
  {
    return plan_of(scene, geometry, sweep_sizes(scene, geometry, sample_path(scene, geometry)));
  }


  StableStep
  limit_of_step(const Scene &scene, const SceneGeometry &geometry)
  {
    return step_on_path(scene, sweep_plan(scene, geometry));
  }


  Model
  make_model(const Scene &scene, const SceneGeometry &geometry, MPI_Comm communicator)
  {
    const std::vector<PathSample> path  = sample_path(scene, geometry);
    const SweepSizes              sizes = sweep_sizes(scene, geometry, path);
    Model                         model;
    model.geometry          = geometry.contact;
    model.expected_approach = expected_approach(scene, geometry.contact.rolling_radius);
    const Range overlap     = overlap_along(
      geometry, std::max(model.expected_approach, path.empty() ? 0 : sizes.approach), scene.fine_margin);
    model.reach           = std::max({-overlap.s0, overlap.s1, -sizes.along.s0, sizes.along.s1});
    model.discretization  = std::make_unique<Discretization>(communicator, plan_of(scene, geometry, sizes));
    model.solid.choice    = bodies_of(scene);
    const double end      = scene.mesh_distance() + sizes.ahead.s1;
    model.window.path_end = {end, end};
    prepare_start(scene, model, communicator);
    load_axle(scene, geometry, path, model, communicator);
    model.duration  = run_duration(scene);
    model.time_step = time_step(scene, model.duration, model.solid.stable);
    return model;
  }


  void
  prepare_mesh(Model &model, MPI_Comm communicator)
  {
    prepare_solid(model, communicator);
    prepare_contact(model, model.discretization->plan(), communicator);
  }


  bool
  move_window(const MeshSettings &scene, Model &model, const PerBody<double> &place, MPI_Comm communicator)
  {
    const SweepPlan &plan   = model.discretization->plan();
    const FineWindow before = model.window;
    if (!follow(model.window, plan, place))
      return false;
    for (const Body body : both_bodies)
      if (scene.behind_wheel == BehindWheel::automatic)
        model.window.kept[body] = flowed_columns(plan, model.solid, body, communicator);
      else if (scene.behind_wheel == BehindWheel::keep)
        model.window.kept[body] = covered(plan, before, body);
    return true;
  }


  void
  keep_flowed(const MeshSettings &scene, Model &model, const Body body, MPI_Comm communicator)
  {
    model.window.kept[body].clear();
    if (scene.behind_wheel != BehindWheel::coarsen)
      model.window.kept[body] = flowed_columns(model.discretization->plan(), model.solid, body, communicator);
  }


  bool
  lengthen_path(Model &model, const double distance)
  {
    bool longer = false;
    for (const Body body : both_bodies)
      {
        const double before         = window_range(model.discretization->plan(), model.window, body).s1;
        model.window.path_end[body] = std::max(model.window.path_end[body], distance);
        longer = longer || window_range(model.discretization->plan(), model.window, body).s1 > before;
      }
    return longer;
  }
} // namespace wheelrail
