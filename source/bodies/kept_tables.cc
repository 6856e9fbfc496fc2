#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/bodies/kept_tables.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/output/replace_file.h>

#include <boost/crc.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <optional>
#include <regex>
#include <system_error>
#include <utility>
#include <vector>

// Tables of the true bodies as files, named by what they follow from, with a checksum (doc/theory/bodies.md,
// Remainder). Independent of load, friction, speed and place of contact.

namespace wheelrail
{
  namespace
  {
    namespace fs = std::filesystem;

    /// Files are read and written by one thread at a time: HDF5 is not made for several, and rows of a
    /// vehicle are solved at once. The first one makes a table, the others wait and read it.
    std::mutex keeping;

    /// Of what a table follows from, and of its bytes: any that changed on the disk shows.
    using Checksum = boost::
      crc_optimal<64, 0x42F0E1EBA9EA3693, 0xFFFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF, true, true>; // ECMA-182
    constexpr std::size_t digits = 16;

    std::string
    hexadecimal(const Checksum &sum)
    {
      return text("%016llx", static_cast<unsigned long long>(sum.checksum()));
    }

    /// All numbers that a table follows from.
    Checksum
    contents(const SectionMesh &mesh,
             const Curve       &profile,
             const Elasticity  &elasticity,
             const bool         wheel,
             const double       nominal_radius,
             const unsigned int cells)
    {
      // whatever changes a bit of these is another table
      std::vector<double> all{elasticity.youngs_modulus,
                              elasticity.poissons_ratio,
                              elasticity.density,
                              double(wheel),
                              nominal_radius,
                              double(cells)};
      for (const Point2 &node : mesh.nodes)
        all.insert(all.end(), {node.x, node.y});
      for (const auto &cell : mesh.cells)
        all.insert(all.end(), cell.begin(), cell.end());
      all.insert(all.end(), mesh.held.begin(), mesh.held.end());
      for (const auto &edge : mesh.running)
        all.insert(all.end(), edge.node.begin(), edge.node.end());
      // arcs of the rows depend on the profile, which the nodes lie on but do not name
      for (const SurfaceRow &row : rows_on_profile(mesh, profile, wheel, nominal_radius, cells))
        all.push_back(profile.length(0, profile.closest(profile_place(row.place, wheel, nominal_radius))));
      Checksum sum;
      sum.process_bytes(all.data(), all.size() * sizeof(double));
      return sum;
    }


    /// body-CONTENTS-BUILD.h5: other code may make another table of the same section.
    std::string
    name_of(const Checksum &contents)
    {
      return "body-" + hexadecimal(contents) + "-" + WHEELRAIL_TABLE_BUILD + ".h5";
    }

    /// Whether the program gave a file this name, also one that was not finished (.NUMBER, .part) or, without
    /// the build, in earlier versions.
    bool
    is_own_name(const std::string &name)
    {
      // only such files are ever removed
      static const std::regex own("body-[0-9a-f]{16}(-[0-9a-f]{8})?\\.h5(\\.[0-9]+(\\.part)?)?");
      return std::regex_match(name, own);
    }


    void
    write_table(const BodyTable &table, Checksum sum, const std::string &path)
    {
      using namespace hdf5;
      // in memory first: what is on the disk is whole, or not there
      const Handle file(open_in_memory(), H5Fclose, "make a file in memory");
      // rows: arc, angle, width, radius, growth x and y; numbers are written as they are, to the bit
      std::vector<double> rows, remainder;
      for (const BodyTable::Row &row : table.rows)
        rows.insert(rows.end(), {row.arc, row.angle, row.width, row.radius, row.growth.x, row.growth.y});
      for (const std::vector<double> &one : table.remainder)
        remainder.insert(remainder.end(), one.begin(), one.end());
      // remainder in 1/Pa: displacement under a force for each metre [m/(N/m)]
      const hsize_t m = table.rows.size(), n = 3 * m;
      write_attribute(file, "shear_modulus_Pa", table.shear_modulus);
      write_attribute(file, "poissons_ratio", table.poissons_ratio);
      write_attribute(file, "wheel", double(table.wheel));
      write_attribute(file, "harmonics", double(table.harmonics));
      write_dataset(file, "rows", {m, 6}, rows, "m", "arc, angle (rad), width, radius, growth x, y (m s2)");
      write_dataset(file, "waves", {table.waves.size()}, table.waves, "1/m or 1");
      write_dataset(file, "remainder", {table.waves.size(), n, n}, remainder, "1/Pa");
      // the checksum covers the inputs and the file: an old file under the right name is found out
      std::vector<char> bytes = file_image(file);
      sum.process_bytes(bytes.data(), bytes.size());
      const std::string check = hexadecimal(sum);
      bytes.insert(bytes.end(), check.begin(), check.end()); // behind what HDF5 reads
      // a name of its own, renamed when it is whole
      const std::string own = path + "." + std::to_string(getpid());
      replace_file(own, bytes.data(), bytes.size());
      std::error_code fault;
      fs::rename(own, path, fault);
      if (fault)
        fs::remove(own);
    }


