// Contact of the true bodies: balance of forces, figures of an independent program for the same scenes, kept
// tables.

#include "messages.h"

#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/body_pose.h>
#include <wheelrail/bodies/kept_tables.h>
#include <wheelrail/halfspace/added_influence.h>
#include <wheelrail/mesh/section_builder.h>

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;
using test::same_text;

namespace
{
  struct Case
  {
    explicit Case(const std::vector<std::string> &sets, const BodyTableSizes &sizes = {})
      : scene(scene_from_text("", "x.prm", sets).scene)
      , geometry(make_geometry(scene))
      , tables(make_body_tables(scene, geometry, "tables", sizes))
    {
    }

    WheelRailSolution
    solve() const
    {
      return solve_bodies(scene, geometry, scene_load(scene, geometry), tables);
    }

    Scene         scene;
    SceneGeometry geometry;
    BodyTables    tables;
  };

  /// The largest pressure of rows 7 mm and more from that of the peak [Pa].
  double
  second_peak(const HalfspaceSolution &solution)
  {
    const auto &p  = solution.pressure;
    const int   mx = solution.grid.mx, row = int(std::max_element(p.begin(), p.end()) - p.begin()) / mx;
    double      peak = 0;
    for (int j = 0; j < solution.grid.my; ++j)
      if (std::abs(j - row) * solution.grid.dy > 7e-3)
        peak = std::max(peak, *std::max_element(p.begin() + mx * j, p.begin() + mx * (j + 1)));
    return peak;
  }

  /// S1002 on 54E1, elements of 0.5 mm, against another program (Python, sections of its own with rows of 1
  /// mm and three cells a row): free rolling, and the flange root with its second patch.
  void
  test_scenes()
  {
    const std::string element = "Half-space/Element size = 0.5 mm";
    const Case        free({element, "Wheelset/Traction coefficient = 0"});
    const auto        rolled = free.solve();
    BOOST_TEST(rolled.solution.converged(), "free rolling: converged, " + rolled.solution.not_reached);
    BOOST_TEST(near_relative(
      rolled.vertical, scene_load(free.scene, free.geometry).force, 2e-4, "it carries the load"));
    BOOST_TEST(near(rolled.solution.fx / rolled.vertical, 0, 1e-5, "and no longitudinal force"));
    BOOST_TEST(near_relative(rolled.measures.peak_pressure, 1236.5e6, 3e-3, "peak pressure"));
    BOOST_TEST(near_relative(rolled.solution.xi, 0.4917e-3, 0.015, "creepage"));

    const Case root({element, "Wheelset/Lateral shift = -5.5 mm", "Wheelset/Traction coefficient = 0.25"});
    const auto two = root.solve();
    BOOST_TEST(two.solution.converged(), "flange root: converged, " + two.solution.not_reached);
    BOOST_TEST(
      near(1e-6 * second_peak(two.solution), 350, 50, "a second peak, 7 mm and more from the first, MPa"));
    BOOST_TEST(
      near_relative(two.vertical, scene_load(root.scene, root.geometry).force, 2e-4, "they carry the load"));
    BOOST_TEST(near_relative(-two.solution.fx, 0.25 * two.vertical, 2e-4, "and the traction"));
    BOOST_TEST(near_relative(two.measures.peak_pressure_fitted, 3364e6, 0.01, "peak pressure"));
    BOOST_TEST(near_relative(two.solution.xi, 3.27e-3, 0.035, "creepage"));
    const ContactPose pose = body_pose(root.scene, root.geometry, two);
    BOOST_TEST(near_relative(1e3 * pose.rail_head.lateral, 0.218, 0.04, "rail head moved"));
    BOOST_TEST(near_relative(1e3 * pose.rail_head.roll, -3.11, 0.04, "rail head turned"));
    BOOST_TEST(near_relative(1e3 * pose.wheel_rim.lateral, 0.268, 0.03, "wheel rim moved"));
    BOOST_TEST(near_relative(1e3 * pose.wheel_rim.roll, 0.97, 0.03, "wheel rim turned"));
  }

  /// The outer wheel of a curve of 300 m slides on its flange, where pressure and tractions creep on as long
  /// as tractions are solved no better than what they depend on is known.
  void
  test_curve()
  {
    const Case flange({"Half-space/Element size = 0.4 mm",
                       "Wheelset/Lateral shift = -5.2 mm",
                       "Wheelset/Yaw = -4 mrad",
                       "Wheelset/Wheel load = 84.732 kN",
                       "Wheelset/Velocity = 60 km/h",
                       "Wheelset/Traction coefficient = 0"});
    const auto slides = flange.solve();
    BOOST_TEST(slides.solution.converged(), "flange in a curve: converged, " + slides.solution.not_reached);
    BOOST_TEST(near_relative(slides.vertical, 84.732e3, 2e-4, "it carries the load"));
  }

