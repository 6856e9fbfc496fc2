#pragma once

#include <wheelrail/application/commands.h>

namespace wheelrail
{
  // What each command does with its options: checks what they ask for, reads the scene and hands it on. All
  // return the exit code of the program and throw InputError for what cannot be asked for, before anything is
  // computed.

  int
  act_run(const po::variables_map &options, const RunFunction &run, std::ostream &out);

  int
  act_geometry(const po::variables_map &options, const RunFunction &run, std::ostream &out);

  int
  act_halfspace(const po::variables_map &options, const RunFunction &run, std::ostream &out);

  int
  act_material(const po::variables_map &options, const RunFunction &run, std::ostream &out);

  int
  act_contact(const po::variables_map &options, const RunFunction &run, std::ostream &out);

  int
  act_parameters(const po::variables_map &options, const RunFunction &run, std::ostream &out);

  int
  act_compare(const po::variables_map &options, const RunFunction &run, std::ostream &out);

  int
  act_report(const po::variables_map &options, const RunFunction &run, std::ostream &out);

  int
  act_study(const po::variables_map &options, const RunFunction &run, std::ostream &out);
} // namespace wheelrail
