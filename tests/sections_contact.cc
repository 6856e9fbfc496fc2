// Half-spaces on rails whose section changes along the track against CONTACT, on an artificial nose and wing
// and on a crossing.
#include "manchester.h"
#include "reference_table.h"
#include "sliced_surface.h"

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/sections/section_contacts.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;
using test::surface_of;

namespace
{
  using Rows = std::vector<std::vector<std::string>>;

  void
  write_crossing()
  {
    std::vector<std::pair<std::string, std::vector<Point2>>> slices;
    for (const auto &row : test::read_table("crossing_sections.csv"))
      {
        if (slices.empty() || slices.back().first != row[0])
          slices.push_back({row[0], {}});
        slices.back().second.push_back({std::stod(row[1]), std::stod(row[2])});
      }
    std::ofstream out("crossing.slcs");
    out << "0 1 U_OFFSET U_SCALE\n" << slices.size() << " NSLC\n0 0 0 NFEAT NKINK NACCEL\n1 U_INTPOL\n";
    for (const auto &[place, points] : slices)
      {
        test::write_points("crossing_" + place + ".txt", points);
        out << place << " 'crossing_" << place << ".txt'\n";
      }
  }

  /// Of the runs of CONTACT.
  SectionRolling
  rolling_of_contact(const double dy)
  {
    SectionRolling rolling;
    rolling.problem.body1 = rolling.problem.body2 = {82e9, 0.28};
    rolling.problem.friction                      = FrictionLaw{0.3};
    rolling.problem.velocity                      = 2;
    rolling.dx                                    = 0.2e-3;
    rolling.dy                                    = dy;
    rolling.section_normal                        = true;
    rolling.turning                               = 4.3481181;
    return rolling;
  }

  WheelProfile
  wheel_of_contact()
  {
    Scene scene            = test::manchester_scene();
    scene.wheel_file.noise = 0;
    scene.wheel_origin     = WheelOrigin::running_circle;
    return read_wheel_profile(scene).wheel;
  }

  PosedWheel
  posed_at(const WheelProfile &wheel, const double y_mm)
  {
    WheelsetPose pose;
    pose.lateral_shift = -1e-3 * y_mm;
    return {wheel, TrackDimensions(), pose};
  }

  // columns of contact_crossing.csv
  enum Column
  {
    example,
    number,
    part,
    y_ws,
    z_ws,
    first_touch,
    FX,
    FY,
    FZ,
    x_track,
    y_rail,
    contact_angle,
    FN,
    Fx,
    Fs,
    CKSI,
    CETA,
    CPHI,
    patch_approach,
    pmax
  };

  /// The patches of a wheel beside those of CONTACT, nearest first to the field side.
  void
  compare_patches(SectionContacts contacts, const Rows &rows, const double load, const std::string &at)
  {
    std::sort(contacts.patches.begin(),
              contacts.patches.end(),
              [](const SectionPatch &a, const SectionPatch &b) { return a.reference[0] < b.reference[0]; });
    BOOST_TEST(near(
      -1e3 * contacts.height, std::stod(rows[0][z_ws]), at[0] == 'c' ? 0.5e-3 : 0.2e-3, at + "height [mm]"));
    const Vector3 force = contacts.force();
    BOOST_TEST(near(force[2], std::stod(rows[0][FX]), 0.002 * load, at + "force along [N]"));
    BOOST_TEST(near(-force[0], std::stod(rows[0][FY]), 0.002 * load, at + "lateral force [N]"));
    BOOST_REQUIRE_MESSAGE(contacts.patches.size() + 1 == rows.size(), at + "number of patches");
    for (std::size_t k = 1; k < rows.size(); ++k)
      {
        const SectionPatch &p     = contacts.patches[k - 1];
        const auto         &row   = rows[k];
        const std::string   patch = at + row[part] + ": ";
        BOOST_TEST(near(p.normal_force(), std::stod(row[FN]), 0.003 * load, patch + "normal force [N]"));
        BOOST_TEST(near(1e3 * p.reference[2], std::stod(row[x_track]), 0.03, patch + "ahead [mm]"));
        BOOST_TEST(near(-1e3 * p.reference[0], std::stod(row[y_rail]), 0.03, patch + "lateral place [mm]"));
        BOOST_TEST(near(-p.angle, std::stod(row[contact_angle]), 3e-3, patch + "contact angle"));
        BOOST_TEST(near_relative(p.solution.xi, std::stod(row[CKSI]), 2e-3, patch + "creepage"));
        BOOST_TEST(near_relative(-1e-3 * p.solution.phi, std::stod(row[CPHI]), 0.01, patch + "spin"));
        if (p.normal_force() > 500)
          BOOST_TEST(near_relative(
            1e-6 * p.solution.peak_pressure, std::stod(row[pmax]), 0.01, patch + "peak pressure"));
      }
  }

