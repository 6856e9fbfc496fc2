#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace test
{
  /// A motion file for the time of a check.
  class File
  {
  public:
    explicit File(const std::string &text)
      : path_((std::filesystem::temp_directory_path() /
               ("motion_" + std::to_string(getpid()) + "_" + std::to_string(number++) + ".csv"))
                .string())
    {
      std::ofstream(path_) << text;
    }
    ~File()
    {
      std::filesystem::remove(path_);
    }
    const std::string &
    path() const
    {
      return path_;
    }

  private:
    static inline int number = 0;
    std::string       path_;
  };
} // namespace test
