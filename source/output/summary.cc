#include <wheelrail/base/errors.h>
#include <wheelrail/base/hints.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/summary.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <filesystem>

namespace wheelrail
{
  namespace
  {
    nlohmann::ordered_json
    to_json(const double value, const bool count)
    {
      if (!std::isfinite(value))
        return nullptr;
      if (count)
        return static_cast<std::int64_t>(std::llround(value));
      return value;
    }

    /// The text that stands under a key of the file, or null.
    std::string *
    text_of(Summary &summary, const std::string &key)
    {
      const std::pair<const char *, std::string *> texts[] = {
        {"title", &summary.title},
        {"program_version", &summary.program_version},
        {"stopped_because", &summary.stop_reason},
        {"ended", &summary.ended},
        {"ended_because", &summary.ended_because},
        {"note", &summary.note},
        {"verdict", &summary.verdict},
        {"doubts", &summary.doubts},
        {"largest_swing_of", &summary.largest_swing_of},
        {"largest_drift_of", &summary.largest_drift_of}};
      for (const auto &[name, text] : texts)
        if (key == name)
          return text;
      return nullptr;
    }
  } // namespace


  std::string
  verdict_of(const Summary &summary)
  {
    if (!summary.finished)
      return "not trusted";
    if (summary.verdict.empty())
      return summary.doubts.empty() ? "trusted" : "not trusted";
    return summary.verdict;
  }


  std::string
  verdict_line(const Summary &summary)
  {
    std::string why = summary.finished              ? summary.doubts
                      : summary.stop_reason.empty() ? "it did not finish"
                                                    : summary.stop_reason;
    why.erase(why.find_last_not_of(' ') + 1);
    return "verdict: " + verdict_of(summary) + (why.empty() ? "" : ": " + why);
  }


  void
  set_figure(Summary &summary, const std::string &key, const double value)
  {
    const Figure *const known = figure_with_key(key);
    if (known && known->value)
      {
        summary.*known->value = value;
        return;
      }
    for (auto &figure : summary.further)
      if (figure.first == key)
        {
          figure.second = value;
          return;
        }
    summary.further.emplace_back(key, value);
  }


  double
  get_figure(const Summary &summary, const std::string &key)
  {
    const Figure *const known = figure_with_key(key);
    if (known && known->value)
      return summary.*known->value;
    for (const auto &figure : summary.further)
      if (figure.first == key)
        return figure.second;
    return Summary::none;
  }


  std::string
  summary_as_text(const Summary &summary)
  {
    nlohmann::ordered_json json;
    json["title"]           = summary.title;
    json["program_version"] = summary.program_version;
    for (const Figure &figure : all_figures())
      if (figure.value)
        json[figure.key()] = to_json(summary.*figure.value, figure.count);
    for (const auto &figure : summary.further)
      {
        const Figure *const known = figure_with_key(figure.first);
        json[figure.first]        = to_json(figure.second, known && known->count);
      }
    json["finished"]         = summary.finished;
    json["stopped_because"]  = summary.stop_reason;
    json["ended"]            = summary.ended;
    json["ended_because"]    = summary.ended_because;
    json["note"]             = summary.note;
    json["verdict"]          = verdict_of(summary);
    json["trusted"]          = verdict_of(summary) == "trusted";
    json["doubts"]           = summary.doubts;
    json["largest_swing_of"] = summary.largest_swing_of;
    json["largest_drift_of"] = summary.largest_drift_of;

    // a title may hold bytes that are no UTF-8; they must not stop a run at its end
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  }


  void
  write_summary(const Summary &summary, const std::string &path)
  {
    replace_file(path, summary_as_text(summary));
    replace_file(std::filesystem::path(path).replace_filename("figures.json").string(), figures_as_json());
  }


  Summary
  summary_from_text(const std::string &text)
  {
    const auto json = nlohmann::ordered_json::parse(text, nullptr, false);
    if (!json.is_object())
      throw RunError("no summary of a run");
    Summary summary;
    for (const auto &item : json.items())
      if (item.value().is_number())
        set_figure(summary, item.key(), item.value().get<double>());
      else if (std::string *const text = item.value().is_string() ? text_of(summary, item.key()) : nullptr)
        *text = item.value().get<std::string>();
      else if (item.value().is_boolean() && item.key() == "finished")
        summary.finished = item.value().get<bool>();
      else if (item.value().is_null())
        set_figure(summary, item.key(), Summary::none);
    return summary;
  }


  Summary
  read_summary(const std::string &path)
  {
    const std::string text = read_whole_file(path);
    try
      {
        return summary_from_text(text);
      }
    catch (const RunError &error)
      {
        throw RunError("The file \"" + path + "\" is " + error.what() + "; compute it again with \"" +
                       own_call() + " run\".");
      }
  }
} // namespace wheelrail
