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

    /// A cell of a table: a bar would end it.
    std::string
    cell(const std::string &text)
    {
      std::string escaped;
      for (const char c : text)
        escaped += (c == '|' ? "\\" : "") + std::string(1, c);
      return escaped;
    }

    constexpr Dimension dimensions_of_entries[] = {Dimension::length,
                                                   Dimension::mass,
                                                   Dimension::time,
                                                   Dimension::slowness,
                                                   Dimension::frequency,
                                                   Dimension::velocity,
                                                   Dimension::force,
                                                   Dimension::stress,
                                                   Dimension::density,
                                                   Dimension::stiffness,
                                                   Dimension::turning_stiffness,
                                                   Dimension::damping,
                                                   Dimension::mass_moment,
                                                   Dimension::angle,
                                                   Dimension::spin};

    /// Leaves out `part` wherever it stands in `text`.
    void
    leave_out(const std::string &part, std::string &text)
    {
      for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
        text.erase(at, part.size());
    }

    void
    write_entries(const std::string &section, std::ostream &out)
    {
      for (const Entry &entry : entries())
        if (entry.section == section && entry.repeats)
          return;
      if (section == "Wheel material")
        {
          out << "\n## " << section << "\n\nThe entries are those of Rail material.\n";
          return;
        }
      out << "\n## " << (section.empty() ? "Outside all subsections" : section)
          << "\n\n| entry | default | accepted | meaning |\n| --- | --- | --- | --- |\n";
      for (const Entry &entry : entries())
        if (entry.section == section)
          out << "| " << cell(entry.name) << " | "
              << (entry.default_text.empty() ? "" : "`" + cell(entry.default_text) + "`") << " | "
              << cell(printed_range(entry)) << " | " << cell(entry.meaning) << " |\n";
      if (section == "Irregularity 1")
        out << "\nThe subsections Irregularity 2 to Irregularity " << most_irregularities
            << " have the same entries.\n";
    }

    void
    write_units(std::ostream &out)
    {
      out << "\n## Units\n\nA number that measures something carries one of these units.\n\n"
             "| value | units | example |\n| --- | --- | --- |\n";
      for (const Dimension dimension : dimensions_of_entries)
        out << "| " << dimension_name(dimension) << " | " << dimension_units(dimension) << " | `"
            << dimension_example(dimension) << "` |\n";
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


  std::string
  printed_range(const Entry &entry)
  {
    std::string text = entry.accepted;
    for (const Dimension dimension : dimensions_of_entries)
      leave_out(dimension_name(dimension) + " from ", text);
    leave_out(dimension_name(Dimension::none) + " from ", text);
    return text;
  }

  std::string
  parameter_reference()
  {
    std::ostringstream out;
    out
      << "# All entries\n\n"
         "This page is printed by `./wheelrail parameters --markdown` from the program's own table; to renew "
         "it:\n\n"
         "    ./wheelrail parameters --markdown > doc/manual/parameters.md\n\n"
         "How a file is written, and what is said of a faulty one: [input.md](input.md).\n";
    write_entries("", out);
    for (const std::string &section : section_names())
      write_entries(section, out);
    write_units(out);
    return out.str();
  }
} // namespace wheelrail
