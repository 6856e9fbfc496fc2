#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/parameter_handler.h>

#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace wheelrail
{
  namespace
  {
    /// Breaks `text` at blanks into lines of at most `width` characters, each after `prefix`.
    std::string
    wrap(const std::string &text, const std::string &prefix, const std::size_t width)
    {
      std::istringstream words(text);
      std::string        lines, line;
      for (std::string word; words >> word;)
        {
          if (!line.empty() && prefix.size() + line.size() + 1 + word.size() > width)
            {
              lines += prefix + line + "\n";
              line.clear();
            }
          line += (line.empty() ? "" : " ") + word;
        }
      return lines + (line.empty() ? "" : prefix + line + "\n");
    }

    std::string
    print_entry(const Entry &entry, const Scene &scene)
    {
      const std::string indent = entry.section.empty() ? "" : "  ";
      const std::string value  = entry.get(scene);
      const std::string comment =
        entry.meaning + " Accepted: " + entry.accepted + "." +
        (entry.default_text.empty() || entry.default_text == value ? ""
                                                                   : " Default: " + entry.default_text + ".");
      return wrap(comment, indent + "# ", 100) + indent + "set " + entry.name + " =" +
             (value.empty() ? "" : " " + value) + "\n";
    }

    /// Whether a subsection of many alike is left as it is by default: it is not listed.
    bool
    stays_out(const std::string &section, const Scene &scene)
    {
      for (const Entry &entry : entries())
        if (entry.section == section && (!entry.repeats || entry.get(scene) != entry.default_text))
          return false;
      return true;
    }

    std::string
    print_prm(const Scene &scene)
    {
      std::string text =
        "# All entries of a scene. Entries that are not set take their default.\n"
        "# A number that measures something carries its unit.\n\n";
      std::string open;
      for (const Entry &entry : entries())
        {
          if (entry.repeats && stays_out(entry.section, scene))
            continue;
          if (entry.section != open)
            {
              text += (open.empty() ? "" : "end\n") + std::string("\nsubsection ") + entry.section + "\n";
              open = entry.section;
            }
          else if (!open.empty())
            text += "\n";
          text += print_entry(entry, scene);
        }
      return text + "end\n";
    }

    std::string
    print_by_handler(const Scene &scene, const dealii::ParameterHandler::OutputStyle style)
    {
      Scene                    copy;
      dealii::ParameterHandler handler;
      declare_entries(handler, copy);
      for (const Entry &entry : entries())
        set_entry(handler, entry.section, entry.name, entry.get(scene));
      std::ostringstream out;
      handler.print_parameters(out, style | dealii::ParameterHandler::KeepDeclarationOrder);
      return out.str();
    }
  } // namespace


  std::string
  print_parameters(const Scene &scene, const ParameterStyle style)
  {
    if (style == ParameterStyle::prm)
      return print_prm(scene);
    return print_by_handler(
      scene, style == ParameterStyle::json ? dealii::ParameterHandler::JSON : dealii::ParameterHandler::XML);
  }
} // namespace wheelrail
