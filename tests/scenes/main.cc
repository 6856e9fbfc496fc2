// The main() of the tests: those of the file that the program is called by, test_NAME, or all that it has.

#define BOOST_TEST_ALTERNATIVE_INIT_API
#define BOOST_TEST_NO_MAIN
#include <deal.II/base/mpi.h>

#include <boost/test/included/unit_test.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "../parallel.h"

namespace
{
  std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> mpi;

  /// Ends all ranks, after the log has said why.
  struct EndOfAllRanks : boost::unit_test::test_observer
  {
    void
    test_unit_aborted(const boost::unit_test::test_unit &) override
    {
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
    int
    priority() override
    {
      return 10;
    }
  } end_of_all_ranks;
} // namespace


test::Parallel::Parallel()
{
  if (!mpi)
    {
      auto &all = boost::unit_test::framework::master_test_suite();
      mpi       = std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(all.argc, all.argv, 1);
      if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
        boost::unit_test::framework::register_observer(end_of_all_ranks);
    }
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
}


int
main(int argc, char **argv)
{
  // a crash shall end the program, and programs that a test calls may end with other codes than 0
  std::vector<std::string> words = {argv[0], "--catch_system_errors=no", "--color_output=no"};
  const std::string        path = argv[0], name = path.substr(path.rfind('/') + 1);
  words.insert(words.end(), argv + 1, argv + argc);
  const bool chosen = std::any_of(words.begin(), words.end(), [](const std::string &word) {
    return word.rfind("--run_test", 0) == 0 || word.rfind("-t", 0) == 0;
  });
  if (!chosen &&
      boost::unit_test::framework::master_test_suite().get(name) != boost::unit_test::INV_TEST_UNIT_ID)
    words.insert(words.begin() + 1, "--run_test=" + name);
  std::vector<char *> pointers;
  for (std::string &word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const int result =
    boost::unit_test::unit_test_main([]() { return true; }, static_cast<int>(words.size()), pointers.data());
  mpi.reset();
  return result;
}