    /// None where there is no such file, or not the whole table that was asked for in it.
    std::optional<BodyTable>
    read_table(const std::string &path, Checksum sum)
    {
      using namespace hdf5;
      // 1. Whole file; 2. checksum of inputs and bytes; 3. its numbers have to fit each other
      if (std::error_code ignored; !fs::is_regular_file(path, ignored))
        return {};
      const Quiet   quiet;
      std::ifstream stream(path, std::ios::binary);
      std::string   image{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
      if (image.size() <= digits)
        return {};
      const std::string check = image.substr(image.size() - digits);
      image.resize(image.size() - digits);
      sum.process_bytes(image.data(), image.size());
      // cut short, changed on the disk, or of other inputs
      if (check != hexadecimal(sum))
        return {};
      try
        {
          const Handle file(open_in_memory(image), H5Fclose, "read " + path);
          BodyTable    table;
          table.shear_modulus  = read_number_attribute(file, "shear_modulus_Pa");
          table.poissons_ratio = read_number_attribute(file, "poissons_ratio");
          table.wheel          = read_number_attribute(file, "wheel") > 0;
          table.harmonics      = static_cast<unsigned int>(read_number_attribute(file, "harmonics"));
          table.waves          = read_dataset(file, "waves");
          const std::vector<double> rows      = read_dataset(file, "rows"),
                                    remainder = read_dataset(file, "remainder");
          for (std::size_t r = 0; r + 5 < rows.size(); r += 6)
            table.rows.push_back(
              {rows[r], rows[r + 1], rows[r + 2], rows[r + 3], {rows[r + 4], rows[r + 5]}});
          // numbers of D at one wave, (3 rows)^2
          const std::size_t one = 9 * table.rows.size() * table.rows.size();
          if (table.rows.empty() || remainder.size() != one * table.waves.size())
            return {};
          for (std::size_t w = 0; w < table.waves.size(); ++w)
            table.remainder.emplace_back(remainder.begin() + w * one, remainder.begin() + (w + 1) * one);
          return table;
        }
      catch (const RunError &)
        {
          return {};
        }
    }

    /// Removes the tables that were not used for the longest time, as worn profiles have many.
    void
    forget_oldest(const std::string &folder)
    {
      std::vector<std::pair<fs::file_time_type, fs::path>> files;
      for (const fs::directory_entry &entry : fs::directory_iterator(folder))
        if (is_own_name(entry.path().filename().string()) &&
            entry.symlink_status().type() == fs::file_type::regular)
          files.emplace_back(entry.last_write_time(), entry.path());
      // time of last use, set at each reading
      std::sort(files.begin(), files.end());
      // some 7 MB each
      for (std::size_t k = 0; k + most_kept_tables < files.size(); ++k)
        fs::remove(files[k].second);
    }
  } // namespace


  std::string
  kept_tables_folder()
  {
    const auto variable = [](const char *name) {
      const char *const value = std::getenv(name);
      return std::string(value ? value : "");
    };
    if (std::string own = variable("WHEELRAIL_CACHE"); !own.empty())
      return own;
    if (const std::string cache = variable("XDG_CACHE_HOME"); !cache.empty())
      return cache + "/wheelrail";
    if (const std::string home = variable("HOME"); !home.empty())
      return home + "/.cache/wheelrail";
    return "";
  }


  BodyTable
  kept_body_table(const std::string &folder,
                  const SectionMesh &mesh,
                  const Curve       &profile,
                  const Elasticity  &elasticity,
                  const bool         wheel,
                  const double       nominal_radius,
                  const unsigned int cells)
  {
    const auto make = [&]() {
      return make_body_table(mesh, profile, elasticity, wheel, nominal_radius, cells);
    };
    if (folder.empty())
      return make();
    // held while a table is made: a second thread that wants the same one waits and reads it
    const std::lock_guard<std::mutex> guard(keeping);
    const Checksum                    sum = contents(mesh, profile, elasticity, wheel, nominal_radius, cells);
    const std::string                 path = folder + "/" + name_of(sum);
    // its time of use is renewed: the oldest ones go first
    if (std::optional<BodyTable> kept = read_table(path, sum))
      {
        std::error_code ignored; // of a folder that belongs to somebody else
        fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
        return *std::move(kept);
      }
    BodyTable table = make();
    try
      {
        fs::create_directories(folder);
        write_table(table, sum, path);
        forget_oldest(folder);
      }
    catch (const std::exception &)
      {
        // a full or foreign disk costs the time of making the table again, nothing else
      }
    return table;
  }
} // namespace wheelrail
