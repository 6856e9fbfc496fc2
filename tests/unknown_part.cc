// ranks: 1 2

// A part that the program does not know, in one file: vertical springs under the rail's foot that stand on a
// mass of their own, which stands on a spring on the ground. It takes part in start, steps, energy balance
// and saved states as the program's own parts do.

#include <wheelrail/base/gather_all.h>
#include <wheelrail/dynamics/rolling.h>
#include <wheelrail/dynamics/supports.h>
#include <wheelrail/run/run_start.h>
#include <wheelrail/solid/boundary_nodes.h>
#include <wheelrail/solid/highest_frequency.h>
#include <wheelrail/state/checkpoint.h>

#include "checkpoint_everywhere.h"
#include "parallel.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  class SprungFoot : public Part
  {
  public:
    SprungFoot(const double stiffness, const double mass, const double ground, MPI_Comm communicator)
      : stiffness_(stiffness)
      , mass_(mass)
      , ground_(ground)
      , communicator_(communicator)
    {
    }

    void
    prepare(const Solid &solid, std::vector<NodeInertia> &) override
    {
      mesh_ = &solid.mesh;
      foot_ = held_boundary_nodes(solid.mesh, Boundary::foot);
      foot_.erase(
        std::remove_if(foot_.begin(), foot_.end(), [&](const auto n) { return solid.mass[n] == 0; }),
        foot_.end());
      nodes_ = 0;
      for (const unsigned int n : foot_)
        nodes_ += mesh_->owns(n);
      MPI_Allreduce(MPI_IN_PLACE, &nodes_, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    }

    void
    enter(EnergyBalance &energies) override
    {
      springs_ = &energies.term("foot_spring_energy", EnergyKind::stored);
      kinetic_ = &energies.term("foot_mass_energy", EnergyKind::stored);
    }

    void
    add_forces(const Instant &now, Solid &solid) override
    {
      double force = -ground_ * place_, energy = 0;
      for (const unsigned int n : foot_)
        {
          const double stretch = solid.displacement[4 * n + 1] - place_;
          solid.force[4 * n + 1] -= of_node() * stretch;
          energy += mesh_->owns(n) ? 0.5 * of_node() * stretch * stretch : 0;
        }
      force += stiffness_ * (mean(solid.displacement.data()) - place_);
      if (now.with_energy)
        springs_->here += energy + share(0.5 * ground_ * place_ * place_);
      const double before = speed_;
      advance(place_, speed_, force / mass_, now.velocity_update, now.step);
      if (now.with_energy) // at the full step: the mean of the half steps around it
        kinetic_->here += share(now.first ? 0.5 * mass_ * before * before : 0.5 * mass_ * before * speed_);
    }

    double
    squared_frequency(const Solid &solid) const override
    {
      double lightest = 1e300;
      for (const unsigned int n : foot_)
        lightest = std::min(lightest, solid.mass[n]);
      MPI_Allreduce(MPI_IN_PLACE, &lightest, 1, MPI_DOUBLE, MPI_MIN, communicator_);
      return of_node() / lightest + (stiffness_ + ground_) / mass_;
    }

    void
    add_stiffness(const Solid &, const double *x, double *y) const override
    {
      const double place = rest_of(x);
      for (const unsigned int n : foot_)
        y[4 * n + 1] += of_node() * (x[4 * n + 1] - place);
    }

    void
    add_springs(double *stiffness) const override
    {
      for (const unsigned int n : foot_)
        stiffness[4 * n + 1] += of_node() * ground_ / (stiffness_ + ground_);
    }

    void
    start(const Solid &solid) override
    {
      place_ = rest_of(solid.displacement.data());
      speed_ = rest_of(solid.velocity.data());
    }

    std::string
    name() const override
    {
      return "sprung_foot";
    }
    PartState
    state() const override
    {
      return {{{"place", place_}, {"speed", speed_}}, {}, {}};
    }
    void
    set_state(const PartState &state) override
    {
      place_ = state.numbers.at("place");
      speed_ = state.numbers.at("speed");
    }

    double
    place() const
    {
      return place_;
    }

  private:
    double
    of_node() const
    {
      return stiffness_ / nodes_;
    }
    /// Vertical, of all foot nodes.
    double
    mean(const double *x) const
    {
      double sum[1] = {0};
      for (const unsigned int n : foot_)
        sum[0] += mesh_->owns(n) ? x[4 * n + 1] : 0;
      ordered_sum(sum, communicator_);
      return sum[0] / nodes_;
    }
    /// Where the mass is in equilibrium.
    double
    rest_of(const double *x) const
    {
      return stiffness_ * mean(x) / (stiffness_ + ground_);
    }
    /// On one rank alone: all know the mass.
    double
    share(const double energy) const
    {
      int rank;
      MPI_Comm_rank(communicator_, &rank);
      return rank == 0 ? energy : 0;
    }

    double                    stiffness_, mass_, ground_;
    MPI_Comm                  communicator_;
    const LocalMesh          *mesh_ = nullptr;
    std::vector<unsigned int> foot_;
    double                    nodes_ = 0; ///< of the foot over all ranks
    double                    place_ = 0, speed_ = 0;
    EnergyTerm               *springs_ = nullptr, *kinetic_ = nullptr;
  };

  constexpr double stiffness = 40e6, mass = 5, ground = 20e6;

  /// The small scene with ends that are held and a foot that stands on the part.
  struct Track
  {
    Scene                     scene = small_scene(4e-3);
    Model                     model = make_model(scene, make_geometry(scene), MPI_COMM_WORLD);
    SprungFoot               *foot  = nullptr;
    std::unique_ptr<Axle>     axle;
    std::unique_ptr<Rolling>  rolling;
    std::unique_ptr<Recorder> recorder;

    Track()
    {
      auto part      = std::make_unique<SprungFoot>(stiffness, mass, ground, MPI_COMM_WORLD);
      foot           = part.get();
      model.parts[0] = std::make_unique<Supports>(std::vector<Boundary>{Boundary::end});
      model.parts.push_back(std::move(part));
    }

    void
    set_out(const double hub_displacement, const double rate)
    {
      axle    = std::make_unique<Axle>(model.axle, hub_displacement, rate, MPI_COMM_WORLD);
      rolling = std::make_unique<Rolling>(
        model.solid, *model.contact, model.parts, *axle, time_scheme(scene, model), MPI_COMM_WORLD);
      recorder = std::make_unique<Recorder>(model);
    }
  };

  /// A whole checkpoint by way of a file, on all ranks.
  Checkpoint
  saved(const Track &track, const int rank)
  {
    return test::everywhere(
      gather_checkpoint(take_checkpoint(track.model, *track.rolling, *track.recorder), MPI_COMM_WORLD), rank);
  }

  void
  stable_step(Track &track)
  {
    Solid       &solid  = track.model.solid;
    const double before = solid.stable.step;
    prepare_parts(track.model.parts, solid);
    const double added = track.foot->squared_frequency(solid);
    lower_stable_step(solid, track.model.parts);
    BOOST_TEST(added > stiffness / mass, "the part stiffens the scene");
    BOOST_TEST(near(4 / (solid.stable.step * solid.stable.step) - 4 / (before * before),
                    added,
                    1e-3 * added,
                    "the stable step is that of bodies and part [1/s2]"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(unknown_part)
{
  const Parallel parallel;
  Track          track;
  stable_step(track);
  Log            log;
  const RunStart start = start_from_rest(track.scene, track.model, {}, log);
  BOOST_TEST(track.foot->place() < 0,
             "the static start stands on the mass, which gives way: " +
               std::to_string(1e6 * track.foot->place()) + " um");
  track.set_out(start.hub_displacement, start.rate);

  Rolling   &rolling = *track.rolling;
  double     low = 1e300, high = -1e300, worst = 0;
  const auto step = [&](const bool energy) {
    rolling.step(energy);
    const double share = rolling.contact_sums().force[1] / track.model.wheel_load;
    low                = std::min(low, share);
    high               = std::max(high, share);
    worst              = energy ? std::max(worst, rolling.energy().error()) : worst;
  };
  step(true);
  BOOST_TEST(near(high, 1, 0.005, "first step: vertical force over the weight"));
  for (int n = 2; n <= 120; ++n)
    step(n % 5 == 0);
  const Checkpoint whole = saved(track, parallel.rank);
  BOOST_TEST((whole.rolling.parts.at("sprung_foot").numbers.at("place") == track.foot->place()),
             "the part's state is saved");
  for (int n = 121; n <= 240; ++n)
    step(n % 5 == 0);
  BOOST_TEST(near(low, 1, 0.03, "smallest vertical force over the weight"));
  BOOST_TEST(near(high, 1, 0.03, "largest vertical force over the weight"));
  BOOST_TEST(near(worst, 0, 2e-3, "energy error, largest"));
  BOOST_TEST(rolling.energy()["foot_spring_energy"] > 0, "named energies");

  Track again;
  again.set_out(0, 0);
  restore_checkpoint(whole, again.model, *again.rolling, *again.recorder, MPI_COMM_WORLD);
  for (int n = 121; n <= 240; ++n)
    again.rolling->step(n % 5 == 0);
  BOOST_TEST((again.foot->place() == track.foot->place() && again.axle->height() == track.axle->height() &&
              again.rolling->energy()["foot_spring_energy"] == rolling.energy()["foot_spring_energy"]),
             "a run that goes on makes the same steps, bit for bit");
}
