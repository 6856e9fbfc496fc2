#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/model/profile_copies.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>
#include <wheelrail/state/checkpoint_checks.h>
#include <wheelrail/state/checkpoint_files.h>

#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <utility>

namespace wheelrail
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    constexpr const char *file_names[2] = {"checkpoint_0.h5", "checkpoint_1.h5"};

    /// FNV-1a of 64 bits (Fowler, Noll and Vo), in hexadecimal digits.
    std::string
    checksum(const char *bytes, const std::size_t size)
    {
      unsigned long long hash = 14695981039346656037ull;
      for (std::size_t k = 0; k < size; ++k)
        hash = (hash ^ static_cast<unsigned char>(bytes[k])) * 1099511628211ull;
      return text("%016llx", hash);
    }

    std::string
    marker_path(const std::string &folder)
    {
      return folder + "/checkpoint.json";
    }

    /// The marker as written, or null when it is missing or no JSON object.
    Json
    read_marker(const std::string &folder)
    {
      if (!std::filesystem::exists(marker_path(folder)))
        return nullptr;
      Json marker = Json::parse(read_whole_file(marker_path(folder)), nullptr, false);
      return marker.is_object() ? marker : Json(nullptr);
    }

    /// The saved states that the marker lists, the newest first.
    std::vector<Json>
    listed_states(const Json &marker)
    {
      std::vector<Json> states;
      if (marker.is_object() && marker.contains("states") && marker["states"].is_array())
        for (const Json &state : marker["states"])
          if (state.is_object() && state.value("file", Json()).is_string() &&
              state.value("checksum", Json()).is_string())
            states.push_back(state);
      return states;
    }

    [[noreturn]] void
    refuse(const std::string &folder, const std::string &what)
    {
      throw InputError("--resume, Output/Folder = " + folder + ": " + what);
    }

    /// The bytes of a state; throws RunError when they are not those that were written.
    std::string
    read_state(const std::string &folder, const Json &state)
    {
      const std::string bytes = read_whole_file(folder + "/" + state["file"].get<std::string>());
      if (checksum(bytes.data(), bytes.size()) != state["checksum"].get<std::string>())
        throw RunError("its checksum is not the one in checkpoint.json");
      return bytes;
    }

    /// What write_stop() wrote; nothing when the run was interrupted, killed, or has gone on since.
    Stop
    stop_in(const Json &marker)
    {
      const Json json = marker.is_object() ? marker.value("stopped", Json()) : Json();
      Stop       stop;
      if (json.is_object())
        {
          stop.reason          = json.value("because", "");
          stop.rolled_distance = 1e-3 * json.value("rolled_distance_mm", 0.);
          stop.cure            = json.value("cure", "");
          stop.energy_error    = json.value("energy_error", 0.);
        }
      return stop;
    }

    /// When the run in the folder has saved nothing, it can only start anew, if that can help.
    void
    require_killed(const std::string &folder)
    {
      const std::string path = folder + "/summary.json";
      if (!std::filesystem::exists(path))
        return;
      const Json summary = Json::parse(read_whole_file(path), nullptr, false);
      const Json reason  = summary.is_object() ? summary.value("stopped_because", Json()) : Json();
      if (reason.is_string() && !reason.get<std::string>().empty())
        refuse(folder,
               "the run in this folder stopped before it had saved a state, since " +
                 reason.get<std::string>() + "; start anew without --resume");
    }

    /// The newest state that is whole; empty when the run was ended before it had saved one.
    std::string
    read_newest(const std::string &folder, const Json &marker, std::string &notes)
    {
      if (holds_finished_run(folder))
        refuse(folder, "the run in this folder has finished; there is nothing to go on with");
      if (!std::filesystem::exists(marker_path(folder)))
        {
          if (std::filesystem::exists(folder + "/parameters.prm"))
            {
              require_killed(folder);
              return "";
            }
          refuse(folder, "there is no run to go on with; start without --resume");
        }
      const Json found = marker.is_object() ? marker.value("format", Json("none")) : Json("none");
      if (found != checkpoint_format)
        refuse(folder,
               "checkpoint.json is of format " + found.dump() +
                 ", this version of the program reads format " + std::to_string(checkpoint_format) +
                 "; start anew without --resume");
      std::string faults;
      for (const Json &state : listed_states(marker))
        try
          {
            const std::string bytes = read_state(folder, state);
            if (!faults.empty())
              notes += faults + "; the run goes on from the state before it, " +
                       state["file"].get<std::string>() + "\n";
            return bytes;
          }
        catch (const RunError &error)
          {
            faults += (faults.empty() ? "" : "; ") + state["file"].get<std::string>() +
                      " is damaged or missing (" + error.what() + ")";
          }
      refuse(folder,
             (faults.empty() ? "checkpoint.json lists no saved state" : faults) +
               "; start anew without --resume");
    }

    std::string
    mm(const double length)
    {
      return text("%.3f", 1e3 * length);
    }
  } // namespace


  double
  write_checkpoint(const Checkpoint &part, const std::string &folder, MPI_Comm communicator)
  {
    const Checkpoint whole = gather_checkpoint(part, communicator);
    double           size  = 0;
    on_root(communicator, [&]() {
      const auto        before = listed_states(read_marker(folder));
      const bool        second = !before.empty() && before.front()["file"] == file_names[0];
      const std::string name   = file_names[second ? 1 : 0];
      const auto        bytes  = checkpoint_bytes(whole);
      size                     = bytes.size();
      replace_file(folder + "/" + name, bytes.data(), bytes.size());

      Json state;
      state["file"]               = name;
      state["rolled_distance_mm"] = std::stod(mm(whole.travelled()));
      state["time_s"]             = whole.rolling.time;
      state["time_steps"]         = whole.rolling.steps;
      state["ranks"]              = whole.ranks;
      state["program_version"]    = WHEELRAIL_VERSION;
      state["bytes"]              = bytes.size();
      state["checksum"]           = checksum(bytes.data(), bytes.size());
      Json marker;
      marker["about"] =
        "Saved states of a run that has not finished, the newest first; \"run FILE --resume\" "
        "goes on from the first that is whole.";
      marker["format"] = checkpoint_format;
      marker["states"] = Json::array({state});
      if (!before.empty())
        marker["states"].push_back(before.front());
      replace_file(marker_path(folder), marker.dump(2) + "\n");
    });
    MPI_Bcast(&size, 1, MPI_DOUBLE, 0, communicator);
    return size;
  }


  void
  write_stop(const Stop &stop, const std::string &folder)
  {
    Json marker = read_marker(folder);
    if (!marker.is_object())
      return;
    Json json;
    json["because"]            = stop.reason;
    json["rolled_distance_mm"] = 1e3 * stop.rolled_distance;
    json["cure"]               = stop.cure;
    json["energy_error"]       = stop.energy_error;
    marker["stopped"]          = json;
    replace_file(marker_path(folder), marker.dump(2) + "\n");
  }


  void
  protect_saved_states(const std::string &folder)
  {
    const Json marker = read_marker(folder);
    const auto states = listed_states(marker);
    if (states.empty())
      return;
    const Json rolled = states.front().value("rolled_distance_mm", Json());
    const Stop stop   = stop_in(marker);
    throw InputError(
      "Output/Folder = " + folder + ": the folder holds a run that has not finished, saved at " +
      (rolled.is_number() ? mm(1e-3 * rolled.get<double>()) : "?") + " mm rolled" +
      (stop.cure.empty() ? ". Give --resume to go on with it, --overwrite to start anew"
                         : " (it stopped since " + stop.reason + "). Give --overwrite to start anew") +
      ", or choose another Output/Folder.");
  }


  std::optional<ResumePoint>
  read_checkpoint(const Scene &scene, const std::string &parameters, MPI_Comm communicator)
  {
    std::string bytes, notes;
    Checkpoint  whole;
    int         size;
    MPI_Comm_size(communicator, &size);
    on_root(communicator, [&]() {
      const Json marker = read_marker(scene.folder);
      bytes             = read_newest(scene.folder, marker, notes);
      if (bytes.empty())
        return;
      whole = checkpoint_from_bytes(bytes);
      if (const auto obstacle = changed_since_start(scene, scene.folder); !obstacle.empty())
        refuse(scene.folder, obstacle);
      if (const auto obstacle = obstacle_to_resume(whole, scene, parameters); !obstacle.empty())
        refuse(scene.folder, obstacle);
      if (const auto obstacle = obstacle_of_stop(stop_in(marker), whole.travelled(), scene);
          !obstacle.empty())
        refuse(scene.folder, obstacle);
      if (whole.ranks != size)
        notes += "the state was saved by " + std::to_string(whole.ranks) +
                 (whole.ranks == 1 ? " rank" : " ranks") + " and goes on with " + std::to_string(size) +
                 ": results agree up to the growth of round-off\n";
    });
    if (!dealii::Utilities::MPI::broadcast(communicator, !bytes.empty()))
      return {};
    notes = dealii::Utilities::MPI::broadcast(communicator, notes);
    ResumePoint point{share_checkpoint(std::move(whole), communicator), {}};
    for (std::size_t begin = 0, end; begin < notes.size(); begin = end + 1)
      {
        end = notes.find('\n', begin);
        point.notes.push_back(notes.substr(begin, end - begin));
      }
    return point;
  }


  void
  remove_checkpoints(const std::string &folder)
  {
    std::error_code ignored; // a file that stays does no harm: the run is finished
    std::filesystem::remove(marker_path(folder), ignored);
    for (const char *name : file_names)
      std::filesystem::remove(folder + "/" + name, ignored);
  }
} // namespace wheelrail
