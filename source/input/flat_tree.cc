#include <wheelrail/base/format_text.h>
#include <wheelrail/base/hints.h>
#include <wheelrail/input/flat_input.h>

#include <boost/algorithm/string/trim.hpp>
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

namespace wheelrail
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    /// A name as ParameterHandler writes it in XML, Fine_20depth: other signs than letters and digits as two
    /// hexadecimal ones.
    std::string
    demangled(const std::string &name)
    {
      std::string text;
      for (std::size_t i = 0; i < name.size(); ++i)
        if (name[i] == '_' && i + 2 < name.size() && std::isxdigit(static_cast<unsigned char>(name[i + 1])) &&
            std::isxdigit(static_cast<unsigned char>(name[i + 2])))
          {
            text += static_cast<char>(std::stoi(name.substr(i + 1, 2), nullptr, 16));
            i += 2;
          }
        else
          text += name[i];
      return text;
    }

    /// Whether a hundred brackets or elements stand in each other: the parsers call themselves for each.
    bool
    is_too_deep(const std::string &text, const bool is_xml)
    {
      int depth = 0;
      for (std::size_t i = 0; i < text.size() && depth < 100; ++i)
        {
          const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : ' ';
          if (!is_xml)
            depth += (c == '{' || c == '[') - (c == '}' || c == ']');
          else if (c == '<' && next != '?' && next != '!')
            depth += next == '/' ? -1 : 1;
          else
            depth -= c == '/' && next == '>';
        }
      return depth >= 100;
    }

    /// Adds what stands in `tree`, the subsection `section` or all (an empty name), of the file `name`.
    void
    read_tree(const Tree &tree, const std::string &section, const std::string &name, FlatInput &input)
    {
      std::set<std::string> names;
      for (const auto &[key, node] : tree)
        {
          // the file has no lines that are told; an order it has
          const Place       place{name, input.assignments.size() + input.sections.size()};
          const std::string entry = demangled(key);
          const auto        value = node.get_optional<std::string>("value");
          if (!node.empty() && !value)
            {
              const std::string inner = section.empty() ? entry : section + "/" + entry;
              input.sections.push_back({inner, place});
              input.text += "subsection " + entry + "\n";
              read_tree(node, inner, name, input);
              input.text += "end\n";
              continue;
            }
          Assignment one{section, entry, boost::trim_copy(value ? *value : node.data()), place, "", ""};
          const auto is_none_of_a_line = [](const char c) { return c == '#' || (c >= 0 && c < ' '); };
          if (std::any_of(one.value.begin(), one.value.end(), is_none_of_a_line))
            input.problems.push_back({name + ": " + shown_text(one.path()) + " = " + shown_text(one.value) +
                                        ": a value is one line without #",
                                      place.order});
          one.value = found_files(one, one.value, name);
          if (!names.insert(entry).second)
            one.before = name;
          input.text += (section.empty() ? "set " : "  set ") + one.name + " = " + one.value + "\n";
          input.assignments.push_back(one);
        }
    }
  } // namespace


  FlatInput
  flatten_tree(const std::string &text, const std::string &name, const bool is_xml)
  {
    namespace pt             = boost::property_tree;
    const std::string advice = std::string("; \"") + own_call() + " parameters --" +
                               (is_xml ? "xml" : "json") + "\" prints a complete file";
    FlatInput          input;
    std::istringstream in(text);
    Tree               tree;
    if (is_too_deep(text, is_xml))
      {
        input.problems.push_back({name + ": subsections in each other" + advice, 0});
        return input;
      }
    try
      {
        if (is_xml)
          pt::read_xml(in, tree, pt::xml_parser::no_comments | pt::xml_parser::trim_whitespace);
        else
          pt::read_json(in, tree);
        read_tree(is_xml ? tree.get_child("ParameterHandler") : tree, "", name, input);
      }
    catch (const pt::file_parser_error &error)
      {
        input.problems.push_back(
          {name + ":" + std::to_string(error.line()) + ": " + error.message() + advice, 0});
      }
    catch (const pt::ptree_bad_path &)
      {
        input.problems.push_back({name + ": no <ParameterHandler> with the entries in it" + advice, 0});
      }
    return input;
  }
} // namespace wheelrail
