#include <wheelrail/base/errors.h>
#include <wheelrail/base/hints.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/commands/report_script.h>

#include <chrono>
#include <csignal>
#include <thread>

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
    // a group of its own, which this process ends as a whole: Ctrl-C does not reach it by itself
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    pid_t     child = 0;
    const int fault = posix_spawn(&child, debian_python, nullptr, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    if (fault != 0)
      throw RunError(
        "/usr/bin/python3 cannot be started; install the Debian packages python3, python3-h5py and "
        "python3-matplotlib");
    int   status = 0;
    pid_t ended  = 0;
    while ((ended = waitpid(child, &status, WNOHANG)) == 0 && !interrupt_requested())
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (ended == 0)
      {
        ::kill(-child, SIGTERM);
        waitpid(child, &status, 0);
        throw Interrupted("pages that were finished are kept: the same command makes the others");
      }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
  }

  void
  draw_results(const std::string &script, const std::string &folder)
  {
    int code = 0;
    try
      {
        code = run_script(script, {folder});
      }
    catch (const Interrupted &)
      {
        throw Interrupted("the results in " + folder + " are whole, their pictures are not: \"" + own_call() +
                          " report " + folder + "\" draws them");
      }
    if (code != 0)
      throw RunError("The results in " + folder + " are whole, but " + script +
                     " could not draw them; mend what it says above, or leave pictures out (--no-pictures).");
  }
} // namespace wheelrail