  /// A run of 1 mm cells on blocks of 8 mm, 38.7 mm rolled, has a lateral force of 1.068 kN, which comes to
  /// that of steady rolling only over some 0.4 m. Under the lateral creepage that makes this force the bodies
  /// stand as in the run.
  void
  test_pose_of_run()
  {
    const Case        driving({"Half-space/Element size = 0.5 mm",
                               "Wheelset/Traction coefficient = 0.25",
                               "Wheelset/Lateral creepage = -0.0152e-3"});
    const auto        rolled = driving.solve();
    const ContactPose pose   = body_pose(driving.scene, driving.geometry, rolled);
    BOOST_TEST(near_relative(1e-3 * rolled.lateral, 1.068, 0.03, "the lateral force of the run"));
    BOOST_TEST(near_relative(1e3 * pose.rail_head.roll, -0.8945, 0.05, "rail head turned"));
    BOOST_TEST(near(1e3 * pose.rail_head.lateral, 0.0697, 0.004, "rail head moved, mm"));
    BOOST_TEST(near(1e3 * pose.wheel_rim.lateral, 0.0167, 0.002, "wheel rim moved, mm"));
    BOOST_TEST(near(1e3 * pose.wheel_rim.roll, 0.0169, 0.01, "wheel rim turned, mrad"));
  }

  /// A table is made once; one that is damaged, or none, is made again.
  void
  test_kept()
  {
    BodyTableSizes coarse;
    coarse.levels = 2;
    std::filesystem::remove_all("tables"); // of an earlier call
    const Case first({}, coarse);
    const auto files = [] {
      std::vector<std::filesystem::path> found;
      for (const auto &file : std::filesystem::directory_iterator("tables"))
        found.push_back(file.path());
      return found;
    };
    const auto kept = files();
    BOOST_TEST(kept.size() == 2, "a table of the rail and one of the wheel are kept");
    const Case again({}, coarse);
    BOOST_TEST((again.tables.wheel.remainder == first.tables.wheel.remainder &&
                again.tables.rail.remainder == first.tables.rail.remainder),
               "read again they are the same");
    namespace fs        = std::filesystem;
    const auto size     = static_cast<std::streamoff>(fs::file_size(kept.front()));
    const auto is_again = [&](const std::string &what) {
      const Case mended({}, coarse);
      BOOST_TEST((mended.tables.wheel.remainder == first.tables.wheel.remainder &&
                  mended.tables.rail.remainder == first.tables.rail.remainder && files().size() == 2),
                 what + ": made again");
    };
    const auto write_at = [&](const std::streamoff place, const std::string &bytes) {
      std::fstream file(kept.front(), std::ios::in | std::ios::out | std::ios::binary);
      file.seekp(place);
      file << bytes;
    };
    fs::resize_file(kept.front(), 1000);
    is_again("cut off");
    write_at(size / 2, std::string(size - size / 2, '\0'));
    is_again("zeros from the middle on");
    for (const std::streamoff place : {std::streamoff(60), size / 4, size / 2, size - 1})
      {
        write_at(place, "x");
        is_again("a changed byte");
      }
    fs::copy_file(kept.back(), kept.front(), fs::copy_options::overwrite_existing);
    is_again("the table of another body");
    fs::remove(kept.front());
    BOOST_TEST(::mkfifo(kept.front().c_str(), 0600) == 0, "a pipe of its name");
    is_again("a pipe");
    BOOST_TEST(fs::is_regular_file(kept.front()), "which the table replaces");
    fs::rename(kept.front(), "table");
    fs::create_directory(kept.front());
    is_again("a folder of its name");
    fs::remove(kept.front());
    fs::rename("table", kept.front());
    const Case softer({"Rail material/Young's modulus = 200 GPa"}, coarse);
    BOOST_TEST(files().size() == 3, "other constants have another table");

    // older ones than those in use
    const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(48);
    const auto make_old = [&](const std::string &name, const unsigned int minutes) {
      std::ofstream("tables/" + name) << "of a profile before";
      fs::last_write_time("tables/" + name, long_ago + std::chrono::minutes(minutes));
    };
    const auto own_name = [](const unsigned int k) {
      return "body-" + std::to_string(1000000000000000 + k) + (k % 2 == 0 ? "-0123abcd.h5" : ".h5");
    };
    for (unsigned int k = 0; k < most_kept_tables; ++k)
      make_old(own_name(k), k);
    const std::vector<std::string> foreign{
      "body-of-mine.h5", "body-0.h5", "body-1000000000000000-0123abcd.h5.bak"};
    for (const std::string &name : foreign)
      make_old(name, 0);
    const Case stiffer({"Rail material/Young's modulus = 220 GPa"}, coarse);
    BOOST_TEST((files().size() == most_kept_tables + foreign.size()), "no more tables are kept than so many");
    BOOST_TEST((!fs::exists("tables/" + own_name(0)) && !fs::exists("tables/" + own_name(3)) &&
                fs::exists("tables/" + own_name(4)) && fs::exists(kept.front()) && fs::exists(kept.back())),
               "those that were not used for the longest time go");
    for (const std::string &name : foreign)
      BOOST_TEST(fs::remove("tables/" + name), name + " is the user's and stays");
    for (unsigned int k = 0; k < most_kept_tables; ++k)
      fs::remove("tables/" + own_name(k));
  }

