#include <wheelrail/base/errors.h>
#include <wheelrail/base/split_list.h>
#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/profiles/profile_file.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// "a length from 0.1 mm to 4 mm", "a mass above 0 kg".
    std::string
    in_words(const Dimension dimension, const Bounds &bounds)
    {
      std::string words = dimension_name(dimension);
      if (!bounds.low.empty())
        words += (bounds.above_low ? " above " : " from ") + bounds.low;
      if (!bounds.high.empty())
        words += (bounds.low.empty() ? " up to " : bounds.above_low ? ", at most " : " to ") + bounds.high;
      return words;
    }

    void
    require_bounds(const double value, const Dimension dimension, const Bounds &bounds)
    {
      const std::string accepted = in_words(dimension, bounds);
      if (!bounds.low.empty())
        {
          const double low = parse_quantity(bounds.low, dimension);
          if (value < low || (bounds.above_low && value == low))
            throw InputError("too small; " + accepted + " is accepted");
        }
      if (!bounds.high.empty() && value > parse_quantity(bounds.high, dimension))
        throw InputError("too large; " + accepted + " is accepted");
    }
  } // namespace

  Entry
  number_entry(const EntryHead     &head,
               const Dimension      dimension,
               const std::string   &unit,
               const Bounds        &bounds,
               const Field<double> &place)
  {
    Entry entry{head.section, head.name, head.meaning, in_words(dimension, bounds), {}, {}, {}, {}};
    entry.set = [=](Scene &scene, const std::string &text) {
      const double value = parse_quantity(text, dimension);
      require_bounds(value, dimension, bounds);
      place(scene) = value;
    };
    entry.get = [=](const Scene &scene) {
      Scene copy = scene;
      return format_quantity(place(copy), unit);
    };
    return entry;
  }

  Entry
  length_entry(const EntryHead     &head,
               const std::string   &unit,
               const Bounds        &bounds,
               const Field<double> &place)
  {
    return number_entry(head, Dimension::length, unit, bounds, place);
  }

  Entry
  pure_entry(const EntryHead &head, const Bounds &bounds, const Field<double> &place)
  {
    return number_entry(head, Dimension::none, "", bounds, place);
  }

  Entry
  list_entry(const EntryHead                  &head,
             const Dimension                   dimension,
             const std::string                &unit,
             const Bounds                     &bounds,
             const std::size_t                 most,
             const Field<std::vector<double>> &place)
  {
    const std::string accepted = "none, or up to " + std::to_string(most) +
                                 " with commas between them, each " + in_words(dimension, bounds);
    Entry entry{head.section, head.name, head.meaning, accepted, {}, {}, {}, {}};
    entry.set = [=](Scene &scene, const std::string &text) {
      std::vector<double> values;
      for (const std::string &part : text == "none" ? std::vector<std::string>() : split_list(text, ','))
        {
          values.push_back(parse_quantity(part, dimension));
          require_bounds(values.back(), dimension, bounds);
        }
      if (values.size() > most)
        throw InputError(std::to_string(values.size()) + " values; at most " + std::to_string(most) +
                         " are accepted");
      place(scene) = values;
    };
    entry.get = [=](const Scene &scene) {
      Scene       copy = scene;
      std::string text;
      for (const double value : place(copy))
        text += (text.empty() ? "" : ", ") + format_quantity(value, unit);
      return text.empty() ? "none" : text;
    };
    return entry;
  }

  Entry
  count_entry(const EntryHead           &head,
              const unsigned int         low,
              const unsigned int         high,
              const Field<unsigned int> &place)
  {
    const std::string accepted = "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
    Entry             entry{head.section, head.name, head.meaning, accepted, {}, {}, {}, {}};
    entry.set = [=](Scene &scene, const std::string &text) {
      unsigned int value  = 0;
      const auto   result = std::from_chars(text.data(), text.data() + text.size(), value);
      if (result.ec != std::errc() || result.ptr != text.data() + text.size())
        throw InputError("not a whole number; " + accepted + " is needed");
      if (value < low || value > high)
        throw InputError(std::string(value < low ? "too small; " : "too large; ") + accepted +
                         " is accepted");
      place(scene) = value;
    };
    entry.get = [=](const Scene &scene) {
      Scene copy = scene;
      return std::to_string(place(copy));
    };
    return entry;
  }

  Entry
  text_entry(const EntryHead &head, const Field<std::string> &place)
  {
    Entry      entry{head.section, head.name, head.meaning, "a text", {}, {}, {}, {}};
    Scene      defaults;
    const bool may_be_empty = place(defaults).empty();
    entry.set               = [=](Scene &scene, const std::string &text) {
      if (text.empty() && !may_be_empty)
        throw InputError("no value; a text is needed");
      if (text.find('\n') != std::string::npos || (!text.empty() && text.back() == '\\'))
        throw InputError("a text is one line that does not end with a backslash");
      place(scene) = text;
    };
    entry.get = [=](const Scene &scene) {
      Scene copy = scene;
      return place(copy);
    };
    return entry;
  }

  Entry
  name_or_file_entry(const EntryHead                &head,
                     const std::vector<std::string> &names,
                     const std::string              &file,
                     const Field<std::string>       &place)
  {
    std::vector<std::string> choices = names;
    choices.push_back(file);
    Entry      entry = text_entry(head, place);
    const auto set   = entry.set;
    entry.accepted   = join_choices(choices);
    entry.set        = [set, names, accepted = entry.accepted](Scene &scene, const std::string &text) {
      if (std::find(names.begin(), names.end(), text) == names.end() && !is_file_name(text))
        throw InputError((text.empty() ? "no value; " : "not known here; ") + accepted + " is accepted");
      set(scene, text);
    };
    return entry;
  }

  namespace
  {
    template <typename T>
    Entry
    word_for(Entry entry, const std::string &word, const T value, const Field<T> &place)
    {
      entry.accepted = word + ", or " + entry.accepted;
      entry.set      = [=, set = entry.set](Scene &scene, const std::string &text) {
        if (text == word)
          place(scene) = value;
        else
          set(scene, text);
      };
      entry.get = [=, get = entry.get](const Scene &scene) {
        Scene copy = scene;
        return place(copy) == value ? word : get(scene);
      };
      return entry;
    }
  } // namespace


  Entry
  with_word(Entry entry, const std::string &word, const double value, const Field<double> &place)
  {
    return word_for(std::move(entry), word, value, place);
  }


  Entry
  with_word(Entry entry, const std::string &word, const unsigned int value, const Field<unsigned int> &place)
  {
    return word_for(std::move(entry), word, value, place);
  }
} // namespace wheelrail
