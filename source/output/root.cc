#include <wheelrail/base/errors.h>
#include <wheelrail/output/root.h>

#include <string>

namespace wheelrail
{
  namespace
  {
    enum Outcome : int
    {
      good,
      bad_input,
      bad_run
    };

    Outcome
    attempt(const std::function<void()> &work, std::string &message)
    {
      try
        {
          work();
          return good;
        }
      catch (const InputError &error)
        {
          message = error.what();
          return bad_input;
        }
      catch (const std::exception &error)
        {
          message = error.what();
          return bad_run;
        }
    }
  } // namespace

  void
  on_root(MPI_Comm comm, const std::function<void()> &work)
  {
    int initialized = 0;
    MPI_Initialized(&initialized);
    if (!initialized)
      return work();

    int rank = 0;
    MPI_Comm_rank(comm, &rank);
    std::string message;
    int         header[2] = {good, 0};
    if (rank == 0)
      {
        header[0] = attempt(work, message);
        header[1] = static_cast<int>(message.size());
      }
    MPI_Bcast(header, 2, MPI_INT, 0, comm);
    message.resize(header[1]);
    MPI_Bcast(&message[0], header[1], MPI_CHAR, 0, comm);

    if (header[0] == bad_input)
      throw InputError(message);
    if (header[0] == bad_run)
      throw RunError(message);
  }
} // namespace wheelrail
