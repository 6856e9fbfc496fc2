#include <wheelrail/application/command_line.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/log.h>
#include <wheelrail/run/run_scene.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <chrono>
#include <functional>
#include <iostream>
#include <new>
#include <sstream>
#include <thread>

#include <unistd.h>

namespace
{
  using namespace wheelrail;

  enum ExitCode
  {
    finished    = 0,
    bad_input   = 1,
    stopped     = 2,
    interrupted = 3
  };

  struct Failure
  {
    int         code = finished;
    std::string text;
  };

  /// Runs `work`; an exception becomes its exit code and its text, without any stack trace.
  Failure
  guarded(const std::function<int()> &work)
  {
    try
      {
        return {work(), ""};
      }
    catch (const InputError &error)
      {
        return {bad_input, error.what()};
      }
    catch (const RunError &error)
      {
        return {stopped, error.what()};
      }
    catch (const Interrupted &left)
      {
        const std::string kept = left.what();
        return {interrupted,
                "interrupted; " + (kept.empty() ? "nothing is kept: the same command starts anew" : kept)};
      }
    catch (const std::bad_alloc &)
      {
        return {stopped, "out of memory: take larger cells, a shorter rail, or a machine with more memory"};
      }
    catch (const dealii::ExceptionBase &error)
      {
        std::ostringstream text;
        error.print_info(text);
        return {stopped, std::string("a fault in the program (") + error.get_exc_name() + "): " + text.str()};
      }
    catch (const std::exception &error)
      {
        return {stopped, std::string("a fault in the program: ") + error.what()};
      }
  }

  void
  print_failure(const Failure &failure)
  {
    std::istringstream lines(failure.text);
    for (std::string line; std::getline(lines, line);)
      print(STDERR_FILENO,
            (failure.code == interrupted || line.empty() || line[0] == ' ' ? "" : "error: ") + line + "\n");
  }

  /// Whether all ranks get here within a few seconds. One that failed alone would leave the others
  /// waiting for it for ever.
  bool
  all_arrive(MPI_Comm comm)
  {
    MPI_Request request;
    int         done = 0;
    MPI_Ibarrier(comm, &request);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (MPI_Test(&request, &done, MPI_STATUS_IGNORE), !done && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return done;
  }

  int
  run_in_parallel(int argc, char **argv, const Arguments &arguments)
  {
    dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    catch_interrupts(); // MPI has put SIGTERM back to what ends the process
    // its own communicator: a failed rank's barrier must not meet other pending messages
    MPI_Comm comm;
    MPI_Comm_dup(MPI_COMM_WORLD, &comm);
    const bool    is_root = dealii::Utilities::MPI::this_mpi_process(comm) == 0;
    const Failure failure = guarded([&]() { return execute(arguments, run_scene, std::cout); });
    if (!failure.text.empty() && !all_arrive(comm))
      {
        print_failure(failure);
        MPI_Abort(comm, failure.code);
      }
    if (is_root)
      print_failure(failure);
    MPI_Comm_free(&comm);
    return failure.code;
  }
} // namespace

int
main(int argc, char **argv)
{
  const Arguments arguments(argv + 1, argv + argc);
  catch_interrupts();
  if (needs_mpi(arguments))
    return run_in_parallel(argc, argv, arguments);
  const Failure failure = guarded([&]() { return execute(arguments, run_scene, std::cout); });
  print_failure(failure);
  return failure.code;
}
