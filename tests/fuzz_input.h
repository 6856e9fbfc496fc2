#pragma once

// Mutants of parameter files: each is either read, and its listing reads back to the same scene, or
// refused by an InputError whose lines name the file.

#include "fuzz.h"

#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/scene_checks.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test
{
  inline std::vector<std::string>
  input_words()
  {
    using wheelrail::Dimension;
    std::vector<std::string> words = wheelrail::split_list(
      "0 | -0 | 1 | -1 | 1e9 | 1e308 | 1e999 | 1e-999 | -1e400 | 5e-324 | nan | inf | -inf | 0x10 | 1/0 | "
      "1/40 | 1/1e-320 | 0/0 | 1,5 | 1.5.2 | . | + | - | = | == | # | / | \\ | \" | ' | set | end | "
      "subsection | include | set = | subsection\n | end\n | \n | \r | \r\n | \t |   | auto | none | true | "
      "false | 99999999999999999999 | 4294967296 | -2147483649 | \xEF\xBB\xBF | \xC2\xB5m | \xFF\xFE | "
      "${HOME} | $(ls) | ../../x.prm | %s%n",
      '|');
    std::replace(words.begin(), words.end(), std::string(), std::string(1, ' ')); // split_list() drops blanks
    words.emplace_back(1, '\0');
    words.emplace_back(500, '9');
    words.emplace_back(5000, 'a');
    words.emplace_back(5000, ' ');
    for (const wheelrail::Entry &entry : wheelrail::entries())
      for (const std::string &text : {entry.section, entry.name, entry.default_text})
        if (!text.empty())
          words.push_back(text);
    for (const char *unit :
         {"m",  "mm",  "um",  "km",    "kg",    "t",   "g",    "s",     "ms",    "m/s", "km/h", "N",   "kN",
          "Pa", "MPa", "GPa", "N/mm2", "kg/m3", "N/m", "MN/m", "N s/m", "kg m2", "rad", "mrad", "deg", "mph"})
      words.push_back(unit);
    return words;
  }

  /// A mutant as file or as text; an empty message when it was accepted.
  inline std::string
  read_mutant(const std::string &text, const std::string &name, const bool from_file)
  {
    try
      {
        const wheelrail::SceneInput input =
          from_file ? wheelrail::read_scene(name, {}) : wheelrail::scene_from_text(text, name, {});
        wheelrail::require_computable(input);
        const std::string listing = wheelrail::print_parameters(input.scene);
        if (wheelrail::print_parameters(wheelrail::scene_from_text(listing, "listing", {}).scene) != listing)
          throw std::logic_error("the listing of an accepted mutant reads back to another scene");
        return "";
      }
    catch (const wheelrail::InputError &error)
      {
        return error.what();
      }
  }

  inline void
  fuzz_input(const unsigned long count)
  {
    const FuzzOptions options = fuzz_options(count);
    auto              texts   = seed_texts(WHEELRAIL_SOURCE_DIR "/prm", {".prm"});
    BOOST_TEST(!texts.empty(),
               "seeds: " + std::to_string(texts.size()) + " files of prm/ and the listing of all entries");
    texts.push_back(wheelrail::print_parameters(wheelrail::Scene()));
    Mutator mutator(options.seed, texts, input_words());
    // in a folder with the files that the seeds include
    const std::string folder = "fuzz_input_" + std::to_string(options.count), name = folder + "/mutant.prm";
    std::filesystem::remove_all(folder);
    std::filesystem::copy(WHEELRAIL_SOURCE_DIR "/prm", folder);
    fuzz(mutator, options.count, folder + "/", [&](const std::string &text, const unsigned long n) {
      // half of them as a file, half as a text, which may hold any byte
      if (n % 2 == 0)
        std::ofstream(name, std::ios::binary) << text;
      return read_mutant(text, name, n % 2 == 0);
    });
    std::filesystem::remove_all(folder);
  }
} // namespace test
