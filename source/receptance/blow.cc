#include <wheelrail/base/interrupt.h>
#include <wheelrail/dynamics/time_loop.h>
#include <wheelrail/mesh/discretization.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/model/scene_parts.h>
#include <wheelrail/receptance/blow.h>
#include <wheelrail/solid/highest_frequency.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// The axle of the scene at rest and without weight.
    AxleData
    axle_at_rest(const WheelsetSettings &scene, const SceneGeometry &geometry)
    {
      AxleData axle;
      axle.centre        = geometry.contact.pose.centre();
      axle.axis          = geometry.contact.pose.axis();
      axle.mass          = scene.axle_mass;
      axle.pitch_inertia = scene.axle_pitch_inertia;
      axle.sprung_mass   = scene.sprung_mass;
      axle.stiffness     = scene.suspension_stiffness;
      axle.damping       = scene.suspension_damping;
      axle.gravity       = 0;
      return axle;
    }
  } // namespace


  LoneBody::~LoneBody() = default;


  std::unique_ptr<LoneBody>
  make_lone_body(const Scene &scene, const SceneGeometry &geometry, const Body body, MPI_Comm communicator)
  {
    auto lone  = std::make_unique<LoneBody>();
    lone->plan = sweep_plan(scene, geometry);
    Discretization discretization(communicator, lone->plan, {body});
    discretization.lay({});
    lone->solid.choice = {
      {ElasticLaw(elasticity(scene.rail_material)), ElasticLaw(elasticity(scene.wheel_material))},
      {scene.rail_element.value_or(scene.element), scene.wheel_element.value_or(scene.element)},
      scene.bulk_viscosity};
    Solid &solid = lone->solid;
    prepare(solid, discretization.local_mesh(), communicator);
    lower_stable_step(solid, scene.bulk_viscosity, communicator);
    if (body == Body::rail)
      {
        lone->parts = scene_parts(scene, lone->plan.start_block * lone->plan.block_length(), communicator);
        prepare_parts(lone->parts, solid);
        lower_stable_step(solid, lone->parts);
      }
    else
      lone->axle = std::make_unique<Axle>(axle_at_rest(scene, geometry), 0., 0., communicator);
    lone->time_step = scene.time_step_factor * solid.stable.step;
    return lone;
  }


  BlowRecord
  strike(const RunSettings                 &scene,
         LoneBody                          &body,
         const std::vector<HammerFace>     &faces,
         const double                       duration,
         MPI_Comm                           communicator,
         const std::function<void(double)> &report)
  {
    constexpr double peak = 1e3, pulse = 0.25e-3; // zero at 8 kHz, a third of its spectrum left at 5 kHz
    constexpr double sample = 20e-6, balance = 1e-3;
    Solid           &solid = body.solid;
    Hammer           hammer(faces.front(), peak, pulse, communicator);
    TimeLoop         loop(solid, {body.time_step, scene.bulk_viscosity, 0}, communicator);
    for (const auto &part : body.parts)
      loop.add(*part);
    if (body.axle)
      loop.add(*body.axle);
    loop.add(hammer);
    loop.prepare();

    std::vector<FaceNodes> observed;
    for (const HammerFace &face : faces)
      observed.push_back(face_nodes(solid.mesh, face, communicator));
    const auto          every = static_cast<unsigned long>(std::max(1., std::floor(sample / body.time_step)));
    const auto          check = static_cast<unsigned long>(std::ceil(balance / body.time_step));
    BlowRecord          record;
    std::vector<double> places(faces.size());
    record.step = every * body.time_step;
    record.moved.resize(faces.size());
    while (loop.time() < duration)
      {
        if (loop.steps() % every == 0)
          {
            leave_if_interrupted();
            if (report)
              report(loop.time() / duration);
            for (std::size_t f = 0; f < faces.size(); ++f)
              {
                places[f] = 0;
                for (const auto &[node, share] : observed[f].share)
                  for (int i = 0; i < 3; ++i)
                    places[f] += share * observed[f].direction[i] * solid.displacement[4 * node + i];
              }
            MPI_Allreduce(MPI_IN_PLACE,
                          places.data(),
                          static_cast<int>(places.size()),
                          MPI_DOUBLE,
                          MPI_SUM,
                          communicator);
            for (std::size_t f = 0; f < faces.size(); ++f)
              record.moved[f].push_back(places[f]);
            record.force.push_back(hammer.force(loop.time()));
          }
        const bool with_energy = loop.steps() == 0 || loop.steps() % check == 0;
        loop.step(with_energy);
        if (with_energy)
          record.energy_error = std::max(record.energy_error, loop.energy().error());
      }
    record.time_steps = loop.steps();
    return record;
  }
} // namespace wheelrail
