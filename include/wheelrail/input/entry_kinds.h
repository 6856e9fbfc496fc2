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

    /// Writes the value of a text into a scene. Throws InputError that tells what was found and
    /// what is accepted, without naming the entry.
    std::function<void(Scene &, const std::string &)> set;

    /// The text that `set` turns back into the value of the scene.
    std::function<std::string(const Scene &)> get;

    bool repeats = false; ///< the same as in the first one of numbered subsections

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

  template <typename T>
  Field<T>
  field(T Scene::*member)
  {
    return [member](Scene &scene) -> T & { return scene.*member; };
  }

  template <typename Part, typename T>
  Field<T>
  field(Part Scene::*part, T Part::*member)
  {
    return [part, member](Scene &scene) -> T & { return scene.*part.*member; };
  }

  /// Accepted range of a number, its ends written as a user would; an empty text is no bound.
  struct Bounds
  {
    std::string low, high;
    bool        above_low = false; ///< `low` itself is refused

    static Bounds
    above(const std::string &low, const std::string &high = "")
    {
      return {low, high, true};
    }

    static Bounds
    between(const std::string &low, const std::string &high)
    {
      return {low, high, false};
    }
  };

  /// Head of an entry. The default of an entry is that of its place in a Scene.
  struct EntryHead
  {
    std::string section, name, meaning;
  };

  /// A number with `unit` (printed in it, any unit of the dimension accepted), or a pure number
  /// when `dimension` is none and `unit` empty.
  Entry
  number_entry(const EntryHead     &head,
               Dimension            dimension,
               const std::string   &unit,
               const Bounds        &bounds,
               const Field<double> &place);

  /// A length.
  Entry
  length_entry(const EntryHead     &head,
               const std::string   &unit,
               const Bounds        &bounds,
               const Field<double> &place);

  /// A pure number.
  Entry
  pure_entry(const EntryHead &head, const Bounds &bounds, const Field<double> &place);

  /// At most `most` numbers as number_entry() reads them, with commas between them; `none` for no number.
  Entry
  list_entry(const EntryHead                  &head,
             Dimension                         dimension,
             const std::string                &unit,
             const Bounds                     &bounds,
             std::size_t                       most,
             const Field<std::vector<double>> &place);

  /// A whole number from `low` to `high`.
  Entry
  count_entry(const EntryHead &head, unsigned int low, unsigned int high, const Field<unsigned int> &place);

  /// One of several words; texts and values in pairs.
  template <typename T>
  Entry
  choice_entry(const EntryHead                              &head,
               const std::vector<std::pair<std::string, T>> &choices,
               const Field<T>                               &place);

  /// Free text of one line; an empty one is accepted when the default is empty.
  Entry
  text_entry(const EntryHead &head, const Field<std::string> &place);

  /// A text that is one of `names` or means a file (is_file_name()); `file` says which files are accepted.
  Entry
  name_or_file_entry(const EntryHead                &head,
                     const std::vector<std::string> &names,
                     const std::string              &file,
                     const Field<std::string>       &place);

  /// `entry` with a word that is accepted, too, and stored as `value`: "auto", "none".
  Entry
  with_word(Entry entry, const std::string &word, double value, const Field<double> &place);
  Entry
  with_word(Entry entry, const std::string &word, unsigned int value, const Field<unsigned int> &place);

  // ---------------------------------------------------------------------------------------------

  template <typename T>
  Entry
  choice_entry(const EntryHead                              &head,
               const std::vector<std::pair<std::string, T>> &choices,
               const Field<T>                               &place)
  {
    std::vector<std::string> words;
    for (const auto &choice : choices)
      words.push_back(choice.first);
    Entry entry{head.section, head.name, head.meaning, join_choices(words), words, {}, {}, {}};
    entry.set = [choices, words, place](Scene &scene, const std::string &text) {
      require_choice(text, words);
      for (const auto &choice : choices)
        if (choice.first == text)
          place(scene) = choice.second;
    };
    entry.get = [choices, place](const Scene &scene) {
      Scene copy = scene;
      for (const auto &choice : choices)
        if (place(copy) == choice.second)
          return choice.first;
      return choices.front().first;
    };
    return entry;
  }
} // namespace wheelrail
