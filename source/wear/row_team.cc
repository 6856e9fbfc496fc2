#include <wheelrail/wear/wear_mix.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace boost
{
  namespace serialization
  {
    template <class Archive>
    void
    serialize(Archive &archive, wheelrail::MixWear &wear, const unsigned int /*version*/)
    {
      archive &wear.rail_section &wear.wheel_section;
      archive &wear.rail_damage &wear.wheel_damage;
      archive &wear.rail_cracks &wear.wheel_cracks;
      archive &wear.mean_pressure &wear.peak_pressure;
      archive &wear.mean_t_gamma &wear.peak_t_gamma;
      archive &wear.pressure_within.low &wear.pressure_within.high;
      archive &wear.t_gamma_within.low &wear.t_gamma_within.high;
      archive &wear.axle_load &wear.at_end &wear.fault;
      archive &wear.bodies_low &wear.bodies_high;
      archive &wear.with_care &wear.not_trusted &wear.doubts;
    }
  } // namespace serialization
} // namespace boost

namespace wheelrail
{
  RowTeam
  team_of_job()
  {
    namespace MPI = dealii::Utilities::MPI;
    RowTeam team;
    if (!MPI::job_supports_mpi() || MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
      return team;
    team.rank  = MPI::this_mpi_process(MPI_COMM_WORLD);
    team.size  = MPI::n_mpi_processes(MPI_COMM_WORLD);
    team.share = [team](std::vector<MixWear> &rows) {
      std::vector<MixWear> own;
      for (std::size_t k = team.rank; k < rows.size(); k += team.size)
        own.push_back(std::move(rows[k]));
      std::vector<std::vector<MixWear>> all = MPI::all_gather(MPI_COMM_WORLD, own);
      for (std::size_t k = 0; k < rows.size(); ++k)
        rows[k] = std::move(all[k % team.size][k / team.size]);
    };
    return team;
  }
} // namespace wheelrail
