#pragma once

#include <wheelrail/base/body.h>

#include <cstdint>

namespace wheelrail
{
  /// Where a cell lies in its body: its coarse block in the section, its level, and its place among the
  /// cells of this level, within the block (i, j) and along the whole body (k).
  struct CellPlace
  {
    Body           body  = Body::rail;
    unsigned char  level = 0;
    int            block = 0;
    unsigned short i = 0, j = 0;
    int            k = 0;

    /// Unique over both bodies and all levels: what a cell is known by from mesh to mesh and from rank to
    /// rank.
    std::uint64_t
    key() const
    {
      std::uint64_t key = static_cast<std::uint64_t>(body);
      key               = key << 4 | level;
      key               = key << 20 | static_cast<std::uint64_t>(block);
      key               = key << 9 | i;
      key               = key << 9 | j;
      return key << 20 | static_cast<std::uint64_t>(k);
    }

    static CellPlace
    of_key(const std::uint64_t key)
    {
      const auto bits = [key](const int from, const int n) {
        return static_cast<int>(key >> from & ((std::uint64_t(1) << n) - 1));
      };
      CellPlace cell;
      cell.body  = static_cast<Body>(bits(62, 1));
      cell.level = static_cast<unsigned char>(bits(58, 4));
      cell.block = bits(38, 20);
      cell.i     = static_cast<unsigned short>(bits(29, 9));
      cell.j     = static_cast<unsigned short>(bits(20, 9));
      cell.k     = bits(0, 20);
      return cell;
    }

    CellPlace
    child(const unsigned int n) const
    {
      CellPlace cell = *this;
      ++cell.level;
      cell.i = static_cast<unsigned short>(2 * i + (n & 1));
      cell.j = static_cast<unsigned short>(2 * j + (n >> 1 & 1));
      cell.k = 2 * k + static_cast<int>(n >> 2);
      return cell;
    }

    /// The cell of a lower level that holds it.
    CellPlace
    ancestor(const unsigned char lower) const
    {
      CellPlace cell = *this;
      cell.level     = lower;
      cell.i         = static_cast<unsigned short>(i >> (level - lower));
      cell.j         = static_cast<unsigned short>(j >> (level - lower));
      cell.k         = k >> (level - lower);
      return cell;
    }
  };
} // namespace wheelrail
