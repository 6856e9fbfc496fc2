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
