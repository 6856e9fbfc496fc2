#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/folder_lock.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>
#include <wheelrail/output/summary.h>

#include <system_error>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    namespace fs = std::filesystem;

    /// What runs and half-spaces leave.
    constexpr char common_files[] =
      "summary.json, figures.json, halfspace.h5, slices.h5, wear.csv, "
      "intervals.csv, sections.json, report.html, ";

    /// Whether the program makes files of this name.
    bool
    is_own_file(const fs::path &path)
    {
      const fs::path    whole = path.extension() == ".part" ? path.stem() : path.filename();
      const std::string name = whole.string(), ending = whole.extension().string();
      for (const std::string &own : split_list(
             std::string(common_files) +
             "log.txt, history.h5, patch_history.h5, patch.h5, halfspace_slices.h5, compare.json, "
             "compare.html, residual.h5, rail.h5, passages.csv, passages.h5, input.prm, parameters.prm"))
        if (name == own)
          return true;
      return ending == ".vtu" || ending == ".pvd" || name.rfind("checkpoint", 0) == 0 ||
             name.rfind("halfspace_patch_", 0) == 0;
    }

    /// Pictures of results; not those of tables that another call wrote beside them.
    void
    add_pictures(const fs::path &folder, std::vector<fs::path> &own)
    {
      if (fs::is_directory(folder / "pictures"))
        for (const auto &entry : fs::directory_iterator(folder / "pictures"))
          if (const fs::path &path = entry.path(); path.extension() == ".png" &&
                                                   path.filename() != "creep_curve.png" &&
                                                   path.filename() != "places.png")
            own.push_back(path);
    }

    void
    remove_earlier_run(const fs::path &folder)
    {
      std::vector<fs::path> own;
      for (const auto &entry : fs::directory_iterator(folder))
        if (is_own_file(entry.path()))
          own.push_back(entry.path());
      if (fs::is_directory(folder / "profiles"))
        for (const auto &entry : fs::directory_iterator(folder / "profiles"))
          if (const std::string name = entry.path().filename().string();
              name.rfind("wheel_", 0) == 0 || name.rfind("rail_", 0) == 0 || name.rfind("motion_", 0) == 0)
            own.push_back(entry.path());
      add_pictures(folder, own);
      for (const fs::path &path : own)
        fs::remove_all(path);
      for (const auto &entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().rfind("passage_", 0) == 0 &&
            fs::exists(entry.path() / "parameters.prm"))
          remove_earlier_run(entry.path());
    }

    /// What a run that was killed had not finished writing.
    void
    remove_unfinished_files(const fs::path &folder)
    {
      std::vector<fs::path> parts;
      for (const auto &entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".part" && is_own_file(entry.path()))
          parts.push_back(entry.path());
      for (const fs::path &path : parts)
        fs::remove(path);
    }

    /// Removes `folder` and those above it up to `topmost`, as far as they are empty; with an empty `topmost`
    /// nothing. Another run may have made the same folder at the same moment and work in it.
    void
    remove_made(const std::string &folder, const fs::path &topmost)
    {
      std::error_code error;
      for (fs::path path = fs::absolute(folder).lexically_normal(); !topmost.empty();
           path          = path.parent_path())
        {
                   fs::remove(path, error);
                   if (error || path == topmost || path == path.root_path())
            return;
        }
    }

    /// The topmost folder on the path that is missing, or an empty path. Throws InputError where a file lies
    /// on it.
    fs::path
    topmost_missing(const std::string &folder)
    {
      fs::path        topmost;
      std::error_code error;
      for (fs::path path = fs::absolute(folder).lexically_normal(); !path.empty(); path = path.parent_path())
        {
          const fs::file_status status = fs::status(path, error);
          if (fs::exists(status) && !fs::is_directory(status))
            refuse_folder(
              folder, "\"" + path.string() + "\" is a file, where a folder is needed. Choose another name.");
          if (fs::exists(status) || path == path.root_path())
            break;
          if (path.has_filename())
            topmost = path;
        }
      return topmost;
    }

    /// Makes the folder and those above it that are missing; gives the topmost one made, or an empty path.
    fs::path
    make_folders(const std::string &folder)
    {
      fs::path        topmost = topmost_missing(folder);
      std::error_code error;
      fs::create_directories(folder, error);
      if (error)
        {
          // nothing half made may stay behind
          remove_made(folder, topmost);
          refuse_folder(folder,
                        "the folder cannot be made: " + error.message() +
                          ". Choose a place in which you may write.");
        }
      return topmost;
    }

    /// A folder without parameters.prm is none of ours, so an input.prm in it is the user's own work.
    void
    protect_foreign_input(const std::string &folder, const std::string &input)
    {
      const std::string path = folder + "/input.prm";
      if (fs::exists(path) && !fs::exists(folder + "/parameters.prm") && read_whole_file(path) != input)
        refuse_folder(
          folder,
          "the folder holds another input.prm, which the copy of this input would replace. Choose "
          "another Output/Folder, or rename that file.");
    }
  } // namespace

  bool
  holds_finished_run(const std::string &folder)
  {
    const std::string path = folder + "/summary.json";
    std::error_code   error;
    if (!fs::is_regular_file(path, error))
      return false;
    try
      {
        return read_summary(path).finished;
      }
    catch (const RunError &)
      {
        return false; // not a summary: no run of ours reached its end here
      }
  }


  OutputFolder::OutputFolder(std::string      folder,
                             const FolderMode mode,
                             std::string      input,
                             MPI_Comm         communicator)
    : folder_(std::move(folder))
    , input_(std::move(input))
    , communicator_(communicator)
  {
    on_root(communicator_, [&]() {
      if (folder_.empty())
        throw InputError("Output/Folder is empty; give the name of a folder, such as output/rolling.");
      made_ = make_folders(folder_);
      try
        {
          lock_ = std::make_unique<FolderLock>(folder_);
          if (mode == FolderMode::fresh && holds_finished_run(folder_))
            refuse_folder(folder_,
                          "the folder holds a finished run, which is kept. Choose another Output/Folder, or "
                          "give --overwrite to replace it.");
          if (mode != FolderMode::resume)
            protect_foreign_input(folder_, input_);
        }
      catch (...)
        {
          lock_.reset();
          remove_made(folder_, made_);
          throw;
        }
    });
  }


  OutputFolder::~OutputFolder()
  {
    lock_.reset();
    remove_made(folder_, made_);
  }


  void
  OutputFolder::begin(const std::string &parameters, const bool keep)
  {
    on_root(communicator_, [&]() {
      if (!keep && fs::exists(folder_ + "/parameters.prm"))
        remove_earlier_run(folder_);
      remove_unfinished_files(folder_);
      const std::string parameters_file = folder_ + "/parameters.prm";
      try
        {
          // first the file by which the folder is known as the program's own, should it end between the two
          replace_file(parameters_file, parameters);
          if (!keep || !fs::exists(folder_ + "/input.prm"))
            replace_file(folder_ + "/input.prm", input_);
        }
      catch (...)
        {
          std::error_code ignored;
          if (!made_.empty())
            fs::remove(parameters_file, ignored);
          throw;
        }
      made_.clear();
    });
  }


  void
  require_possible_folder(const std::string &folder)
  {
    topmost_missing(folder);
  }


  std::filesystem::path
  folder_beside(const std::string &folder, const std::string &tail)
  {
    std::filesystem::path path = folder;
    if (!path.has_filename())
      path = path.parent_path();
    return path += tail;
  }


  ResultFolder::ResultFolder(const std::string &folder, const std::string &tail)
    : path_(folder_beside(folder, tail))
    , made_(make_folders(path_.string()))
  {
    try
      {
        lock_ = std::make_unique<FolderLock>(path_.string());
      }
    catch (...)
      {
        remove_made(path_.string(), made_);
        throw;
      }
  }


  ResultFolder::~ResultFolder()
  {
    lock_.reset();
    remove_made(path_.string(), made_);
  }


  void
  remove_earlier_results(const std::filesystem::path &folder)
  {
    const auto names = split_list(std::string(common_files) + "wheelset.csv, wheelset.html, parameters.prm");
    std::error_code ignored; // what cannot be removed shows when it is written anew
    for (const fs::path &part : {folder / "left", folder / "right", folder})
      if (fs::exists(part / "parameters.prm"))
        {
          std::vector<fs::path> own;
          for (const std::string &name : names)
            own.push_back(part / name);
          for (const auto &entry : fs::directory_iterator(part))
            if (entry.path().filename().string().rfind("halfspace_patch_", 0) == 0)
              own.push_back(entry.path());
          add_pictures(part, own);
          if (part != folder) // what is empty then goes, too
            own.insert(own.end(), {part / "pictures", part});
          for (const fs::path &path : own)
            fs::remove(path, ignored);
        }
  }
} // namespace wheelrail
