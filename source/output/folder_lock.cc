#include <wheelrail/base/errors.h>
#include <wheelrail/output/folder_lock.h>
#include <wheelrail/output/replace_file.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace wheelrail
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /// Who holds a folder. The boot number tells one start of one kernel from all others; processes in
    /// containers share it, whatever name their machine bears.
    struct Holder
    {
      std::string host, boot;
      long        process = 0;
    };

    Holder
    this_process()
    {
      char name[256] = "";
      ::gethostname(name, sizeof name - 1);
      std::string   boot;
      std::ifstream number("/proc/sys/kernel/random/boot_id");
      std::getline(number, boot);
      return {name, boot, long(::getpid())};
    }

    /// What stands in the file; no process when it is empty or none of ours.
    Holder
    read_holder(const int file)
    {
      char          bytes[2048];
      const ssize_t size = ::pread(file, bytes, sizeof bytes, 0);
      const Json    json = Json::parse(bytes, bytes + std::max<ssize_t>(size, 0), nullptr, false);
      Holder        holder;
      if (json.is_object() && json.value("host", Json()).is_string() &&
          json.value("boot", Json()).is_string() && json.value("process", Json()).is_number_integer())
        holder = {
          json["host"].get<std::string>(), json["boot"].get<std::string>(), json["process"].get<long>()};
      return holder;
    }

    /// Zero, or the error number.
    int
    write_holder(const int file, const Holder &holder)
    {
      Json json;
      json["about"]   = "The run that works in this folder; the file is removed at its end.";
      json["host"]    = holder.host;
      json["process"] = holder.process;
      json["boot"]    = holder.boot;
      const std::string text =
        json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; // a name may be no UTF-8
      if (::ftruncate(file, 0) != 0)
        return errno;
      const ssize_t written = ::pwrite(file, text.data(), text.size(), 0);
      return written == ssize_t(text.size()) ? 0 : written < 0 ? errno : ENOSPC;
    }

    std::string
    name_of(const Holder &holder)
    {
      return holder.process == 0 ? "another process"
                                 : "process " + std::to_string(holder.process) + " on " + holder.host;
    }

    [[noreturn]] void
    refuse_held(const std::string &folder, const Holder &holder)
    {
      refuse_folder(folder,
                    "another run works in this folder, " + name_of(holder) +
                      ". Wait for its end, or choose another Output/Folder.");
    }

    /// Whether the open file is still the one of that name: its holder may have removed it meanwhile.
    bool
    has_name(const int file, const std::string &path)
    {
      struct stat open_one, named;
      return ::fstat(file, &open_one) == 0 && ::stat(path.c_str(), &named) == 0 &&
             open_one.st_dev == named.st_dev && open_one.st_ino == named.st_ino;
    }

    /// Throws InputError unless the holder that the file names is gone. `locks`: whether the file system
    /// knows locks; where it does not, the process is asked for.
    void
    require_gone(const Holder      &holder,
                 const Holder      &self,
                 const bool         locks,
                 const std::string &folder,
                 const std::string &path)
    {
      if (holder.process == 0)
        return;
      if (holder.boot == self.boot)
        {
          if (!locks && holder.process != self.process && ::kill(pid_t(holder.process), 0) == 0)
            refuse_held(folder, holder);
        }
      else if (holder.host != self.host) // else the machine was started anew since
        refuse_folder(folder,
                      "a run on another machine works in this folder, " + name_of(holder) +
                        ", or was ended there "
                        "without a word. Choose another Output/Folder, or, when it is gone, remove \"" +
                        path + "\".");
    }

    /// Opens the file and locks it; gives the open file.
    int
    take(const std::string &folder, const std::string &path)
    {
      for (;;)
        {
          const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
          if (file < 0)
            refuse_folder(folder, "no files can be made there. " + cannot_write(path, errno));
          const int fault = ::flock(file, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
          if (fault != EWOULDBLOCK && !has_name(file, path))
            {
              ::close(file);
              continue;
            }
          const Holder self = this_process(), holder = read_holder(file);
          try
            {
              if (fault == EWOULDBLOCK)
                refuse_held(folder, holder);
              require_gone(holder, self, fault == 0, folder, path);
              if (const int reason = write_holder(file, self); reason != 0)
                {
                  ::unlink(path.c_str());
                  refuse_folder(folder, "no files can be made there. " + cannot_write(path, reason));
                }
            }
          catch (...)
            {
              ::close(file);
              throw;
            }
          return file;
        }
    }
  } // namespace

  void
  refuse_folder(const std::string &folder, const std::string &what)
  {
    throw InputError("Output/Folder = " + folder + ": " + what);
  }


  FolderLock::FolderLock(const std::string &folder)
    : path_(folder + "/run.lock")
    , file_(take(folder, path_))
  {
  }


  FolderLock::~FolderLock()
  {
    // removed while it is still held: whoever has opened it meanwhile finds its name gone and tries again
    ::unlink(path_.c_str());
    ::close(file_);
  }
} // namespace wheelrail
