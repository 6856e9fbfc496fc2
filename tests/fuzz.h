#pragma once

// What the fuzz tests share: changed copies ("mutants") of seed texts, and a watch that ends the test
// with the mutant in a file when reading it crashes or takes too long. The numbers come from a fixed
// seed, which the test prints and takes as its first argument; the second is the number of mutants.

#include "near.h"

#include <wheelrail/base/read_file.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/time.h>
#include <unistd.h>

namespace test
{
  struct FuzzOptions
  {
    unsigned long seed  = 20170315;
    unsigned long count = 0;
  };

  inline FuzzOptions
  fuzz_options(const unsigned long count)
  {
    FuzzOptions options;
    options.count   = count;
    const auto &all = boost::unit_test::framework::master_test_suite();
    if (all.argc > 1)
      options.seed = std::strtoul(all.argv[1], nullptr, 10);
    if (all.argc > 2)
      options.count = std::strtoul(all.argv[2], nullptr, 10);
    std::cout << options.count << " mutants, seed " << options.seed << " (arguments: seed, number)"
              << std::endl;
    return options;
  }

  /// The files of a folder with one of these endings, in the order of their names.
  inline std::vector<std::string>
  seed_texts(const std::string &folder, const std::vector<std::string> &endings)
  {
    std::vector<std::string> paths, texts;
    if (std::filesystem::is_directory(folder))
      for (const auto &file : std::filesystem::directory_iterator(folder))
        if (std::find(endings.begin(), endings.end(), file.path().extension()) != endings.end())
          paths.push_back(file.path().string());
    std::sort(paths.begin(), paths.end());
    for (const std::string &path : paths)
      texts.push_back(wheelrail::read_whole_file(path));
    return texts;
  }

  /// Makes mutants of seed texts.
  class Mutator
  {
  public:
    /// `words` are put in where they may hurt most: names, units, odd numbers.
    Mutator(const unsigned long seed, std::vector<std::string> texts, std::vector<std::string> words)
      : random_(seed)
      , texts_(std::move(texts))
      , words_(std::move(words))
    {
    }

    std::string
    next()
    {
      std::string text = one_of(texts_);
      // half of them are changed once: those are the nearly right ones
      for (std::size_t n = below(2) == 0 ? 1 : below(6) + 2; n > 0; --n)
        change(text);
      return text;
    }

    /// A whole number from 0 to n - 1.
    std::size_t
    below(const std::size_t n)
    {
      return random_() % n; // the same on every machine, as the distributions of the library are not
    }

    const std::string &
    one_of(const std::vector<std::string> &choices)
    {
      return choices[below(choices.size())];
    }

  private:
    /// Start and length of a random stretch of at most `most` characters.
    std::pair<std::size_t, std::size_t>
    stretch(const std::string &text, const std::size_t most)
    {
      const std::size_t begin = below(text.size() + 1);
      return {begin, std::min(text.size() - begin, below(most) + 1)};
    }

    /// Start and length of a random word, number or sign.
    std::pair<std::size_t, std::size_t>
    token(const std::string &text)
    {
      const auto is_word = [&](const std::size_t i) {
        return std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '.' || text[i] == '\'';
      };
      std::size_t begin = below(text.size()), end = begin + 1;
      while (is_word(begin) && begin > 0 && is_word(begin - 1))
        --begin;
      while (is_word(begin) && end < text.size() && is_word(end))
        ++end;
      return {begin, end - begin};
    }

    /// Start and length of a random line with its end.
    std::pair<std::size_t, std::size_t>
    line(const std::string &text)
    {
      const std::size_t at     = below(text.size()),
                        before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
      const std::size_t begin = before == std::string::npos ? 0 : before + 1, end = text.find('\n', begin);
      return {begin, (end == std::string::npos ? text.size() : end + 1) - begin};
    }

    void
    change(std::string &text)
    {
      const std::size_t kind = below(16);
      if (text.empty())
        text = one_of(words_);
      if (kind < 4)
        change_bytes(text, kind);
      else if (kind < 10)
        change_words(text, kind);
      else
        change_lines(text, kind);
    }

    void
    change_bytes(std::string &text, const std::size_t kind)
    {
      const auto part = stretch(text, 30);
      if (kind == 0)
        text[below(text.size())] = static_cast<char>(below(256));
      else if (kind == 1)
        text.insert(part.first, std::string(below(4) + 1, static_cast<char>(below(256))));
      else if (kind == 2)
        text.erase(part.first, part.second);
      else
        text.insert(below(text.size() + 1), text.substr(part.first, part.second));
    }

    void
    change_words(std::string &text, const std::size_t kind)
    {
      const auto part = token(text);
      if (kind < 8)
        text.replace(part.first, part.second, one_of(words_));
      else if (kind == 8)
        text.erase(part.first, part.second);
      else
        {
          const std::string &other = one_of(texts_);
          if (other.empty())
            return;
          const auto taken = token(other);
          text.replace(part.first, part.second, other.substr(taken.first, taken.second));
        }
    }

