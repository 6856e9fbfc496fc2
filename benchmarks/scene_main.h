#pragma once

#include <deal.II/base/mpi.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/input/parameters.h>

#include <iostream>
#include <string>
#include <vector>

/// A program that measures the scene of its first argument, changed by further ones as --set takes them.
/// Returns the exit code.
inline int
benchmark_scene(int argc, char **argv, void (*run)(const wheelrail::Scene &, MPI_Comm))
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc < 2)
    {
      std::cerr << "usage: " << argv[0] << " FILE.prm [\"Section/Entry = value\" ...]\n";
      return 1;
    }
  try
    {
      run(wheelrail::read_scene(argv[1], std::vector<std::string>(argv + 2, argv + argc)).scene,
          MPI_COMM_WORLD);
    }
  catch (const wheelrail::InputError &error)
    {
      std::cerr << error.what() << "\n";
      return 1;
    }
  catch (const wheelrail::RunError &error)
    {
      std::cerr << error.what() << "\n";
      return 2;
    }
  return 0;
}
