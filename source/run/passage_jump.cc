#include <wheelrail/output/figure_table.h>
#include <wheelrail/run/passage_jump.h>
#include <wheelrail/tables/table.h>

#include <cmath>
#include <filesystem>

namespace wheelrail
{
  namespace
  {
    const char *const jump_keys[] =
      {"from", "to", "growth", "rate", "computed_rate", "error", "judged", "kept"};
  } // namespace


  double
  jump_factor(const double rate, const unsigned int n)
  {
    double sum = 0, power = 1;
    for (unsigned int k = 0; k < n; ++k)
      sum += power *= rate;
    return sum;
  }


  unsigned int
  jump_length(const JumpBasis &basis, unsigned int most, const double error)
  {
    for (; most >= 2; most /= 2)
      {
        const double uncertain =
          basis.growth * (jump_factor(basis.rate, most) - jump_factor(basis.before, most));
        if (std::abs(uncertain) <= error * basis.strain)
          return most;
      }
    return 0;
  }


  void
  judge_jump(PassageJump       &jump,
             const unsigned int n,
             const double       growth,
             const double       strain,
             const double       error)
  {
    jump.computed_rate = jump.growth > 0 && growth > 0 ? std::pow(growth / jump.growth, 1. / (n + 2)) : 0;
    jump.error =
      std::abs(jump.growth * (jump_factor(jump.computed_rate, n) - jump_factor(jump.rate, n))) / strain;
    jump.judged = true;
    jump.kept   = jump.error <= error;
  }


  void
  write_jumps(const std::vector<PassageJump> &jumps, const std::string &folder)
  {
    FigureTable table;
    for (const char *const key : jump_keys)
      table.add(key, "1", {});
    for (const PassageJump &jump : jumps)
      table.add_row({double(jump.from),
                     double(jump.to),
                     jump.growth,
                     jump.rate,
                     jump.computed_rate,
                     jump.error,
                     double(jump.judged),
                     double(jump.kept)});
    table.write_csv(folder + "/jumps.csv");
  }


  std::vector<PassageJump>
  read_jumps(const std::string &folder)
  {
    const std::string        path = folder + "/jumps.csv";
    std::vector<PassageJump> jumps;
    if (!std::filesystem::exists(path))
      return jumps;
    std::vector<TableColumn> known;
    for (const char *const key : jump_keys)
      known.push_back({key, Dimension::none, -1e300, 1e300, "a number", true});
    const Table table = read_table(path, known, {"the jumps of a run over passages are needed"});
    for (std::size_t row = 0; row < table.lines.size(); ++row)
      {
        const auto at = [&](const std::size_t key) { return (*table.find(key))[row]; };
        jumps.push_back({static_cast<unsigned int>(at(0)),
                         static_cast<unsigned int>(at(1)),
                         at(2),
                         at(3),
                         at(4),
                         at(5),
                         at(6) != 0,
                         at(7) != 0});
      }
    return jumps;
  }
} // namespace wheelrail
