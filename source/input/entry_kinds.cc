#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/profiles/profile_file.h>

#include <algorithm>
#include <charconv>

namespace wheelrail
{
  namespace
  {
    /// A range of numbers as NumberHead has it.
    struct NumberRange
    {
      Dimension   dimension;
      std::string low, high;
      bool        above_low; ///< `low` itself is refused

      explicit NumberRange(const NumberHead &head)
        : dimension(dimension_of(head.unit))
        , low(head.low)
        , high(head.high)
        , above_low(head.low.compare(0, 2, "> ") == 0)
      {
        if (above_low)
          low.erase(0, 2);
      }

      /// "a length from 0.1 mm to 4 mm", "a mass above 0 kg".
      std::string
      in_words() const
      {
        std::string words = dimension_name(dimension);
        if (!low.empty())
          words += (above_low ? " above " : " from ") + low;
        if (!high.empty())
          words += (low.empty() ? " up to " : above_low ? ", at most " : " to ") + high;
        return words;
      }

      double
      value_of(const std::string &text) const
      {
        const double value = parse_quantity(text, dimension);
        const double least = low.empty() ? value : parse_quantity(low, dimension);
        if (value < least || (above_low && value == least))
          throw InputError("too small; " + in_words() + " is accepted");
        if (!high.empty() && value > parse_quantity(high, dimension))
          throw InputError("too large; " + in_words() + " is accepted");
        return value;
      }
    };

    /// Lets an entry accept words, too.
    template <typename T>
    Entry &
    with_words(Entry &entry, const Words<T> &words, const Field<T> &place)
    {
      std::string accepted;
      for (const auto &word : words)
        accepted += word.first + ", or ";
      entry.accepted = accepted + entry.accepted;
      entry.set      = [words, place, set = entry.set](Scene &scene, const std::string &text) {
        for (const auto &word : words)
          if (text == word.first)
            {
              place(scene) = word.second;
              return;
            }
        set(scene, text);
      };
      entry.get = [words, place, get = entry.get](const Scene &scene) {
        Scene copy = scene;
        for (const auto &word : words)
          if (place(copy) == word.second)
            return word.first;
        return get(scene);
      };
      return entry;
    }
  } // namespace


  EntryList::EntryList(const std::string &section)
    : section_(section)
  {
  }


  Entry &
  EntryList::add(const std::string                                       &name,
                 const std::string                                       &meaning,
                 const std::string                                       &accepted,
                 const std::function<void(Scene &, const std::string &)> &set,
                 const std::function<std::string(const Scene &)>         &get)
  {
    entries.push_back({section_, name, meaning, accepted, {}, {}, set, get});
    return entries.back();
  }


  Entry &
  EntryList::number(const NumberHead    &head,
                    const Field<double> &place,
                    const std::string   &meaning,
                    const Words<double> &words)
  {
    const NumberRange range(head);
    Entry            &entry = add(
      head.name,
      meaning,
      range.in_words(),
      [=](Scene &scene, const std::string &text) { place(scene) = range.value_of(text); },
      [place, unit = head.unit](const Scene &scene) {
        Scene copy = scene;
        return format_quantity(place(copy), unit);
      });
    return words.empty() ? entry : with_words(entry, words, place);
  }


  Entry &
  EntryList::numbers(const NumberHead                 &head,
                     const std::size_t                 most,
                     const Field<std::vector<double>> &place,
                     const std::string                &meaning)
  {
    const NumberRange range(head);
    return add(
      head.name,
      meaning,
      "none, or up to " + std::to_string(most) + " with commas between them, each " + range.in_words(),
      [=](Scene &scene, const std::string &text) {
        std::vector<double> values;
        for (const std::string &part : text == "none" ? std::vector<std::string>() : split_list(text, ','))
          values.push_back(range.value_of(part));
        if (values.size() > most)
          throw InputError(std::to_string(values.size()) + " values; at most " + std::to_string(most) +
                           " are accepted");
        place(scene) = values;
      },
      [place, unit = head.unit](const Scene &scene) {
        Scene       copy = scene;
        std::string text;
        for (const double value : place(copy))
          text += (text.empty() ? "" : ", ") + format_quantity(value, unit);
        return text.empty() ? "none" : text;
      });
  }


  Entry &
  EntryList::count(const CountHead           &head,
                   const Field<unsigned int> &place,
                   const std::string         &meaning,
                   const Words<unsigned int> &words)
  {
    const std::string accepted =
      "a whole number from " + std::to_string(head.low) + " to " + std::to_string(head.high);
    Entry &entry = add(
      head.name,
      meaning,
      accepted,
      [=](Scene &scene, const std::string &text) {
        unsigned int value  = 0;
        const auto   result = std::from_chars(text.data(), text.data() + text.size(), value);
        if (result.ec != std::errc() || result.ptr != text.data() + text.size())
          throw InputError("not a whole number; " + accepted + " is needed");
        if (value < head.low || value > head.high)
          throw InputError(std::string(value < head.low ? "too small; " : "too large; ") + accepted +
                           " is accepted");
        place(scene) = value;
      },
      [place](const Scene &scene) {
        Scene copy = scene;
        return std::to_string(place(copy));
      });
    return words.empty() ? entry : with_words(entry, words, place);
  }


  Entry &
  EntryList::text(const std::string &name, const Field<std::string> &place, const std::string &meaning)
  {
    Scene      defaults;
    const bool may_be_empty = place(defaults).empty();
    return add(
      name,
      meaning,
      "a text",
      [=](Scene &scene, const std::string &text) {
        if (text.empty() && !may_be_empty)
          throw InputError("no value; a text is needed");
        if (text.find('\n') != std::string::npos || (!text.empty() && text.back() == '\\'))
          throw InputError("a text is one line that does not end with a backslash");
        place(scene) = text;
      },
      [place](const Scene &scene) {
        Scene copy = scene;
        return place(copy);
      });
  }


  Entry &
  EntryList::name_or_file(const std::string              &name,
                          const std::vector<std::string> &names,
                          const std::string              &file,
                          const Field<std::string>       &place,
                          const std::string              &meaning)
  {
    std::vector<std::string> choices = names;
    choices.push_back(file);
    Entry &entry      = text(name, place, meaning);
    entry.accepted    = join_choices(choices);
    entry.names_files = true;
    entry.set = [names, set = entry.set, accepted = entry.accepted](Scene &scene, const std::string &text) {
      if (std::find(names.begin(), names.end(), text) == names.end() && !is_file_name(text))
        throw InputError((text.empty() ? "no value; " : "not known here; ") + accepted + " is accepted");
      set(scene, text);
    };
    return entry;
  }
} // namespace wheelrail
