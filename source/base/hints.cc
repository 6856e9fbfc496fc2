#include <wheelrail/base/hints.h>

#include <cstdlib>

namespace wheelrail
{
  namespace
  {
    std::string
    told(const char *variable, const char *otherwise)
    {
      const char *const text = std::getenv(variable);
      return text != nullptr && *text != '\0' ? text : otherwise;
    }
  } // namespace

  std::string
  own_call()
  {
    return told("WHEELRAIL_COMMAND", "./wheelrail");
  }

  std::string
  ready_scene(const std::string &name)
  {
    return told("WHEELRAIL_SCENES", "prm") + "/" + name;
  }

  std::string
  shell_word(const std::string &word)
  {
    const char *const plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
      return word;
    std::string quoted = "'";
    for (const char c : word)
      quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
  }
} // namespace wheelrail