    void
    change_lines(std::string &text, const std::size_t kind)
    {
      const auto        part = line(text);
      const std::string kept = text.substr(part.first, part.second);
      if (kind == 10)
        text.erase(part.first, part.second);
      else if (kind == 11)
        text.insert(line(text).first, kept);
      else if (kind == 12) // a line comes many times: deep nesting, many faults
        {
          std::string many;
          for (std::size_t n = below(2000); n > 0 && many.size() < 200000; --n)
            many += kept;
          text.insert(part.first, many);
        }
      else if (kind == 13) // a long line
        text.insert(stretch(text, 1).first, std::string(below(100000), one_of(words_).c_str()[0]));
      else if (kind == 14)
        text.resize(below(text.size()) + 1);
      else
        {
          const std::string &other = one_of(texts_);
          text = text.substr(0, part.first) + other.substr(std::min(other.size(), below(other.size() + 1)));
        }
    }

    std::mt19937_64          random_;
    std::vector<std::string> texts_, words_;
  };

  /// The mutant at work, for the signal handler.
  struct AtWork
  {
    const std::string *text   = nullptr;
    unsigned long      number = 0;
  };

  inline AtWork &
  at_work()
  {
    static AtWork work;
    return work;
  }

  constexpr const char *failure_file = "fuzz_failure.txt";

  inline void
  keep_mutant(const std::string &text)
  {
    const int file = open(failure_file, O_CREAT | O_WRONLY | O_TRUNC, 0644);
    if (file >= 0 && write(file, text.data(), text.size()) >= 0)
      close(file);
  }

  /// Crash or hang: keeps the mutant and ends the test.
  inline void
  end_at_signal(const int signal)
  {
    if (at_work().text != nullptr)
      keep_mutant(*at_work().text);
    const char *const text = signal == SIGVTALRM
                               ? "FAILED  a mutant takes too long; it is in fuzz_failure.txt\n"
                               : "FAILED  a mutant crashes; it is in fuzz_failure.txt\n";
    if (write(STDOUT_FILENO, text, std::strlen(text)) < 0)
      std::_Exit(2);
    std::_Exit(1);
  }

  /// Each mutant may take this long [s of CPU].
  constexpr int seconds_per_mutant = 10;

  inline void
  watch()
  {
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGVTALRM})
      std::signal(signal, end_at_signal);
  }

  inline void
  begin_mutant(const std::string &text, const unsigned long number)
  {
    at_work()             = {&text, number};
    const itimerval limit = {{0, 0}, {seconds_per_mutant, 0}};
    setitimer(ITIMER_VIRTUAL, &limit, nullptr);
  }

  inline void
  end_mutant()
  {
    const itimerval none = {{0, 0}, {0, 0}};
    setitimer(ITIMER_VIRTUAL, &none, nullptr);
    at_work() = {};
  }

  /// What is wrong with a message: every line must be one sentence that begins with `start`, the name of a
  /// file or of its folder; an empty text when it is right.
  inline std::string
  fault_of_message(const std::string &message, const std::string &start)
  {
    if (message.empty() || message.back() == '\n')
      return "is empty or ends with a line end";
    std::size_t lines = 0;
    for (std::size_t begin = 0; begin <= message.size(); ++lines)
      {
        const std::size_t end  = std::min(message.find('\n', begin), message.size());
        const std::string line = message.substr(begin, end - begin);
        if (line.compare(0, start.size(), start) != 0)
          return "does not begin with the file: " + line;
        if (line.size() > 1000)
          return "is longer than 1000 characters: " + line.substr(0, 200);
        if (std::any_of(line.begin(), line.end(), [](const char c) {
              return static_cast<unsigned char>(c) < 32 || c == 127;
            }))
          return "holds control characters";
        begin = end + 1;
      }
    return lines > 30 ? "has more lines than a screen" : "";
  }

  /// Reads `count` mutants: `read` gives the message of a mutant, or an empty text when it was
  /// accepted. Every message must be right, and both must happen.
  inline void
  fuzz(Mutator                                                              &mutator,
       const unsigned long                                                   count,
       const std::string                                                    &start,
       const std::function<std::string(const std::string &, unsigned long)> &read)
  {
    watch();
    unsigned long accepted = 0, good = 0;
    for (unsigned long n = 0; n < count; ++n)
      {
        const std::string text = mutator.next();
        std::string       fault;
        begin_mutant(text, n);
        try
          {
            const std::string message = read(text, n);
            accepted += message.empty();
            if (!message.empty())
              fault = fault_of_message(message, start);
          }
        catch (const std::exception &error)
          {
            fault = std::string("is no InputError: ") + error.what();
          }
        end_mutant();
        good += fault.empty();
        if (!fault.empty())
          {
            keep_mutant(text);
            BOOST_TEST(false,
                       "mutant " + std::to_string(n) + " (in " + failure_file + "): its message " + fault);
            break;
          }
      }
    BOOST_TEST((good == count),
               std::to_string(good) + " mutants read as they should: " + std::to_string(accepted) +
                 " accepted, " + std::to_string(good - accepted) + " refused by a sentence");
    BOOST_TEST((accepted > 0 && accepted < good), "both happened");
  }
} // namespace test
