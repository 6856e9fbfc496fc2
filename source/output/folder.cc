#include <wheelrail/base/errors.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>
#include <wheelrail/output/summary.h>

#include <filesystem>
#include <system_error>
#include <vector>

namespace wheelrail
{
  namespace
  {
    namespace fs = std::filesystem;

    [[noreturn]] void
    refuse(const std::string &folder, const std::string &what)
    {
      throw InputError("Output/Folder = " + folder + ": " + what);
    }

    /// Whether the program makes files of this name.
    bool
    is_own_file(const fs::path &path)
    {
      const fs::path    whole = path.extension() == ".part" ? path.stem() : path.filename();
      const std::string name = whole.string(), ending = whole.extension().string();
      for (const char *own : {"summary.json",
                              "figures.json",
                              "log.txt",
                              "history.h5",
                              "patch_history.h5",
                              "patch.h5",
                              "halfspace.h5",
                              "compare.json",
                              "compare.html",
                              "slices.h5",
                              "report.html",
                              "input.prm",
                              "parameters.prm"})
        if (name == own)
          return true;
      return ending == ".vtu" || ending == ".pvd" || name.rfind("checkpoint", 0) == 0;
    }

    void
    remove_earlier_run(const fs::path &folder)
    {
      std::vector<fs::path> own;
      for (const auto &entry : fs::directory_iterator(folder))
        if (is_own_file(entry.path()))
          own.push_back(entry.path());
      if (fs::is_directory(folder / "pictures"))
        for (const auto &entry : fs::directory_iterator(folder / "pictures"))
          if (entry.path().extension() == ".png")
            own.push_back(entry.path());
      for (const fs::path &path : own)
        fs::remove_all(path);
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

    /// Makes the folder and those above it that are missing; gives the topmost one made, or an empty path.
    fs::path
    make_folders(const std::string &folder)
    {
      fs::path        topmost;
      std::error_code error;
      for (fs::path path = fs::absolute(folder).lexically_normal(); !path.empty(); path = path.parent_path())
        {
          const fs::file_status status = fs::status(path, error);
          if (fs::exists(status) && !fs::is_directory(status))
            refuse(folder,
                   "\"" + path.string() + "\" is a file, where a folder is needed. Choose another name.");
          if (fs::exists(status) || path == path.root_path())
            break;
          if (path.has_filename())
            topmost = path;
        }
      fs::create_directories(folder, error);
      if (error)
        {
          // nothing half made may stay behind
          std::error_code ignored;
          if (!topmost.empty())
            fs::remove_all(topmost, ignored);
          refuse(folder,
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
        refuse(folder,
               "the folder holds another input.prm, which the copy of this input would replace. Choose "
               "another Output/Folder, or rename that file.");
    }

    /// Finds out whether files can be made in the folder before anything in it is removed.
    void
    try_to_write(const std::string &folder)
    {
      const std::string path = folder + "/.wheelrail-write-test";
      try
        {
          replace_file(path, std::string("test\n"));
          fs::remove(path);
        }
      catch (const std::exception &error)
        {
          refuse(folder, "no files can be made there. " + std::string(error.what()));
        }
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

  void
  prepare_folder(const std::string &folder,
                 const FolderMode   mode,
                 const std::string &input,
                 const std::string &parameters,
                 MPI_Comm           comm)
  {
    on_root(comm, [&]() {
      if (folder.empty())
        throw InputError("Output/Folder is empty; give the name of a folder, such as output/rolling.");
      if (mode == FolderMode::fresh && holds_finished_run(folder))
        refuse(folder,
               "the folder holds a finished run, which is kept. Choose another Output/Folder, or "
               "give --overwrite to replace it.");
      if (mode != FolderMode::resume)
        protect_foreign_input(folder, input);

      const fs::path made = make_folders(folder);
      try
        {
          try_to_write(folder);
          if (mode != FolderMode::resume && fs::exists(folder + "/parameters.prm"))
            remove_earlier_run(folder);
          remove_unfinished_files(folder);
          // first the file by which the folder is known as the program's own, should it end between the two
          replace_file(folder + "/parameters.prm", parameters);
          if (mode != FolderMode::resume || !fs::exists(folder + "/input.prm"))
            replace_file(folder + "/input.prm", input);
        }
      catch (...)
        {
          std::error_code ignored;
          if (!made.empty())
            fs::remove_all(made, ignored);
          throw;
        }
    });
  }
} // namespace wheelrail
