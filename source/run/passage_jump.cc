#include <wheelrail/base/read_file.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/run/passage_jump.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace wheelrail
{
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
    for (const char *key : {"from", "to", "growth", "rate", "computed_rate", "error", "judged", "kept"})
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
    std::istringstream text(read_whole_file(path));
    std::string        line;
    std::getline(text, line); // names
    while (std::getline(text, line))
      {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream row(line);
        PassageJump        jump;
        if (row >> jump.from >> jump.to >> jump.growth >> jump.rate >> jump.computed_rate >> jump.error >>
            jump.judged >> jump.kept)
          jumps.push_back(jump);
      }
    return jumps;
  }
} // namespace wheelrail
