#include <wheelrail/application/command_line.h>
#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/hints.h>
#include <wheelrail/commands/command_scene.h>
#include <wheelrail/input/parameters.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace wheelrail
{
  namespace
  {
    namespace po = boost::program_options;

    const Command &
    find_command(const std::string &name)
    {
      std::vector<std::string> names;
      for (const Command &command : commands())
        {
          if (command.name == name)
            return command;
          names.push_back(command.name);
        }
      // the launcher's own
      for (const std::string own : {"test", "build"})
        {
          if (name == own)
            throw InputError(own + " is a command of the launcher wheelrail beside the sources");
          names.push_back(own);
        }
      names.push_back("help");
      throw InputError("\"" + name + "\" is no command; there are " + join_choices(names, "and") +
                       perhaps(name, names));
    }

    po::options_description
    options_of(const Command &command)
    {
      po::options_description options("options", 100);
      if (command.add_options)
        command.add_options(options);
      options.add_options()("help", "this text");
      return options;
    }

    std::string
    usage_of(const Command &command)
    {
      return "wheelrail " + command.name + (command.operand.empty() ? "" : " " + command.operand);
    }

    int
    print_help(std::ostream &out)
    {
      out << "wheelrail: how a railway wheel rolls over a rail.\n\n";
      for (const Command &command : commands())
        {
          const std::string usage = usage_of(command);
          out << "  " << usage << std::string(37 - usage.size(), ' ') << command.summary << "\n";
        }
      out << "\n\"" << own_call()
          << " COMMAND --help\" lists the options of a command.\n"
             "Exit codes: 0 finished, 1 bad input, 2 stopped, 3 interrupted and saved.\n";
      return 0;
    }

    int
    print_help(const Command &command, std::ostream &out)
    {
      out << usage_of(command) << "\n  " << command.summary << "\n\n" << options_of(command);
      return 0;
    }

    /// What is wrong with the options of a command, and what it takes.
    std::string
    option_fault(const po::error &error, const Command &command, const po::options_description &options)
    {
      std::vector<std::string> names;
      for (const auto &option : options.options())
        names.push_back("--" + option->long_name());
      using Syntax = po::invalid_command_line_syntax;
      if (const auto *unknown = dynamic_cast<const po::unknown_option *>(&error))
        return unknown->get_option_name() + " is no option; there are " + join_choices(names, "and") +
               perhaps(unknown->get_option_name(), names);
      if (dynamic_cast<const po::too_many_positional_options_error *>(&error) != nullptr)
        return command.operand.empty() ? "nothing but options can follow"
                                       : "only one " + command.operand + " can be given";
      if (const auto *several = dynamic_cast<const po::multiple_occurrences *>(&error))
        return several->get_option_name() + " is given more than once";
      if (const auto *syntax = dynamic_cast<const Syntax *>(&error))
        {
          if (syntax->kind() == Syntax::missing_parameter ||
              syntax->kind() == Syntax::empty_adjacent_parameter)
            return syntax->get_option_name() + " needs a value after it";
          if (syntax->kind() == Syntax::extra_parameter)
            return syntax->get_option_name() + " takes no value";
        }
      return error.what();
    }

    /// The option `--traction from scene` has a value of two words, which may come without quotes.
    Arguments
    with_joined_words(Arguments arguments)
    {
      for (auto word = arguments.begin(); arguments.end() - word > 2; ++word)
        if (word[0] == "--traction" && word[1] == "from" && word[2] == "scene")
          {
            word[1] = "from scene";
            arguments.erase(word + 2);
          }
      return arguments;
    }

    po::variables_map
    parse_options(const Command &command, const Arguments &arguments)
    {
      po::options_description options = options_of(command);
      po::options_description all;
      all.add(options).add_options()("file", po::value<std::string>(), "");
      po::positional_options_description positions;
      positions.add("file", command.operand.empty() ? 0 : 1);
      if (options.find_nothrow("motion", false) != nullptr)
        positions.add("motion", 1);
      try
        {
          using Style = po::command_line_style::style_t;
          // no guessing of abbreviated options
          const int         style = po::command_line_style::default_style & ~Style::allow_guessing;
          po::variables_map values;
          po::store(po::command_line_parser(with_joined_words(arguments))
                      .options(all)
                      .positional(positions)
                      .style(style)
                      .run(),
                    values);
          return values;
        }
      catch (const po::error &error)
        {
          throw InputError(command.name + ": " + option_fault(error, command, options) + "; \"" + own_call() +
                           " " + command.name + " --help\" tells more");
        }
    }
  } // namespace

  bool
  needs_mpi(const Arguments &arguments)
  {
    const auto given = [&](const char *option) {
      return std::find(arguments.begin(), arguments.end(), option) != arguments.end();
    };
    if (arguments.empty() || given("--validate") || given("--help"))
      return false;
    // MPI started without its mpirun starts a daemon of its own, which a single process has no use for
    const auto launched = [](const char *variable) { return std::getenv(variable) != nullptr; };
    return arguments.front() == "run" || arguments.front() == "receptance" ||
           (arguments.front() == "wear" && (launched("OMPI_COMM_WORLD_SIZE") || launched("PMIX_RANK") ||
                                            launched("PMI_RANK") || launched("MPI_LOCALRANKID")));
  }

  namespace
  {
    /// With the line of the scene's file that the error is about, where one is.
    std::string
    placed_in_file(const std::string &error, const po::variables_map &options)
    {
      try
        {
          if (std::filesystem::path(file_of(options)).extension() == ".prm")
            return with_place(error, file_input_of(options));
        }
      catch (const InputError &)
        {
          // the scene cannot be read, and that is the error
        }
      return error;
    }
  } // namespace


  int
  execute(const Arguments &arguments, const RunFunction &run, std::ostream &out)
  {
    const bool asks_help = !arguments.empty() && (arguments.front() == "help" ||
                                                  arguments.front() == "--help" || arguments.front() == "-h");
    if (arguments.empty() || (asks_help && arguments.size() == 1))
      return print_help(out);
    // "help run" is "run --help"
    const std::string name    = asks_help ? arguments[1] : arguments[0];
    const Command    &command = find_command(name == "--version" ? "version" : name);
    if (asks_help)
      return print_help(command, out);
    const po::variables_map options =
      parse_options(command, Arguments(arguments.begin() + 1, arguments.end()));
    if (options.count("help"))
      return print_help(command, out);
    try
      {
        return command.act(options, run, out);
      }
    catch (const InputError &error)
      {
        throw InputError(placed_in_file(error.what(), options));
      }
  }
} // namespace wheelrail
