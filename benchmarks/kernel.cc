// Speed of the element kernel alone: internal forces of a block of n^3 cubes, elastic, one thread.

#include <wheelrail/solid/kernel.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

using namespace wheelrail;

int
main()
{
  std::printf("%10s %6s %14s %12s %12s\n", "elements", "width", "M updates/s", "ns/update", "bytes/update");
  for (const unsigned int n : {31u, 46u, 65u})
    for (const int width : {1, 4, 8})
      {
        std::vector<ElementGeometry>             geometry;
        std::vector<std::array<unsigned int, 8>> cells;
        const double                             h = 1e-3;
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i < n; ++i)
              {
                std::array<unsigned int, 8>          cell;
                std::array<std::array<double, 3>, 8> X;
                for (unsigned int a = 0; a < 8; ++a)
                  {
                    const unsigned int x = i + (a & 1), y = j + (a >> 1 & 1), z = k + (a >> 2);
                    cell[a] = x + (n + 1) * (y + (n + 1) * z);
                    X[a]    = {x * h, y * h, z * h};
                  }
                cells.push_back(cell);
                geometry.push_back(element_geometry(X));
              }
        ElementBlocks         blocks = pack_elements(geometry, cells, Elasticity(), width);
        const std::size_t     nodes  = (n + 1) * (n + 1) * (n + 1);
        AlignedVector<double> u(4 * nodes, 0.), f(4 * nodes, 0.);
        for (std::size_t k = 0; k < u.size(); ++k)
          u[k] = 1e-9 * ((k * 2654435761u) % 1000);
        BulkViscosity       viscosity{0.06, 1e-7};
        ElementEnergy       energy;
        const int           repeat = 3000000 / cells.size();
        std::vector<double> times;
        for (int sample = 0; sample < 7; ++sample)
          {
            const auto start = std::chrono::steady_clock::now();
            for (int r = 0; r < repeat; ++r)
              subtract_internal_force(blocks, u.data(), f.data(), viscosity, false, energy);
            times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
          }
        std::sort(times.begin(), times.end());
        const double ns = times[times.size() / 2] / (double(repeat) * cells.size()) * 1e9;
        std::printf("%10zu %6d %14.2f %12.1f %12zu\n",
                    cells.size(),
                    width,
                    1e3 / ns,
                    ns,
                    ElementBlocks::fields * sizeof(double) + 32 + 16 + 3 * 32);
      }
}
