// label: fast

// Every message of the program that a user can meet is the subject of a test, and so is every note on what
// was done to a profile. The messages are found in the source: the texts of InputError, RunError, and of the
// lists of problems, findings and notes.

#include "near.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>


namespace
{
  namespace fs = std::filesystem;

  struct Message
  {
    std::string              file;  ///< below source/
    std::vector<std::string> parts; ///< its literal texts, values between them left out
  };

  std::string
  whole_file(const fs::path &path)
  {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  /// The end of the string literal that begins at `begin`; its text is appended to `text`.
  std::size_t
  read_literal(const std::string &code, const std::size_t begin, std::string &text)
  {
    std::size_t i = begin + 1;
    for (; i < code.size() && code[i] != '"'; ++i)
      {
        if (code[i] == '\\')
          ++i;
        text += code[i] == 'n' && code[i - 1] == '\\' ? '\n' : code[i];
      }
    return i + 1;
  }

  /// The end of the character literal or of the rest of a comment at i, or i when there is none.
  std::size_t
  skip_other(const std::string &code, const std::size_t i)
  {
    if (code.compare(i, 2, "//") == 0)
      return std::min(code.find('\n', i), code.size());
    const bool after_letter = i > 0 && std::isalnum(static_cast<unsigned char>(code[i - 1]));
    if (code[i] == '\'' && !after_letter)
      {
        const std::size_t end = code.find('\'', i + (code[i + 1] == '\\' ? 3 : 2));
        return end == std::string::npos ? code.size() : end + 1;
      }
    return i;
  }

  /// The string literals of a code from `begin` to the parenthesis that closes the one there, or to the
  /// end of the code; literals that follow each other are one.
  std::vector<std::string>
  literals(const std::string &code, const std::size_t begin, const bool to_parenthesis)
  {
    std::vector<std::string> found;
    bool                     joins = false;
    int                      depth = 0;
    for (std::size_t i = begin; i < code.size();)
      {
        if (const std::size_t next = skip_other(code, i); next > i)
          {
            i = next;
            continue;
          }
        if (code[i] == '"')
          {
            if (!joins)
              found.emplace_back();
            i     = read_literal(code, i, found.back());
            joins = true;
            continue;
          }
        joins = joins && std::isspace(static_cast<unsigned char>(code[i]));
        depth += code[i] == '(' ? 1 : code[i] == ')' ? -1 : 0;
        if (to_parenthesis && depth == 0)
          break;
        ++i;
      }
    return found;
  }

  std::vector<fs::path>
  files_below(const fs::path &folder, const bool deep)
  {
    std::vector<fs::path> files;
    const auto            add = [&](const fs::directory_entry &entry) {
      const std::string ending = entry.path().extension().string();
      if (ending == ".cc" || ending == ".h")
        files.push_back(entry.path());
    };
    if (deep)
      for (const auto &entry : fs::recursive_directory_iterator(folder))
        add(entry);
    else
      for (const auto &entry : fs::directory_iterator(folder))
        add(entry);
    std::sort(files.begin(), files.end());
    return files;
  }

  std::vector<Message>
  messages_of_source()
  {
    const std::regex call(
      R"(\b(InputError|RunError|refuse|fail|(problems|found|errors|warnings|notes)\.push_back)\()");
    std::vector<Message> messages;
    const fs::path       source = WHEELRAIL_SOURCE_DIR "/source";
    for (const fs::path &path : files_below(source, true))
      {
        const std::string code = whole_file(path);
        for (std::sregex_iterator it(code.begin(), code.end(), call), end; it != end; ++it)
          {
            Message message{fs::relative(path, source).string(), {}};
            for (const std::string &text :
                 literals(code, static_cast<std::size_t>(it->position() + it->length()) - 1, true))
              if (text.size() > 7) // shorter ones are punctuation and names of things
                message.parts.push_back(text);
            if (!message.parts.empty())
              messages.push_back(message);
          }
      }
    return messages;
  }

  /// The text that tells a message from others: its longest literal.
  std::string
  key_of(const Message &message)
  {
    return *std::max_element(message.parts.begin(), message.parts.end(), [](const auto &a, const auto &b) {
      return a.size() < b.size();
    });
  }

  /// Faults of a caller or of the program, or of a file system, that no input can bring about: where
  /// they are, or what they say, and why they need no test.
  const std::map<std::string, std::string> internal = {
    {"contactcalls/", "arguments of a caller's program; tests/contact_calls.py has sentences of them"},
    {"halfspace/", "arguments of the half-space solver, which the program makes itself"},
    {"output/hdf5", "sizes of fields, or a disk that fails while a file is written"},
    {"sampling/patch_measures.cc", "sizes of fields"},
    {"\" do not fit together: rank ", "sizes of fields"},
    {"geometry/curve.cc", "segments of the standard profiles"},
    {"geometry/segment.cc", "segments of the standard profiles"},
    {"geometry/profiles.cc", "the entries accept known names only"},
    {"mesh/section_builder.cc", "sides of parts that the program lays out itself, and folded blocks"},
    {"solid/", "folded cells, which mesh/section_builder.cc finds before"},
    {"contact/surface.cc", "holes in the fine zone, which the program lays out itself"},
    {"material/", "the entries accept possible materials only"},
  };

  /// Messages that need a machine in a state that a test cannot make without harm, input that the entries do
  /// not accept, or minutes of computing; the tests of runs bring some of them about.
  // long messages stand in two pieces: NOLINTBEGIN(bugprone-suspicious-missing-comma)
  const std::vector<std::string> hard_to_test = {
    "/usr/bin/python3 cannot be started; install the Debian packages python3, python3-h5py and "
    "python3-matplotlib",
    // sections of rails that no profile gives
    "The waves of the section could not be found at the wavenumber ",
    "The waves of the section could not be found at ",
    "There is no running surface below the face of the hammer.",
    // tests/installed.py
    " is there; build or install the program again",
    "the run stopped: ",
    "The plan of the study cannot be written into the folder of temporary files, ",
    "--resume: the mesh is not that of the saved state, since a profile file or the program has changed: "
    "start anew without --resume",
    // penalty scales of 200 and more, where 50 is the most that is accepted
    " N of the wheel load are missing; lower Contact/Penalty scale or refine the mesh",
    "the static start did not converge: conjugate gradients stopped after ",
    // half a minute of computing; tests/static_progress.cc has the rule
    " N left at a node; bodies may be too soft for this load, or the contact too stiff: look at Young's "
    "modulus, "
    "Yield stress, Tangent modulus and Contact/Penalty scale",
    // its forces are those of the bodies themselves
    " % of the forces are left, and residual stresses stay unknown",
  };
  // NOLINTEND(bugprone-suspicious-missing-comma)

  bool
  is_internal(const Message &message)
  {
    return std::any_of(internal.begin(), internal.end(), [&](const auto &place) {
      return message.file.rfind(place.first, 0) == 0 || key_of(message) == place.first;
    });
  }
} // namespace


BOOST_AUTO_TEST_CASE(message_list)
{
  // a test may compare a part of a message, but one that tells it from others
  std::vector<std::string> tested;
  for (const fs::path &path : files_below(WHEELRAIL_TEST_DIR, false))
    if (path.filename() != "message_list.cc")
      for (const std::string &text : literals(whole_file(path), 0, false))
        if (text.size() > 11)
          tested.push_back(text);

  const std::vector<Message> messages = messages_of_source();
  BOOST_TEST(messages.size() > 100, std::to_string(messages.size()) + " messages found in the source");
  for (const Message &message : messages)
    {
      const std::string key = key_of(message);
      if (is_internal(message) ||
          std::find(hard_to_test.begin(), hard_to_test.end(), key) != hard_to_test.end())
        continue;
      const bool is_tested = std::any_of(tested.begin(), tested.end(), [&](const std::string &text) {
        return text.find(key) != std::string::npos ||
               std::any_of(message.parts.begin(), message.parts.end(), [&](const std::string &part) {
                 return 2 * text.size() > key.size() && part.find(text) != std::string::npos;
               });
      });
      BOOST_TEST(is_tested, "a test compares \"" + key + "\" of " + message.file);
    }
}
