#include <wheelrail/application/report_script.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/shared_files.h>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace wheelrail
{
  int
  run_script(const std::string &script, const std::vector<std::string> &arguments)
  {
    std::vector<std::string> words = {debian_python, shared_file("report/" + script)};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char *> pointers;
    for (std::string &word : words)
      pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t child  = 0;
    int   status = 0;
    if (posix_spawn(&child, debian_python, nullptr, nullptr, pointers.data(), environ) != 0 ||
        waitpid(child, &status, 0) != child)
      throw RunError(
        "/usr/bin/python3 cannot be started; install the Debian packages python3, python3-h5py and "
        "python3-matplotlib");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
  }

  void
  draw_results(const std::string &script, const std::string &folder)
  {
    if (run_script(script, {folder}) != 0)
      throw RunError("The results in " + folder + " are whole, but " + script +
                     " could not draw them; mend what it says above, or leave pictures out (--no-pictures).");
  }
} // namespace wheelrail