  BOOST_AUTO_TEST_CASE(contact_rows)
  {
    const WheelProfile          wheel = wheel_of_contact();
    std::map<std::string, Rows> cases;
    for (const auto &row : test::read_table("contact_crossing.csv"))
      cases[row[example] + " " + row[number]].push_back(row);
    test::write_part("nose");
    test::write_part("wing");
    write_crossing();
    const std::map<std::string, std::vector<SectionsSurface>> rails = {
      {"cross_brute", {surface_of("nose.slcs")}},
      {"wing_brute", {surface_of("wing.slcs")}},
      {"mbench_brute", {surface_of("crossing.slcs")}}};
    for (const auto &[name, rows] : cases)
      {
        const std::string    file      = rows[0][example];
        const bool           crossing  = file == "mbench_brute";
        const SectionRolling rolling   = rolling_of_contact(crossing ? 0.2e-3 : 0.05e-3);
        const PosedWheel     posed     = posed_at(wheel, std::stod(rows[0][y_ws]));
        const double         place     = crossing               ? 239e-3
                                         : file == "wing_brute" ? 100e-3
                                                                : 0,
                     load              = std::stod(rows[0][FZ]);
        const SectionContacts contacts = contacts_under_load(rails.at(file), posed, rolling, place, load);
        const std::string     at       = (crossing ? "crossing, shift " + rows[0][y_ws] : file) + ": ";
        BOOST_TEST(contacts.found, at + "load found");
        BOOST_TEST(near(-contacts.force()[1], load, 1e-4 * load, at + "vertical force [N]"));
        compare_patches(contacts, rows, load, at);
        if (crossing)
          BOOST_TEST(near(-1e3 * contacts.touching.front().height,
                          std::stod(rows[0][first_touch]),
                          0.5e-3,
                          at + "height of the first touch [mm]"));
      }
    // nose and wing carry the same at a shift of 0.975 mm
    const auto difference = [&](const double shift) {
      const SectionRolling  rolling = rolling_of_contact(0.2e-3);
      const PosedWheel      posed   = posed_at(wheel, shift);
      const SectionContacts contacts =
        contacts_under_load(rails.at("mbench_brute"), posed, rolling, 239e-3, 1e4);
      double sum = 0;
      for (const SectionPatch &p : contacts.patches)
        sum += std::copysign(p.normal_force(), p.reference[0]);
      return sum;
    };
    const double a = difference(0.973), b = difference(0.977);
    BOOST_TEST(near(0.973 + 0.004 * a / (a - b), 0.975, 0.002, "shift of equal loads [mm]"));
  }

  /// The slope along the track belongs to the normal: without friction the force along the track is that of
  /// the slope.
  BOOST_AUTO_TEST_CASE(slope_along)
  {
    SectionRolling rolling   = rolling_of_contact(0.1e-3);
    rolling.problem.friction = FrictionLaw{0};
    rolling.section_normal   = false;
    const std::vector<SectionsSurface> rails{surface_of("nose.slcs")};
    const PosedWheel                   wheel = posed_at(wheel_of_contact(), 0);
    const SectionContacts              nose  = contacts_under_load(rails, wheel, rolling, 0, 1e4);
    const Vector3                      force = nose.force();
    BOOST_TEST(near(-force[1], 1e4, 1, "vertical force on a nose of 1:10 [N]"));
    BOOST_TEST(near(force[2] / -force[1], 0.1, 1e-3, "force on the rail along the track, of the slope 1:10"));
  }
} // namespace
