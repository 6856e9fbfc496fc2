#include <wheelrail/base/errors.h>
#include <wheelrail/output/replace_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace wheelrail
{
  namespace
  {
    std::string
    advice(const int reason)
    {
      switch (reason)
        {
          case ENOSPC:
          case EDQUOT:
          case EFBIG:
            return "Free some space there, or choose another Output/Folder.";
          case EACCES:
          case EPERM:
          case EROFS:
            return "Choose an Output/Folder in which you may write.";
          default:
            return "Check that the folder still exists and may be written to.";
        }
    }

    [[noreturn]] void
    fail(const std::string &path, const int reason)
    {
      throw RunError(cannot_write(path, reason));
    }

    /// Zero, or the error number of the first write that failed.
    int
    write_all(const int file, const char *bytes, std::size_t size)
    {
      while (size > 0)
        {
          const ssize_t written = ::write(file, bytes, size);
          if (written < 0 && errno == EINTR)
            continue;
          if (written <= 0)
            return written < 0 ? errno : ENOSPC;
          bytes += written;
          size -= static_cast<std::size_t>(written);
        }
      return 0;
    }
    /// Brings the new name to the disk, so that files of a later call never get there before this one. The
    /// file is complete in any case, so a file system that cannot do it is no fault.
    void
    sync_folder_of(const std::string &path)
    {
      const auto        slash  = path.rfind('/');
      const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
      const int         id     = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (id < 0)
        return;
      ::fsync(id);
      ::close(id);
    }
  } // namespace

  std::string
  cannot_write(const std::string &path, const int reason)
  {
    return "The output file \"" + path + "\" cannot be written: " + std::strerror(reason) + ". " +
           advice(reason);
  }

  void
  replace_file(const std::string &path, const void *bytes, const std::size_t size)
  {
    const std::string part = path + ".part";
    const int         file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0)
      fail(path, errno);

    int reason = write_all(file, static_cast<const char *>(bytes), size);
    // some file systems report a full disk only here
    if (reason == 0 && ::fsync(file) != 0 && errno != EINVAL && errno != ENOTSUP)
      reason = errno;
    if (::close(file) != 0 && reason == 0)
      reason = errno;
    if (reason == 0 && std::rename(part.c_str(), path.c_str()) != 0)
      reason = errno;
    if (reason != 0)
      {
        ::unlink(part.c_str());
        fail(path, reason);
      }
    sync_folder_of(path);
  }

  void
  append_to_file(const std::string &path, const std::string &text)
  {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file < 0)
      fail(path, errno);
    int reason = write_all(file, text.data(), text.size());
    if (::close(file) != 0 && reason == 0)
      reason = errno;
    if (reason != 0)
      fail(path, reason);
  }

  void
  replace_file(const std::string &path, const std::string &text)
  {
    replace_file(path, text.data(), text.size());
  }
} // namespace wheelrail
