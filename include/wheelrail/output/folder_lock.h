#pragma once

#include <string>

namespace wheelrail
{
  /// Throws InputError, which names `folder` as the entry of the scene and says what is wrong with it.
  [[noreturn]] void
  refuse_folder(const std::string &folder, const std::string &what);

  /// Holds a folder for this process, from the constructor to the destructor: the kernel's lock (flock) on
  /// the file run.lock in it, which names the holder (process, machine). The kernel lets go of it when the
  /// process ends, however it does, so that the file that a killed run leaves behind is taken over.
  class FolderLock
  {
  public:
    /// Throws InputError when another run holds `folder`, with process and machine; when the file was left by
    /// another machine (whose locks a shared disk may not show); when no file can be made there.
    explicit FolderLock(const std::string &folder);

    /// Lets go and removes the file.
    ~FolderLock();

    FolderLock(const FolderLock &) = delete;
    FolderLock &
    operator=(const FolderLock &) = delete;

  private:
    std::string path_;
    int         file_ = -1;
  };
} // namespace wheelrail
