#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/kept_tables.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/output/replace_file.h>

#include <boost/crc.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    namespace fs = std::filesystem;

    /// Files are read and written by one thread at a time: HDF5 is not made for several, and rows of a
    /// vehicle are solved at once. The first one makes a table, the others wait and read it.
    std::mutex keeping;

    // to be raised when what a table holds changes
    constexpr double table_version = 2;

    /// All numbers that a table follows from.
    std::vector<double>
    contents(const SectionMesh &mesh,
             const Elasticity  &elasticity,
             const bool         wheel,
             const double       nominal_radius,
             const unsigned int cells)
    {
      std::vector<double> all{table_version,
                              elasticity.youngs_modulus,
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
      return all;
    }


    std::string
    name_of(const std::vector<double> &contents)
    {
      // two sums with different generators: 64 bits
      boost::crc_32_type                                                     first;
      boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true> second;
      first.process_bytes(contents.data(), contents.size() * sizeof(double));
      second.process_bytes(contents.data(), contents.size() * sizeof(double));
      char name[64];
      std::snprintf(
        name, sizeof(name), "body-%08x%08x.h5", unsigned(first.checksum()), unsigned(second.checksum()));
      return name;
    }


    void
    write_table(const BodyTable &table, const std::string &path)
    {
      using namespace hdf5;
      const Handle        file(open_in_memory(), H5Fclose, "make a file in memory");
      std::vector<double> rows, remainder;
      for (const BodyTable::Row &row : table.rows)
        rows.insert(rows.end(), {row.arc, row.angle, row.width, row.radius, row.growth.x, row.growth.y});
      for (const std::vector<double> &one : table.remainder)
        remainder.insert(remainder.end(), one.begin(), one.end());
      const hsize_t m = table.rows.size(), n = 3 * m;
      write_attribute(file, "shear_modulus_Pa", table.shear_modulus);
      write_attribute(file, "poissons_ratio", table.poissons_ratio);
      write_attribute(file, "wheel", double(table.wheel));
      write_attribute(file, "harmonics", double(table.harmonics));
      write_dataset(file, "rows", {m, 6}, rows, "m", "arc, angle (rad), width, radius, growth x, y (m s2)");
      write_dataset(file, "waves", {table.waves.size()}, table.waves, "1/m or 1");
      write_dataset(file, "remainder", {table.waves.size(), n, n}, remainder, "1/Pa");
      const std::vector<char> bytes = file_image(file);
      // a name of its own, renamed when it is whole
      const std::string own = path + "." + std::to_string(getpid());
      replace_file(own, bytes.data(), bytes.size());
      fs::rename(own, path);
    }


    /// None where there is no such file, or no whole table in it.
    std::optional<BodyTable>
    read_table(const std::string &path)
    {
      using namespace hdf5;
      const Quiet       quiet;
      std::ifstream     stream(path, std::ios::binary);
      const std::string image{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
      if (image.empty())
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
        if (const std::string name = entry.path().filename().string();
            name.rfind("body-", 0) == 0 && entry.path().extension() == ".h5")
          files.emplace_back(entry.last_write_time(), entry.path());
      std::sort(files.begin(), files.end());
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
    const std::lock_guard<std::mutex> guard(keeping);
    const std::string path = folder + "/" + name_of(contents(mesh, elasticity, wheel, nominal_radius, cells));
    if (std::optional<BodyTable> kept = read_table(path))
      {
        std::error_code ignored; // of a folder that belongs to somebody else
        fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
        return *std::move(kept);
      }
    BodyTable table = make();
    try
      {
        fs::create_directories(folder);
        write_table(table, path);
        forget_oldest(folder);
      }
    catch (const std::exception &)
      {
        // a full or foreign disk costs the time of making the table again, nothing else
      }
    return table;
  }
} // namespace wheelrail
