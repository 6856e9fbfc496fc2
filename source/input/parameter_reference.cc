#include <wheelrail/input/entries.h>
#include <wheelrail/input/parameter_reference.h>

#include <sstream>

namespace wheelrail
{
  namespace
  {
    /// A cell of a table: a bar would end it.
    std::string
    cell(const std::string &text)
    {
      std::string escaped;
      for (const char c : text)
        escaped += (c == '|' ? "\\" : "") + std::string(1, c);
      return escaped;
    }

    void
    write_entries(const std::string &section, std::ostream &out)
    {
      for (const Entry &entry : entries())
        if (entry.section == section && entry.repeats)
          return;
      out << "\n## " << (section.empty() ? "Outside all subsections" : section)
          << "\n\n| entry | default | accepted | meaning |\n| --- | --- | --- | --- |\n";
      for (const Entry &entry : entries())
        if (entry.section == section)
          out << "| " << cell(entry.name) << " | "
              << (entry.default_text.empty() ? "" : "`" + cell(entry.default_text) + "`") << " | "
              << cell(entry.accepted) << " | " << cell(entry.meaning) << " |\n";
      if (section == "Irregularity 1")
        out << "\nThe subsections Irregularity 2 to Irregularity " << most_irregularities
            << " have the same entries.\n";
    }

    void
    write_units(std::ostream &out)
    {
      out << "\n## Units\n\nA number that measures something carries one of these units.\n\n"
             "| value | units | example |\n| --- | --- | --- |\n";
      using D = Dimension;
      for (const D dimension : {D::length,
                                D::mass,
                                D::time,
                                D::velocity,
                                D::force,
                                D::stress,
                                D::density,
                                D::stiffness,
                                D::damping,
                                D::mass_moment,
                                D::angle})
        out << "| " << dimension_name(dimension) << " | " << dimension_units(dimension) << " | `"
            << dimension_example(dimension) << "` |\n";
    }
  } // namespace

  std::string
  parameter_reference()
  {
    std::ostringstream out;
    out
      << "# All entries\n\n"
         "This page is printed by `./wheelrail parameters --markdown` from the program's own table; to renew "
         "it:\n\n"
         "    ./wheelrail parameters --markdown > doc/manual/parameters.md\n\n"
         "How a file is written tells [input.md](input.md); what the program answers to a faulty one, "
         "[messages.md](messages.md).\n";
    write_entries("", out);
    for (const std::string &section : section_names())
      write_entries(section, out);
    write_units(out);
    return out.str();
  }
} // namespace wheelrail
