#pragma once

#include <wheelrail/base/choices.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/scene/scene.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// One entry of the input: how it is called, what it means, how its text becomes a value of the
  /// scene and back.
  struct Entry
  {
    std::string              section; ///< empty for entries outside all subsections
    std::string              name;
    std::string              meaning;
    std::string              accepted;     ///< in words: "a length from 0.1 mm to 4 mm", "torque or rate"
    std::vector<std::string> choices;      ///< all texts that are accepted, when these are a few words
    std::string              default_text; ///< what `get` makes of a scene of defaults; entries() fills it in

    /// Writes the value of a text into a scene. Throws InputError that says what was found and
    /// what is accepted, without naming the entry.
    std::function<void(Scene &, const std::string &)> set;

    /// The text that `set` turns back into the value of the scene.
    std::function<std::string(const Scene &)> get;

    bool repeats     = false; ///< the same as in the first one of numbered subsections
    bool names_files = false; ///< its value may be the name of a file, or of several with commas between

    /// "Section/Name", as messages and --set write it.
    std::string
    path() const
    {
      return section.empty() ? name : section + "/" + name;
    }
  };

  /// The place of a value in a scene.
  template <typename T>
  using Field = std::function<T &(Scene &)>;

  template <typename Settings, typename T>
  Field<T>
  field(T Settings::*member)
  {
    return [member](Scene &scene) -> T & { return scene.*member; };
  }

  template <typename Settings, typename Part, typename T>
  Field<T>
  field(Part Settings::*part, T Part::*member)
  {
    return [part, member](Scene &scene) -> T & { return scene.*part.*member; };
  }

  /// Texts and the values that they stand for.
  template <typename T>
  using Words = std::vector<std::pair<std::string, T>>;

  /// Head of a number: how it is called, the unit that it is printed in (any unit of the dimension is
  /// accepted; a pure number has none), and its range, the ends written as a user would. An empty end is no
  /// bound; "> 0 mm" is one that is refused itself.
  struct NumberHead
  {
    std::string name, unit, low, high;
  };

  /// Head of a whole number from `low` to `high`.
  struct CountHead
  {
    std::string  name;
    unsigned int low, high;
  };

  /// The entries of one subsection as they are declared, each once. Defaults are those of their places in a
  /// Scene.
  class EntryList
  {
  public:
    explicit EntryList(const std::string &section);

    /// A number; `words` are accepted beside it: "auto", "none".
    Entry &
    number(const NumberHead    &head,
           const Field<double> &place,
           const std::string   &meaning,
           const Words<double> &words = {});

    /// At most `most` numbers with commas between them; `none` for no number.
    Entry &
    numbers(const NumberHead                 &head,
            std::size_t                       most,
            const Field<std::vector<double>> &place,
            const std::string                &meaning);

    Entry &
    count(const CountHead           &head,
          const Field<unsigned int> &place,
          const std::string         &meaning,
          const Words<unsigned int> &words = {});

    /// One of several words.
    template <typename T>
    Entry &
    choice(const std::string &name,
           const Words<T>    &choices,
           const Field<T>    &place,
           const std::string &meaning);

    /// Free text of one line; an empty one is accepted when the default is empty.
    Entry &
    text(const std::string &name, const Field<std::string> &place, const std::string &meaning);

    /// A text that is one of `names` or means a file (is_file_name()); `file` says which files are accepted.
    Entry &
    name_or_file(const std::string              &name,
                 const std::vector<std::string> &names,
                 const std::string              &file,
                 const Field<std::string>       &place,
                 const std::string              &meaning);

    /// What is none of these.
    Entry &
    add(const std::string                                       &name,
        const std::string                                       &meaning,
        const std::string                                       &accepted,
        const std::function<void(Scene &, const std::string &)> &set,
        const std::function<std::string(const Scene &)>         &get);

    std::vector<Entry> entries;

  private:
    std::string section_;
  };

  // ---------------------------------------------------------------------------------------------

  template <typename T>
  Entry &
  EntryList::choice(const std::string &name,
                    const Words<T>    &choices,
                    const Field<T>    &place,
                    const std::string &meaning)
  {
    std::vector<std::string> words;
    for (const auto &choice : choices)
      words.push_back(choice.first);
    Entry &entry = add(
      name,
      meaning,
      join_choices(words),
      [choices, words, place](Scene &scene, const std::string &text) {
        require_choice(text, words);
        for (const auto &choice : choices)
          if (choice.first == text)
            place(scene) = choice.second;
      },
      [choices, place](const Scene &scene) {
        Scene copy = scene;
        for (const auto &choice : choices)
          if (place(copy) == choice.second)
            return choice.first;
        return choices.front().first;
      });
    entry.choices = words;
    return entry;
  }
} // namespace wheelrail
