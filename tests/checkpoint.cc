// ranks: 1 2

// Runs that are stopped and go on: the same bits whether and where they were stopped, and what is refused.
// All start from one static start: a second one in the same process agrees within its tolerance only.

#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/output/vtu.h>

#include "error_of.h"
#include "parallel.h"
#include "read_output.h"
#include "small_scene.h"
#include "stopped_runs.h"

#include <cstring>
#include <filesystem>
#include <iostream>

using namespace wheelrail;
using namespace test;
namespace fs = std::filesystem;

namespace
{
  int rank = 0, size = 1;

  Scene
  scene(const std::string &name)
  {
    Scene scene               = small_scene(4e-3);
    scene.title               = "stopped and gone on";
    scene.ticks               = 5;
    scene.checkpoint_interval = 0.05;
    scene.folder              = "checkpoint_" + std::to_string(size) + "_" + name;
    return scene;
  }

  /// The text of the error of a run that is refused or stops.
  template <typename Error>
  std::string
  error_of(const Scene &scene, const bool resume)
  {
    return test::error_of<Error>([&]() { run(scene, resume); });
  }

  /// Rank 0 changes files while the others wait.
  template <typename Work>
  void
  on_disk(const Work &work)
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank == 0)
      work();
    MPI_Barrier(MPI_COMM_WORLD);
  }

  unsigned int
  count_checkpoints(const std::string &folder)
  {
    MPI_Barrier(MPI_COMM_WORLD);
    unsigned int n = 0;
    for (const auto &entry : fs::directory_iterator(folder))
      n += entry.path().filename().string().rfind("checkpoint", 0) == 0;
    return n;
  }

  /// Same bits in history, patches, series and all figures but those of time and memory.
  void
  compare(const std::string &one_go, const std::string &gone_on, const std::string &what)
  {
    const History a = read_history(one_go + "/history.h5"), b = read_history(gone_on + "/history.h5");
    BOOST_TEST((!a.columns.empty() && a.columns[0].size() > 50 && a.columns == b.columns),
               what + ": the same history");
    const Summary s = read_summary(one_go + "/summary.json"), t = read_summary(gone_on + "/summary.json");
    for (const std::string &key :
         split_list("normal_force_N, longitudinal_force_N, max_pressure_Pa, contact_area_m2, creepage, "
                    "stick_fraction, max_von_mises_Pa, rolled_distance_m, time_steps, energy_error, "
                    "relative_roll_rad"))
      BOOST_TEST((get_figure(s, key) == get_figure(t, key)), what << ": the same " << key);
    BOOST_TEST((s.finished && t.finished), what + ": both have finished");
    for (unsigned int tick = 0; tick < 5; ++tick)
      {
        const PatchFields p = read_patch(one_go + "/patch.h5", tick),
                          q = read_patch(gone_on + "/patch.h5", tick);
        BOOST_TEST((p.time == q.time && p.pressure == q.pressure && p.slip_along == q.slip_along),
                   what + ": the same patch at tick " + std::to_string(tick));
      }
    for (const char *name : {"/surface.pvd", "/window.pvd"})
      {
        PvdSeries u(one_go + name), v(gone_on + name);
        u.load();
        v.load();
        BOOST_TEST((u.entries().size() == 5 && u.entries() == v.entries()), what + ": the same " + name);
      }
  }

  /// A copy of a run in a folder of its own.
  Scene
  copy(const Scene &from, const std::string &name)
  {
    Scene to = scene(name);
    on_disk([&]() {
      fs::remove_all(to.folder);
      fs::copy(from.folder, to.folder);
    });
    return to;
  }

  /// Interrupted after step 200 of 397, with ticks at 80 and 159.
  Scene
  interrupted_run()
  {
    Scene base = scene("base");
    BOOST_TEST(run(base, false, 200) == 3, "an interrupted run ends with exit code 3");
    const Summary summary = read_summary(base.folder + "/summary.json");
    BOOST_TEST((!summary.finished && summary.stop_reason == "interrupted" && summary.time_steps == 200),
               "its summary says so");
    BOOST_TEST(count_checkpoints(base.folder) == 3, "its last two states are saved");
    return base;
  }

  std::string
  newest_file(const std::string &folder)
  {
    const std::string marker = read_whole_file(folder + "/checkpoint.json");
    return folder + "/" + marker.substr(marker.find("checkpoint_"), std::strlen("checkpoint_0.h5"));
  }

  std::string
  log_of(const Scene &scene)
  {
    MPI_Barrier(MPI_COMM_WORLD);
    return read_whole_file(scene.folder + "/log.txt");
  }

  void
  change_a_bit(const std::string &file)
  {
    std::string bytes = read_whole_file(file);
    bytes[bytes.size() / 2] ^= 1;
    on_disk([&]() { replace_file(file, bytes); });
  }

  /// From the state before the interruption on: the steps up to it are those of a run that was not stopped.
  void
  gone_back(const Scene &base, const Scene &one_go)
  {
    const Scene again = copy(base, "again");
    change_a_bit(newest_file(again.folder));
    BOOST_TEST(run(again, true, 250) == 3, "gone on from the older state, since the newer one is damaged");
    BOOST_TEST((log_of(again).find("goes on from the state before it") != std::string::npos),
               "and it says so");
    BOOST_TEST(
      (log_of(again).find("driving, traction coefficient 0.25 of friction 0.5") != std::string::npos),
      "the log says in words what is computed");
    const std::string newest = newest_file(again.folder);
    on_disk([&]() { fs::resize_file(newest, fs::file_size(newest) / 3); });
    BOOST_TEST(run(again, true, 350) == 3, "gone on from the older state, since the newer one is torn");
    BOOST_TEST(run(again, true) == 0, "gone on to the end");
    compare(one_go.folder, again.folder, "interrupted");
    BOOST_TEST(count_checkpoints(again.folder) == 0, "a finished run keeps no checkpoint");
  }

  void
  stopped_by_limit(const Scene &base, const Scene &one_go)
  {
    Scene gone_on        = copy(base, "limit");
    gone_on.energy_limit = 1e-12;
    BOOST_TEST((error_of<RunError>(gone_on, true).find("energy balance") != std::string::npos),
               "the energy limit stops a run");
    BOOST_TEST((error_of<InputError>(gone_on, true).find("would stop there again") != std::string::npos),
               "the same limit again is refused");
    gone_on.energy_limit = one_go.energy_limit;
    BOOST_TEST(run(gone_on, true) == 0, "it goes on with a larger limit from the last good state");
    compare(one_go.folder, gone_on.folder, "stopped by limit");
  }

  void
  check_refusal(const Scene &scene, const std::string &part, const std::string &what)
  {
    const std::string error = error_of<InputError>(scene, true);
    BOOST_TEST((error.find(part) != std::string::npos && error.find('\n') == std::string::npos),
               what << ", found: " << error);
  }

  void
  damaged(const Scene &saved)
  {
    const std::string marker = saved.folder + "/checkpoint.json", text = read_whole_file(marker);
    const auto        with = [&](const std::string &old, const std::string &fresh) {
      std::string changed = text;
      on_disk([&]() { replace_file(marker, changed.replace(changed.find(old), old.size(), fresh)); });
    };
    with("\"format\": 11", "\"format\": 99");
    check_refusal(saved, "of format 99", "another format");
    with("{", "");
    check_refusal(saved, "of format", "a marker that cannot be read");
    with("checkpoint_", "checkpoint_"); // as it was
    for (const char *name : {"/checkpoint_0.h5", "/checkpoint_1.h5"})
      change_a_bit(saved.folder + name);
    check_refusal(saved, "checksum", "one bit changed in both files");
    on_disk([&]() { fs::remove(saved.folder + "/checkpoint_0.h5"); });
    check_refusal(saved, "damaged or missing", "a missing file");
  }

  void
  refusals(const Scene &base, const Scene &one_go)
  {
    check_refusal(one_go, "has finished", "a finished run is not gone on with");
    check_refusal(scene("nowhere"), "there is no run to go on with", "no folder, nothing to go on from");
    MPI_Barrier(MPI_COMM_WORLD); // the root removes what it made
    BOOST_TEST(!fs::exists(scene("nowhere").folder), "and none is made");

    const Scene saved      = copy(base, "refused");
    Scene       other      = saved;
    other.cell_size        = 2e-3;
    other.velocity         = 30;
    other.rolling_distance = 7e-3;
    other.ticks            = 2;
    other.title            = "another title is accepted";
    check_refusal(other,
                  "Mesh/Solution cell size = 2 mm, saved with 4 mm; Wheelset/Velocity = 108 km/h, saved with "
                  "140 km/h; set them back",
                  "other entries are named");
    const std::string error = error_of<InputError>(other, true);
    BOOST_TEST((error.find("Title") == std::string::npos && error.find("Ticks") == std::string::npos),
               "title and ticks may differ");
    other                  = saved;
    other.rolling_distance = 80e-3;
    check_refusal(other, "on the rail of the saved state the wheel can roll 5", "no rail for a longer way");
    other.rolling_distance = 3e-3;
    check_refusal(other, "has rolled", "a distance that is behind");
    damaged(saved);
  }
} // namespace


BOOST_AUTO_TEST_CASE(checkpoint)
{
  const Parallel parallel;
  rank = parallel.rank, size = parallel.size;
  const Scene base = interrupted_run(), one_go = copy(base, "one_go");
  BOOST_TEST(run(one_go, true) == 0, "a run that goes on");
  gone_back(base, one_go);
  stopped_by_limit(base, one_go);
  refusals(base, one_go);
  Scene longer            = copy(base, "longer");
  longer.rolling_distance = 7e-3;
  BOOST_TEST(run(longer, true) == 0, "a run that goes on with a longer way");
}
