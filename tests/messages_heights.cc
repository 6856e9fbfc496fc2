// label: fast

// What the program answers to files of heights and of slices that cannot be an irregularity, and which forms
// of tables it reads.
#include "messages.h"

#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/profiles/height_grid.h>
#include <wheelrail/sections/slices_file.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <sys/stat.h>

using namespace wheelrail;

namespace
{
  void
  says(const std::function<void()> &work, const std::string &part)
  {
    const std::string message = test::message_of(work);
    BOOST_TEST((message.find(part) != std::string::npos),
               "\"" + part + "\" in \"" + message.substr(0, 300) + "\"");
  }

  void
  write(const char *name, const std::string &text)
  {
    std::ofstream(name) << text;
  }

  void
  write_datasets(const char                 *name,
                 const std::vector<double>  &along,
                 const std::vector<double>  &height,
                 const std::vector<hsize_t> &shape = {})
  {
    const hid_t               file   = H5Fcreate(name, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const std::vector<double> across = {-6, -2, 2, 6};
    hdf5::write_dataset(file, "along_mm", {along.size()}, along, "mm");
    hdf5::write_dataset(file, "across_mm", {across.size()}, across, "mm");
    hdf5::write_dataset(
      file, "height_um", shape.empty() ? std::vector<hsize_t>{height.size()} : shape, height, "um");
    H5Fclose(file);
  }

  BOOST_AUTO_TEST_CASE(test_heights)
  {
    const auto read = [](const char *name) { return [name] { read_height_file(name); }; };
    write("empty.csv", "");
    says(read("empty.csv"), "empty.csv: no rows");
    write("short.csv", "along_mm,height_um\n0,0\n1,0\n2,0\n");
    says(read("short.csv"), "3 places along; a line or a grid needs at least 4");
    write("row.csv", "along_mm,across_mm,height_um\n0,0,0\n1,0,0\n2,0,0\n3,0,0\n");
    says(read("row.csv"), "1 place across; a grid needs at least 4, a line has no column across");
    write("twice.csv", "along_mm,height_um\n0,0\n1,1\n1,2\n3,0\n4,0\n");
    says(read("twice.csv"), "twice.csv:4: the same place as in line 3; one row for each place is needed");
    std::string grid = "along_mm,across_mm,height_um\n";
    for (int k = 0; k < 15; ++k)
      grid += std::to_string(k % 4) + "," + std::to_string(k / 4) + ",0\n";
    write("hole.csv", grid);
    says(read("hole.csv"),
         "no row for along = 3 mm, across = 3 mm (1 of 16 are missing); fill the holes of the grid");
    write("name.csv", "x,height_um\n0,0\n");
    says(read("name.csv"),
         "name.csv:1: no column along; heights are rows under names such as along_mm, across_mm (not of a "
         "line), "
         "height_um");
    write("word.csv", "along_mm,height_um\n0,0\n1,nan\n");
    says(read("word.csv"), "word.csv:3: \"nan\" of height is not a number; units belong in the first line");
    says(read("gone.csv"), "gone.csv");
    write("high.csv", "along_mm,height_um\n0,0\n1,2e6\n2,0\n3,0\n");
    says(read("high.csv"), "high.csv:3: height = 2e6 is out of range; -5 mm to 5 mm is accepted");
    write("short_row.csv", "along_mm,height_mm\n0,0\n1,0,1229\n2,0\n3,0\n");
    says(read("short_row.csv"), "short_row.csv:3: a row of 3 values, the first line names 2 columns");
    write("wide.csv", "\xFF\xFE" + std::string(1, '\0'));
    says(read("wide.csv"), "wide.csv: no text in UTF-8, as a spreadsheet saves \"CSV\"; heights are rows");
    const auto same = [](const std::string &text) {
      std::ofstream("same.csv") << text;
      const HeightGrid line = read_height_file("same.csv");
      BOOST_TEST((line.along.size() == 4 && std::abs(line.height[1] + 0.1229e-3) < 1e-15), text);
    };
    for (const char *const head : {"along_mm;height_mm",
                                   "along [mm];height (mm)",
                                   "Along (mm); Height / mm",
                                   "along;height\nmm;mm",
                                   "\"along_mm\";\"height_mm\""})
      for (const char *const rows : {"\n0;0\n1;-0,1229\n2;0\n3;0\n",
                                     "\r\n0;0;\r\n1;-0.1229;\r\n2;0;\r\n3;0;",
                                     "\n0\t0\n1\t-0,1229\n2\t0\n3\t0\n",
                                     "\n0 0\n1 -0,1229\n2 0\n3 0\n",
                                     "\n0,0\n1,\"-0,1229\"\n2,0\n3,0\n",
                                     "\n0,0\n1,-1.229e-1\n2,0\n3,0\n"})
        same(head + std::string(rows));
    same(
      "\xEF\xBB\xBF"
      "along [mm];height [\xB5m]\r\n0;0\r\n1;-122,9\r\n2;0\r\n3;0\r\n");
    const std::vector<double> along = {0, 10, 20, 30};
    write("sep.csv", "sep=;\r\nalong_mm;height_um\r\n0;0,0\r\n1;-0,5\r\n2;-0,5\r\n3;0\r\n");
    BOOST_TEST((read_height_file("sep.csv").height[1] == -0.5e-6), "a spreadsheet's word for its separator");
    write("thousands.csv", "along_mm;height_um\n0;0\n1;-950\n2;-1,012\n3;0\n");
    says(read("thousands.csv"),
         "thousands.csv:4: \"2;-1,012\" has commas between digits that may be decimal");
    write_datasets("good.h5", along, std::vector<double>(16, 0.));
    const HeightGrid square = read_height_file("good.h5");
    BOOST_TEST(square.height.size() == 16, "a grid in an HDF5 file");
    BOOST_TEST((square.notes ==
                std::vector<std::string>{
                  "good.h5: each 4 heights of height_um are taken as those along at one place across"}),
               "how a grid is taken whose rows and columns are as many");
    write_datasets("few.h5", along, std::vector<double>(15, 0.));
    says(read("few.h5"), "15 heights for 4 x 4 places; a row for each place across is needed");
    write_datasets("back.h5", {0, 20, 10, 30}, std::vector<double>(16, 0.));
    says(read("back.h5"), "back.h5: the places along or across do not ascend");
    std::vector<double> high(16, 0.);
    high[5] = 2e6;
    write_datasets("high.h5", along, high);
    says(read("high.h5"), "high.h5: a height of 2000 mm; -5 mm to 5 mm is accepted");
    write_datasets("nan.h5", along, std::vector<double>(16, std::nan("")));
    says(read("nan.h5"), "nan.h5: a height that is no number; fill the holes of the grid");
    write_datasets("place.h5", {0, 10, std::nan(""), 30}, std::vector<double>(16, 0.));
    says(read("place.h5"), "place.h5: a place at nan mm; -1e+09 mm to 1e+09 mm is accepted there");
    write_datasets("rows.h5", {0, 10, 20, 30, 40}, std::vector<double>(20, 0.), {4, 5});
    const HeightGrid rows = read_height_file("rows.h5");
    BOOST_TEST((rows.height.size() == 20 && rows.notes.empty()), "a row for each place across");
    write_datasets("turned.h5", {0, 10, 20, 30, 40}, std::vector<double>(20, 0.), {5, 4});
    says(read("turned.h5"),
         "turned.h5: height_um has 5 rows of 4 heights for 4 places across and 5 along; a row for each "
         "place across is needed: exchange rows and columns");
    mkfifo("pipe.h5", 0600);
    says(read("pipe.h5"), "\"pipe.h5\" is no ordinary file, but a pipe");
    H5Fclose(H5Fcreate("none.h5", H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    says(read("none.h5"),
         "none.h5: no dataset along_mm (or _m, _um); along_mm, across_mm and height_um are needed");
    write("text.h5", "no such file");
    says(read("text.h5"), "text.h5: it is no HDF5 file, or not complete");
  }

  BOOST_AUTO_TEST_CASE(test_slices)
  {
    Scene      scene;
    const auto made = [&scene](const char *file, const IrregularBody body = IrregularBody::automatic) {
      return [&scene, file, body] {
        scene.irregularities[2].kind = IrregularKind::file;
        scene.irregularities[2].file = file;
        scene.irregularities[2].body = body;
        make_geometry(scene);
      };
    };
    write("step.csv", "along_mm,height_um\n0,0\n1,10\n2,10\n3,10\n");
    says(made("step.csv"),
         "Irregularity 3/File: step.csv: the heights begin or end with a step of 0.01 mm; they must come "
         "down to 0 along, within 0.002 mm");
    write("flat.txt", "-30 0\n-25 0\n-20 0\n-10 0\n0 0\n10 0\n20 0\n25 0\n30 0\n");
    write("deep.txt", "-30 9\n-25 9\n-20 9\n-10 9\n0 9\n10 9\n20 9\n25 9\n30 9\n");
    write("beside.txt", "50 0\n51 0\n52 0\n53 0\n54 0\n55 0\n58 0\n60 0\n62 0\n");
    write("wide.txt", "-9000 0\n-25 0\n-20 0\n-10 0\n0 0\n10 0\n20 0\n25 0\n9000 0\n");
    write("points.txt", "-30 0\n0 0\n30 0\n");
    const auto slices = [](const std::string &file, const std::string &head = "4\n0 0 0\n1\n") {
      std::string text = "0 1 offset, scale\n" + head;
      for (int k = 0; k < 4; ++k)
        text += std::to_string(10 * k) + " '" + file + "'\n";
      return text;
    };
    write("a.slcs", slices("flat.txt", "4\n2 0 0\n1\n") + "0 0 9\n10 0 9\n20 0 9\n30 0 9\n");
    says(made("a.slcs"),
         "slices with features (a rail in parts) are no irregularity; give them as Profiles/Rail");
    write("b.slcs", slices("flat.txt", "3\n0 0 0\n1\n"));
    says(made("b.slcs"), "NSLC = 3; 4 to 10000 slices are accepted");
    write("c.slcs", slices("flat.txt", "4\n0 0 0\n3\n"));
    says(made("c.slcs"), "U_INTPOL = 3; 1 (interpolation) or 2 (smoothing) are accepted");
    write("d.slcs", slices("gone.txt"));
    says(made("d.slcs"), "d.slcs:5: ");
    write("e.slcs", "0 1\n4\n0 0 0\n1\n0 'flat.txt'\n-5 'flat.txt'\n");
    says(made("e.slcs"), "e.slcs:6: the places of the slices do not ascend; order them along the track");
    write("f.slcs", "0 1\n4\n0 0 0\n1\n0 'flat.txt'\n");
    says(made("f.slcs"), "f.slcs: ends before slice 2 of 4");
    write("i.slcs", "0 1\n4\n0 0 0\n1\n0,5 'flat.txt'\n");
    says([] { read_slices_file("i.slcs", ProfileUnit::automatic); },
         "i.slcs:5: \"0,5 'flat.txt'\": a comma between digits; write decimal points, and blanks between "
         "numbers");
    write("g.slcs", "0 1\n4\n0 0 0\n1\n0 flat.txt\n");
    says(made("g.slcs"), ": a place and the name of a file in quotes are expected");
    write("h.slcs", "0\n4\n0 0 0\n1\n");
    says(made("h.slcs"), "U_OFFSET U_SCALE is expected");
    write("i.slcs", slices("deep.txt"));
    says(made("i.slcs"), "; slices have y to the field side and z down, and the origin of the profile");
    write("j.slcs", slices("beside.txt"));
    says(made("j.slcs"), "; their lateral origins must be the same, y to the field side");
    write("k.slcs", slices("wide.txt"));
    says(made("k.slcs"), " units wide; as mm or m it is none (10 mm to 400 mm): set the unit of the profile");
    write("l.slcs", slices("points.txt"));
    says(made("l.slcs"), "points.txt: 3 points; a slice needs at least 8");
    write("m.slcw", slices("flat.txt"));
    says(made("m.slcw", IrregularBody::rail), "m.slcw: slices of a wheel on the rail; change Body");
  }
} // namespace
