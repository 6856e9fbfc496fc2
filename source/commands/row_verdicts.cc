#include <wheelrail/commands/row_verdicts.h>

#include <cstddef>

namespace wheelrail
{
  void
  print_row_verdicts(const std::vector<RowVerdict> &rows,
                     const std::string             &what,
                     const std::string             &column,
                     std::ostream                  &out)
  {
    constexpr std::size_t    most_reasons = 5;
    std::size_t              of_grade[3]  = {0, 0, 0};
    std::vector<std::string> why;
    for (const RowVerdict &row : rows)
      {
        ++of_grade[static_cast<int>(row.grade)];
        if (!row.doubts.empty())
          why.push_back(row.where + ": " + row.doubts);
      }
    out << "verdict: " << of_grade[2] << ' ' << what << " trusted, " << of_grade[1] << " with care, "
        << of_grade[0] << " not trusted\n";
    for (std::size_t k = 0; k < why.size() && k < most_reasons; ++k)
      out << why[k] << '\n';
    if (why.size() > most_reasons)
      out << "and " << why.size() - most_reasons << " more; the column " << column
          << " has 1 (with care) or 0 there\n";
  }
} // namespace wheelrail