  /// Rows of a vehicle are solved on several threads at once: tables are read and transforms planned on each.
  void
  test_threads()
  {
    const Case               one({});
    const HalfspaceGrid      grid{40, 30, 0.4e-3, 0.4e-3, -8e-3, -6e-3};
    constexpr int            n_threads = 4, n_times = 25;
    std::vector<int>         read(n_threads, 0);
    std::vector<std::thread> threads;
    for (int t = 0; t < n_threads; ++t)
      threads.emplace_back([&, t] {
        for (int i = 0; i < n_times; ++i)
          {
            const RowsInfluence plans({grid.mx + i, grid.my, grid.dx, grid.dy, grid.x0, grid.y0},
                                      std::vector<RowsInfluence::Basis>(grid.my));
            const BodyTables    again = make_body_tables(one.scene, one.geometry, "tables");
            read[t] += again.rail.remainder == one.tables.rail.remainder &&
                       again.wheel.remainder == one.tables.wheel.remainder;
          }
      });
    for (std::thread &thread : threads)
      thread.join();
    for (const int times : read)
      BOOST_TEST((times == n_times),
                 "tables read by several threads at once, " + std::to_string(times) + " of " +
                   std::to_string(n_times));
  }

  void
  test_messages()
  {
    SectionBuilder     builder;
    const unsigned int corner[4] = {
      builder.corner({0, 0}), builder.corner({1, 0}), builder.corner({0, 1}), builder.corner({1, 1})};
    const Side bottom{corner[0], corner[1]}, top{corner[2], corner[3]};
    builder.patch("block", bottom, top, {corner[0], corner[2]}, {corner[1], corner[3]});
    builder.mark(top, Boundary::running);
    const SectionMesh loose = mesh_section(builder.section(), Boundary::foot, 0);
    BOOST_TEST(same_text(
      test::message_of([&] { WaveStiffness(loose, {}, false).compliance(0, surface_rows(loose, 1, false)); }),
      "The section of the rail moves without strain at the wavenumber 0.000000: nothing holds it. Its "
      "elasticity cannot be computed.",
      "a body that nothing holds"));
    SectionMesh folded = loose;
    std::swap(folded.nodes[folded.cells[0][0]], folded.nodes[folded.cells[0][2]]);
    std::swap(folded.nodes[folded.cells[0][6]], folded.nodes[folded.cells[0][8]]);
    const std::string found = test::message_of([&] { WaveStiffness(folded, {}, false); });
    BOOST_TEST((found.rfind("A cell of the section at ", 0) == 0 &&
                found.find(" is folded, so that its elasticity cannot be computed.") != std::string::npos),
               "a folded cell: " + found);
    builder.mark(bottom, Boundary::running);
    BOOST_TEST(same_text(
      test::message_of([&] { mesh_section(builder.section(), Boundary::foot, 0); }),
      "The running surface of a section is not one line of cells, so that its elasticity cannot be computed.",
      "two running surfaces"));
    BodyTable table;
    for (int r = 0; r < 3; ++r)
      table.rows.push_back({1e-3 * r, 0, 1e-3, 0, {}});
    BodyPlacement placement;
    placement.arcs = {0.1, 0.101};
    BOOST_TEST(
      same_text(test::message_of([&] { contact_rows(table, placement); }),
                "The contact lies beside the running surface of the rail that has a table of its elasticity.",
                "a contact beside the table"));
    const auto refused = [](const std::string &set) {
      const SceneInput input = scene_from_text("", "x.prm", {"Half-space/Bodies = real", set});
      return test::message_of([&] { require_none(contact_checks(input.scene).errors, input); });
    };
    const std::string other =
      "; Half-space/Bodies = real does not take it: write half-spaces there, or leave this "
      "entry out";
    BOOST_TEST(same_text(
      refused("Half-space/Lateral offset = 1 mm"),
      "--set: Half-space/Lateral offset = 1 mm: a position given by hand, where the bodies find their own" +
        other,
      "an offset with true bodies"));
    BOOST_TEST(same_text(refused("Half-space/Undeformed distance = hertz"),
                         "--set: Half-space/Undeformed distance = hertz: a distance without bodies" + other,
                         "a given distance with true bodies"));
    BOOST_TEST(same_text(refused("Half-space/Spin = contact"),
                         "--set: Half-space/Spin = contact: one spin for the whole contact" + other,
                         "one spin with true bodies"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(bodies_contact)
{
  std::filesystem::remove_all("tables");
  test_messages();
  test_kept();
  test_threads();
  test_scenes();
  test_curve();
  test_pose_of_run();
}
