#pragma once

// Tables of tests/reference: comma-separated, comments start with #, the first line holds names.

#include "near.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace test
{
  /// Rows of cells of a table in tests/reference, without comments and column names.
  inline std::vector<std::vector<std::string>>
  read_table(const std::string &file)
  {
    std::ifstream in(std::filesystem::path(__FILE__).parent_path() / "reference" / file);
    BOOST_TEST(in.good(), "tests/reference/" + file + " can be read");
    std::vector<std::vector<std::string>> rows;
    for (std::string text; std::getline(in, text);)
      {
        if (text.empty() || text[0] == '#')
          continue;
        std::vector<std::string> row;
        std::istringstream       cells(text);
        for (std::string cell; std::getline(cells, cell, ',');)
          row.push_back(cell);
        rows.push_back(row);
      }
    if (!rows.empty())
      rows.erase(rows.begin()); // column names
    return rows;
  }
} // namespace test
