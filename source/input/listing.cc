#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/parameter_handler.h>

#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace wheelrail
{
  namespace
  {
    using dealii::ParameterHandler;

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
    printed(const ParameterHandler &handler, const ParameterHandler::OutputStyle style)
    {
      std::ostringstream out;
      handler.print_parameters(out, style | ParameterHandler::KeepDeclarationOrder);
      return out.str();
    }

    /// The values are declared as defaults: deal.II writes others behind the value, where those who read such
    /// a file line by line do not look for them.
    std::string
    print_prm(const Scene &scene)
    {
      ParameterHandler handler;
      for (const Entry &entry : entries())
        if (!entry.repeats || !stays_out(entry.section, scene))
          {
            const std::string value = entry.get(scene);
            const bool        other = value != entry.default_text && !entry.default_text.empty();
            const InSection   in_section(handler, entry.section);
            handler.declare_entry(entry.name,
                                  value,
                                  dealii::Patterns::Anything(),
                                  entry.meaning + " Accepted: " + entry.accepted + "." +
                                    (other ? " Default: " + entry.default_text + "." : ""));
          }
      return "# All entries of a scene. Entries that are not set take their default.\n"
             "# A number that measures something carries its unit.\n" +
             printed(handler, ParameterHandler::PRM);
    }

    std::string
    print_by_handler(const Scene &scene, const ParameterHandler::OutputStyle style)
    {
      Scene            copy;
      ParameterHandler handler;
      declare_entries(handler, copy);
      for (const Entry &entry : entries())
        set_entry(handler, entry.section, entry.name, entry.get(scene));
      return printed(handler, style);
    }
  } // namespace


  std::string
  print_parameters(const Scene &scene, const ParameterStyle style)
  {
    if (style == ParameterStyle::prm)
      return print_prm(scene);
    return print_by_handler(scene,
                            style == ParameterStyle::json ? ParameterHandler::JSON : ParameterHandler::XML);
  }
} // namespace wheelrail
