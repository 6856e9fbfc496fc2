#include <wheelrail/base/errors.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/parameter_handler.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <memory>

namespace wheelrail
{
  namespace
  {
    using dealii::ParameterHandler;

    /// What an entry accepts: numbers with their units within a range, a word such as "auto" beside them,
    /// names or files.
    class EntryPattern : public dealii::Patterns::PatternBase
    {
    public:
      explicit EntryPattern(const Entry &entry)
        : entry_(entry)
      {
      }

      bool
      match(const std::string &text) const override
      {
        try
          {
            Scene scene;
            entry_.set(scene, text);
            return true;
          }
        catch (const InputError &)
          {
            return false;
          }
      }

      std::string
      description(const OutputStyle style) const override
      {
        return style == Machine ? "[" + entry_.accepted + "]" : entry_.accepted;
      }

      std::unique_ptr<PatternBase>
      clone() const override
      {
        return std::make_unique<EntryPattern>(*this);
      }

    private:
      const Entry &entry_; ///< one of entries(), which stay
    };

    /// A choice in deal.II's own pattern, for which its parameter GUI shows a list.
    std::unique_ptr<dealii::Patterns::PatternBase>
    pattern_of(const Entry &entry)
    {
      if (entry.choices.empty())
        return std::make_unique<EntryPattern>(entry);
      std::string words;
      for (const std::string &choice : entry.choices)
        words += (words.empty() ? "" : "|") + choice;
      return std::make_unique<dealii::Patterns::Selection>(words);
    }
  } // namespace


  InSection::InSection(ParameterHandler &handler, const std::string &section)
    : handler_(handler)
    , entered_(!section.empty())
  {
    if (entered_)
      handler_.enter_subsection(section);
  }


  InSection::~InSection()
  {
    if (entered_)
      handler_.leave_subsection();
  }


  void
  declare_entries(ParameterHandler &handler, Scene &scene)
  {
    for (const Entry &entry : entries())
      {
        const InSection in_section(handler, entry.section);
        handler.declare_entry(entry.name, entry.default_text, *pattern_of(entry), entry.meaning);
        handler.add_action(entry.name, [&entry, &scene](const std::string &text) { entry.set(scene, text); });
      }
    // the actions have just set the defaults, as far as their texts tell them: 140 km/h are not all of
    // 140/3.6
    scene = Scene();
  }


  void
  set_entry(ParameterHandler  &handler,
            const std::string &section,
            const std::string &name,
            const std::string &value)
  {
    const InSection in_section(handler, section);
    handler.set(name, value);
  }


  void
  parse_entries(const std::string &text, const std::vector<Assignment> &assignments, Scene &scene)
  {
    ParameterHandler handler;
    declare_entries(handler, scene);
    handler.parse_input_from_string(text);
    for (const Assignment &one : assignments)
      {
        const std::vector<std::string> path(one.section.empty() ? 0 : 1, one.section);
        // a brace begins values for several runs there, for which no action is called
        if (handler.get(path, one.name) != one.value || one.value.find('{') != std::string::npos)
          set_entry(handler, one.section, one.name, one.value);
      }
  }
} // namespace wheelrail
