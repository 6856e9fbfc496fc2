#include <wheelrail/application/checkpoint_files.h>
#include <wheelrail/application/input_file.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace wheelrail
{
  namespace
  {
    /// Counts up whenever a field of a checkpoint is added or changes its meaning.
    constexpr int format = 1;

    /// FNV-1a of 64 bits (Fowler, Noll and Vo), in hexadecimal digits.
    std::string
    checksum(const char *bytes, const std::size_t size)
    {
      unsigned long long hash = 14695981039346656037ull;
      for (std::size_t k = 0; k < size; ++k)
        hash = (hash ^ static_cast<unsigned char>(bytes[k])) * 1099511628211ull;
      char text[17];
      std::snprintf(text, sizeof text, "%016llx", hash);
      return text;
    }

    // --- the marker checkpoint_last: lines "name = value" ---

    using Marker = std::map<std::string, std::string>;

    std::string
    marker_path(const std::string &folder)
    {
      return folder + "/checkpoint_last";
    }

    Marker
    read_marker(const std::string &folder)
    {
      Marker             marker;
      std::istringstream text(read_whole_file(marker_path(folder)));
      for (std::string line; std::getline(text, line);)
        if (const auto sign = line.find(" = "); sign != std::string::npos)
          marker[line.substr(0, sign)] = line.substr(sign + 3);
      return marker;
    }

    std::string
    file_path(const std::string &folder, const std::string &files, const int rank)
    {
      return folder + "/" + files + "_rank" + std::to_string(rank) + ".h5";
    }

    // --- all ranks together ---

    void
    broadcast(std::string &text, const int root, MPI_Comm communicator)
    {
      unsigned long size = text.size();
      MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG, root, communicator);
      text.resize(size);
      MPI_Bcast(&text[0], static_cast<int>(size), MPI_CHAR, root, communicator);
    }

    /// Does the work on all ranks; the failure of the lowest one that failed is thrown on all.
    template <typename Error, typename Work>
    void
    together(MPI_Comm communicator, const Work &work)
    {
      std::string fault;
      int         rank, size;
      MPI_Comm_rank(communicator, &rank);
      MPI_Comm_size(communicator, &size);
      int failed = size;
      try
        {
          work();
        }
      catch (const std::exception &error)
        {
          fault  = error.what();
          failed = rank;
        }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, communicator);
      if (failed == size)
        return;
      broadcast(fault, failed, communicator);
      throw Error(fault);
    }

    // --- what must agree before a run goes on ---

    [[noreturn]] void
    refuse(const std::string &folder, const std::string &what)
    {
      throw InputError("--resume, Output/Folder = " + folder + ": " + what);
    }

    void
    check_marker(const std::string &folder, Marker &marker, const int size)
    {
      if (marker["format"] != std::to_string(format))
        refuse(folder,
               "the state was saved in format \"" + marker["format"] +
                 "\", this version of the program reads format " + std::to_string(format) +
                 "; start anew without --resume");
      if (marker["ranks"] != std::to_string(size))
        refuse(folder,
               "the state was saved by " + marker["ranks"] +
                 " ranks and goes on with the same number only, not with " + std::to_string(size) +
                 "; give --ranks " + marker["ranks"]);
    }

    std::map<std::string, std::string>
    entries_of(const std::string &parameters)
    {
      std::map<std::string, std::string> values;
      for (const Assignment &a : parse_input(parameters, "").assignments)
        values[a.section.empty() ? a.name : a.section + "/" + a.name] = a.value;
      return values;
    }

    void
    check_parameters(const std::string &folder, const std::string &saved, const std::string &now)
    {
      const std::set<std::string> may_differ = {
        "Title", "Output/Folder", "Output/Volume fields", "Run/Energy limit", "Run/Averaging distance"};
      auto        before = entries_of(saved), after = entries_of(now);
      std::string differences;
      for (const auto &table : {before, after})
        for (const auto &[path, value] : table)
          if (before[path] != after[path] && may_differ.count(path) == 0)
            {
              differences += (differences.empty() ? "" : "; ") + path + " = " + after[path] +
                             ", saved with " + before[path];
              before[path] = after[path]; // reported once
            }
      if (!differences.empty())
        refuse(folder, "entries differ from those of the saved state, which must not change: " + differences);
    }

    Checkpoint
    read_own_file(const std::string &folder, const Marker &marker, const int rank)
    {
      const auto entry = [&](const std::string &name) { return marker.count(name) ? marker.at(name) : ""; };
      const std::string path = file_path(folder, entry("files"), rank);
      try
        {
          const std::string bytes = read_whole_file(path);
          if (checksum(bytes.data(), bytes.size()) != entry("checksum of rank " + std::to_string(rank)))
            throw RunError("its checksum is not the one in checkpoint_last");
          return checkpoint_from_bytes(bytes);
        }
      catch (const std::exception &error)
        {
          refuse(folder, path + " is damaged or missing (" + error.what() + "); start anew without --resume");
        }
    }
  } // namespace


  double
  write_checkpoint(const Checkpoint &checkpoint, const std::string &folder, MPI_Comm communicator)
  {
    int rank, size;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &size);
    std::string files = "checkpoint_0";
    on_root(communicator, [&]() {
      if (std::filesystem::exists(marker_path(folder)) && read_marker(folder)["files"] == files)
        files = "checkpoint_1";
    });
    broadcast(files, 0, communicator);

    double      bytes_written = 0;
    std::string sum(16, '0');
    together<RunError>(communicator, [&]() {
      const std::vector<char> bytes = checkpoint_bytes(checkpoint);
      replace_file(file_path(folder, files, rank), bytes.data(), bytes.size());
      sum           = checksum(bytes.data(), bytes.size());
      bytes_written = bytes.size();
    });
    std::string sums(16 * size, '0');
    MPI_Gather(sum.data(), 16, MPI_CHAR, &sums[0], 16, MPI_CHAR, 0, communicator);
    MPI_Allreduce(MPI_IN_PLACE, &bytes_written, 1, MPI_DOUBLE, MPI_SUM, communicator);

    std::ostringstream marker;
    marker << "# The saved state of a run that has not finished: \"run ... --resume\" goes on from it.\n"
           << "format = " << format << "\nfiles = " << files
           << "\nrolled distance = " << 1e3 * checkpoint.axle.travelled
           << " mm\nsteps = " << checkpoint.rolling.steps << "\nranks = " << size << '\n';
    for (int r = 0; r < size; ++r)
      marker << "checksum of rank " << r << " = " << sums.substr(16 * r, 16) << '\n';
    on_root(communicator, [&]() { replace_file(marker_path(folder), marker.str()); });
    return bytes_written;
  }


  Checkpoint
  read_checkpoint(const std::string &folder, const std::string &parameters, MPI_Comm communicator)
  {
    int rank, size;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &size);
    on_root(communicator, [&]() {
      if (holds_finished_run(folder))
        refuse(folder, "the run in this folder has finished; there is nothing to go on with");
      if (!std::filesystem::exists(marker_path(folder)))
        refuse(folder, "there is no saved state to go on from; start without --resume");
    });
    Checkpoint checkpoint;
    together<InputError>(communicator, [&]() {
      Marker marker = read_marker(folder);
      check_marker(folder, marker, size);
      checkpoint = read_own_file(folder, marker, rank);
      check_parameters(folder, checkpoint.parameters, parameters);
    });
    return checkpoint;
  }


  void
  remove_checkpoints(const std::string &folder)
  {
    std::error_code                    ignored; // a file that stays does no harm: the run is finished
    std::vector<std::filesystem::path> files = {marker_path(folder)};
    for (const auto &entry : std::filesystem::directory_iterator(folder, ignored))
      if (const std::string name = entry.path().filename().string();
          name.rfind("checkpoint_0_rank", 0) == 0 || name.rfind("checkpoint_1_rank", 0) == 0)
        files.push_back(entry.path());
    for (const auto &file : files)
      std::filesystem::remove(file, ignored);
  }
} // namespace wheelrail
