// Commands read each profile file once, however many of their parts need the profiles: Linux tells how often
// a file is opened (inotify).

#include "parallel.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/run/run_scene.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include <sys/inotify.h>
#include <unistd.h>

using namespace wheelrail;
namespace fs = std::filesystem;

namespace
{
  /// Counts how often a file is opened.
  class Openings
  {
  public:
    explicit Openings(const fs::path &path)
      : queue_(inotify_init1(IN_NONBLOCK))
    {
      // closings, too: equal events in a row would be merged into one
      BOOST_TEST((queue_ >= 0 && inotify_add_watch(queue_, path.c_str(), IN_OPEN | IN_CLOSE) >= 0),
                 "the file is watched");
    }
    ~Openings()
    {
      close(queue_);
    }
    Openings(const Openings &) = delete;
    Openings &
    operator=(const Openings &) = delete;

    /// Since the last call.
    int
    count() const
    {
      inotify_event events[64]; // of a file, not of a folder: no names stand behind them
      int           n = 0;
      for (ssize_t bytes; (bytes = read(queue_, events, sizeof events)) > 0;)
        for (std::size_t k = 0; k < std::size_t(bytes) / sizeof(inotify_event); ++k)
          n += (events[k].mask & IN_OPEN) != 0;
      return n;
    }

  private:
    int queue_;
  };

  const fs::path folder = "read_once_output";

  void
  check_command(const std::vector<std::string> &arguments,
                const Openings                 &rail,
                const Openings                 &wheel,
                const int                       openings = 1)
  {
    rail.count();
    wheel.count();
    std::ostringstream out;
    const int          code = execute(arguments, run_scene, out);
    BOOST_TEST(test::near(code, 0, 0, arguments[0] + ": exit code"));
    BOOST_TEST(test::near(rail.count(), openings, 0, arguments[0] + ": the rail file is opened"));
    BOOST_TEST(test::near(wheel.count(), openings, 0, arguments[0] + ": the wheel file is opened"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(read_once, test::Parallel)
{
  fs::remove_all(folder);
  fs::create_directories(folder);
  // copies of its own: other tests may read the originals at the same time
  const fs::path rail_file = folder / "worn.prr", wheel_file = folder / "worn.prw",
                 prm = folder / "scene.prm";
  fs::copy_file(fs::path(WHEELRAIL_TEST_DIR) / "profiles" / "worn_54E1.prr", rail_file);
  fs::copy_file(fs::path(WHEELRAIL_TEST_DIR) / "profiles" / "worn_S1002.prw", wheel_file);
  std::ofstream(prm)
    << "set Title = read once\n"
    << "subsection Profiles\n  set Rail = " << rail_file.string() << "\n  set Wheel = " << wheel_file.string()
    << "\nend\n"
    << "subsection Track\n  set Rail length = 300 mm\nend\n"
    << "subsection Mesh\n  set Solution cell size = 4 mm\n  set Coarse cell size = 16 mm\n  set Fine margin "
       "= 4 mm\nend\n"
    << "subsection Run\n  set Rolling distance = 2 mm\n  set Averaging distance = 1 mm\nend\n"
    << "subsection Half-space\n  set Element size = 1 mm\nend\n"
    << "subsection Output\n  set Folder = " << (folder / "scene").string() << "\n  set Ticks = 1\nend\n";
  const Openings rail(rail_file), wheel(wheel_file);
  check_command({"parameters", prm.string(), "--validate"}, rail, wheel);
  check_command({"geometry", prm.string(), "--shifts", "0"}, rail, wheel);
  check_command({"halfspace", prm.string(), "--no-pictures"}, rail, wheel);
  // read once, and copied once into the output folder, whose copies are read from then on
  check_command({"run", prm.string()}, rail, wheel, 2);
  const Openings kept_rail(folder / "scene/profiles/rail_worn.prr"),
    kept_wheel(folder / "scene/profiles/wheel_worn.prw");
  check_command({"compare", (folder / "scene").string(), "--no-pictures"}, kept_rail, kept_wheel);
  BOOST_TEST(test::near(rail.count() + wheel.count(), 0, 0, "compare: the originals are not opened"));
}
