#pragma once

// Mutants of profile files: each gives a profile with finite points, or an InputError that names the
// file.

#include "fuzz.h"

#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/profiles/profile_file.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test
{
  inline std::vector<std::string>
  profile_words()
  {
    std::vector<std::string> words = wheelrail::split_list(
      "0 | -0 | 1 | -1 | 1e9 | 1e308 | 1e999 | -1e-999 | nan | inf | 0x10 | 1,5 | 1.5.2 | 1e | . | - | + | = "
      "| , | ; | \t |   | \n | \r | \r\n | ! | # | // | \" | ' | 1000 | 0.001 | 25.4 | 1000000 | -70 | 0 0 | "
      "1 1\n | 1;1\n | x y z | \xEF\xBB\xBF | \xFF\xFE | point.begin | point.end | type | type = 1 | type = "
      "0 | units.len.f | units.len.f = 1000 | units.len.f = 0 | inversion | mirror.y | mirror.z | "
      "bound.y.min | comment | header.begin | header.end | spline.begin | spline.end | ColumnDef=X,Y | "
      "ColumnDef=Y,X,N | XYPoints=3 | XYPoints=99999999999 | XOffset=1 | Rail | ProgramName=MiniProf",
      '|');
    std::replace(words.begin(), words.end(), std::string(), std::string(1, ' ')); // split_list() drops blanks
    words.emplace_back(1, '\0');
    words.emplace_back(400, '9');
    words.emplace_back(5000, ' ');
    return words;
  }

  inline std::string
  read_profile_mutant(const std::string                   &text,
                      const std::string                   &name,
                      const wheelrail::ProfileFileOptions &options,
                      const bool                           from_file)
  {
    try
      {
        const wheelrail::MeasuredProfile profile = from_file
                                                     ? wheelrail::read_profile_file(name, options)
                                                     : wheelrail::read_profile_text(text, name, options);
        for (const wheelrail::FilePoint &point : profile.points)
          if (!std::isfinite(point.position.x) || !std::isfinite(point.position.y))
            throw std::logic_error("a point of the profile is not finite");
        if (profile.points.size() < 2)
          throw std::logic_error("the profile has no points");
        return "";
      }
    catch (const wheelrail::InputError &error)
      {
        return error.what();
      }
  }

  inline void
  fuzz_profiles(const unsigned long count)
  {
    const FuzzOptions options = fuzz_options(count);
    const auto        texts =
      seed_texts(WHEELRAIL_TEST_DIR "/profiles", {".prr", ".prw", ".ban", ".whl", ".txt", ".dat", ".csv"});
    BOOST_TEST(!texts.empty(), "seeds: " + std::to_string(texts.size()) + " files of tests/profiles/");
    Mutator           mutator(options.seed, texts, profile_words());
    const std::string name = "mutant.txt";
    fuzz(mutator, options.count, name + ":", [&](const std::string &text, const unsigned long n) {
      using namespace wheelrail;
      // mostly as a user would give them, sometimes against the file
      ProfileFileOptions how;
      how.kind =
        (text.find("S1002") != std::string::npos) != (n % 5 == 0) ? ProfileKind::wheel : ProfileKind::rail;
      how.unit   = n % 16 == 1   ? ProfileUnit::millimetre
                   : n % 16 == 6 ? ProfileUnit::metre
                   : n % 16 == 9 ? ProfileUnit::inch
                                 : ProfileUnit::automatic;
      how.mirror = n % 3 == 0   ? ProfileMirror::automatic
                   : n % 3 == 1 ? ProfileMirror::yes
                                : ProfileMirror::no;
      how.noise  = n % 7 == 0 ? 50e-6 : -1;
      if (n % 2 == 0)
        std::ofstream(name, std::ios::binary) << text;
      return read_profile_mutant(text, name, how, n % 2 == 0);
    });
    std::filesystem::remove(name);
  }
} // namespace test
