#pragma once

#include <wheelrail/application/commands.h>

namespace wheelrail
{
  // What each command does with its options: checks what they ask for, reads the scene and hands it on. All
  // return the exit code of the program and throw InputError for what cannot be asked for, before anything is
  // computed.

  int
  act_run(const boost::program_options::variables_map &options, const RunFunction &run, std::ostream &out);

  int
  act_geometry(const boost::program_options::variables_map &options,
               const RunFunction                           &run,
               std::ostream                                &out);

  int
  act_halfspace(const boost::program_options::variables_map &options,
                const RunFunction                           &run,
                std::ostream                                &out);

  int
  act_receptance(const boost::program_options::variables_map &options,
                 const RunFunction                           &run,
                 std::ostream                                &out);

  int
  act_material(const boost::program_options::variables_map &options,
               const RunFunction                           &run,
               std::ostream                                &out);

  int
  act_vehicle(const boost::program_options::variables_map &options,
              const RunFunction                           &run,
              std::ostream                                &out);
  int
  act_wear(const boost::program_options::variables_map &options, const RunFunction &run, std::ostream &out);

  int
  act_parameters(const boost::program_options::variables_map &options,
                 const RunFunction                           &run,
                 std::ostream                                &out);

  int
  act_compare(const boost::program_options::variables_map &options,
              const RunFunction                           &run,
              std::ostream                                &out);

  int
  act_report(const boost::program_options::variables_map &options, const RunFunction &run, std::ostream &out);

  int
  act_study(const boost::program_options::variables_map &options, const RunFunction &run, std::ostream &out);
} // namespace wheelrail
