// needs: vehicle

// Calls of halfspace of different kinds into one folder: nothing of one kind stays for `report` to draw
// beside the other, while tables of creep curves and the user's own files do.

#include "near.h"

#include <wheelrail/application/command_line.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace wheelrail;

namespace
{
  namespace fs = std::filesystem;

  void
  halfspace(const std::vector<std::string> &more)
  {
    std::vector<std::string> words{"halfspace", "scene.prm", "--no-pictures"};
    words.insert(words.end(), more.begin(), more.end());
    std::ostringstream out;
    execute(
      words, [](const Scene &, const SceneGeometry &, const RunOptions &) { return 0; }, out);
  }
} // namespace


BOOST_AUTO_TEST_CASE(halfspace_folder)
{
  fs::remove_all("one-halfspace");
  std::ofstream("scene.prm") << "subsection Half-space\n  set Element size = 1.5 mm\nend\n"
                                "subsection Output\n  set Folder = one\nend\n";
  const fs::path                 folder = "one-halfspace";
  const std::vector<std::string> both{"--set", "Wheelset/Wheels = both"};
  halfspace(both);
  BOOST_TEST((fs::exists(folder / "wheelset.csv") && fs::exists(folder / "left" / "halfspace.h5")),
             "both wheels");
  std::ofstream(folder / "left" / "notes.txt") << "mine\n";
  halfspace({"--creep-curve", "longitudinal 0, 0.1 %"});
  halfspace({});
  BOOST_TEST((!fs::exists(folder / "wheelset.csv") && !fs::exists(folder / "right") &&
              !fs::exists(folder / "left" / "halfspace.h5")),
             "nothing of both wheels beside one wheel");
  BOOST_TEST((fs::exists(folder / "halfspace.h5") && fs::exists(folder / "sections.json") &&
              fs::exists(folder / "creep_curve.csv") && fs::exists(folder / "left" / "notes.txt")),
             "the wheel, the creep curve and the user's notes are there");
  halfspace(both);
  BOOST_TEST((!fs::exists(folder / "halfspace.h5") && !fs::exists(folder / "wear.csv") &&
              fs::exists(folder / "wheelset.csv") && fs::exists(folder / "right" / "wear.csv")),
             "nothing of one wheel beside both");
}
