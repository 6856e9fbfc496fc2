// Speed of the element kernels alone: internal forces of a block of n^3 cubes, one thread. Elastic;
// bilinear and with Chaboche's three back stresses, with no cell, and with every cell in plastic flow. Both
// elements, three SIMD widths in turns. Arguments: n of the blocks, 31 46 65 without.

#include <wheelrail/solid/kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace wheelrail;

namespace
{
  enum class Case
  {
    elastic,
    no_yield,
    all_yield,
    cyclic_no_yield,
    cyclic_all_yield
  };

  MaterialLaw
  law_of(const Case kind)
  {
    if (kind == Case::elastic)
      return ElasticLaw();
    const double yield = kind == Case::no_yield || kind == Case::cyclic_no_yield ? 1e12 : 100e6;
    if (kind == Case::no_yield || kind == Case::all_yield)
      return BilinearLaw(Elasticity(), {yield, 21e9, 1});
    CyclicHardening hardening;
    hardening.yield_stress   = yield;
    hardening.isotropic      = 50e6;
    hardening.isotropic_rate = 10;
    hardening.moduli         = {100e9, 20e9, 4e9};
    hardening.rates          = {1000, 200, 10};
    return ChabocheLaw(Elasticity(), hardening);
  }

  /// CPU time of this process [s].
  double
  cpu_seconds()
  {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
  }

  struct Block
  {
    std::vector<ElementGeometry>             geometry;
    std::vector<std::array<unsigned int, 8>> cells;
    std::size_t                              n_nodes;
  };

  Block
  cubes(const unsigned int n)
  {
    Block        block;
    const double h = 1e-3;
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
            block.cells.push_back(cell);
            block.geometry.push_back(element_geometry(X));
          }
    block.n_nodes = (n + 1) * (n + 1) * (n + 1);
    return block;
  }

  constexpr std::array<int, 3> widths = {1, 4, 8};

  /// What the kernel works on with one SIMD width.
  struct Run
  {
    ElementBlocks       blocks;
    std::vector<double> times; ///< of each sample [s]
    int                 calls = 0;
  };

  /// Displacements with strains of some thousandths, whose direction goes round with the phase: a step of
  /// 0.01 strains by some hundred-thousandths, as time steps of a passage do, and what yields flows in every
  /// step.
  void
  turn(const double phase, AlignedVector<double> &u)
  {
    const double c = 1e-9 * std::cos(phase), s = 1e-9 * std::sin(phase);
    for (std::size_t k = 0; k < u.size(); ++k)
      u[k] = c * double((k * 2654435761u) % 1000) + s * double((k * 2246822519u + 7) % 1000);
  }

  /// Median times of one update [ns], one for each width. The widths take turns, so that what else the
  /// machine does hits all of them.
  std::array<double, widths.size()>
  nanoseconds(const Block &block, const Case kind, const ElementForm form)
  {
    std::array<Run, widths.size()> runs;
    for (std::size_t w = 0; w < widths.size(); ++w)
      {
        runs[w].blocks = pack_elements(block.geometry, block.cells, law_of(kind), widths[w], form);
      }
    AlignedVector<double> u(4 * block.n_nodes, 0.), f(u);
    const BulkViscosity   viscosity{0.06, 1e-7};
    ElementEnergy         energy;
    const int             repeat = std::max<int>(1, 300000 / block.cells.size());
    for (int sample = 0; sample < 11; ++sample)
      for (Run &run : runs)
        {
          double taken = 0;
          for (int r = 0; r < repeat; ++r)
            {
              turn(1e-2 * run.calls++, u);
              const double start = cpu_seconds();
              subtract_internal_force(run.blocks, u.data(), f.data(), viscosity, false, energy);
              taken += cpu_seconds() - start;
            }
          run.times.push_back(taken);
        }
    std::array<double, widths.size()> result;
    for (std::size_t w = 0; w < widths.size(); ++w)
      {
        auto &times = runs[w].times;
        std::sort(times.begin(), times.end());
        result[w] = times[times.size() / 2] / (double(repeat) * block.cells.size()) * 1e9;
      }
    return result;
  }

  /// Bytes that one update moves when nothing stays in the caches but the nodes: geometry, node numbers,
  /// dilatation in and out, and about one node in and out; history and plastic work in and out where
  /// cells flow.
  std::size_t
  bytes(const ElementBlocks &blocks, const Case kind)
  {
    std::size_t sum = blocks.rows * sizeof(double) + 32 + 16 + 3 * 32;
    if (kind == Case::all_yield || kind == Case::cyclic_all_yield)
      sum += 2 * (blocks.history_rows() + 1) * sizeof(double);
    return sum;
  }

  /// One line of the table for each width.
  void
  measure(const Block &block, const Case kind, const ElementForm form)
  {
    const char *names[] = {
      "elastic", "bilinear, no yield", "bilinear, all yield", "Chaboche, no yield", "Chaboche, all yield"};
    const auto ns = nanoseconds(block, kind, form);
    for (std::size_t w = 0; w < widths.size(); ++w)
      {
        const ElementBlocks one =
          pack_elements({block.geometry[0]}, {block.cells[0]}, law_of(kind), widths[w], form);
        std::printf("%10zu %6d %9s %20s %13.2f %11.1f %14zu\n",
                    block.cells.size(),
                    widths[w],
                    form == ElementForm::full ? "full" : "reduced",
                    names[static_cast<int>(kind)],
                    1e3 / ns[w],
                    ns[w],
                    bytes(one, kind));
        std::fflush(stdout);
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  std::vector<unsigned int> edges;
  for (int k = 1; k < argc; ++k)
    edges.push_back(std::atoi(argv[k]));
  if (edges.empty())
    edges = {31, 46, 65};
  std::printf("%10s %6s %9s %20s %13s %11s %14s\n",
              "elements",
              "width",
              "element",
              "material",
              "M updates/s",
              "ns/update",
              "bytes/update");
  for (const unsigned int n : edges)
    {
      const Block block = cubes(n);
      for (const ElementForm form : {ElementForm::reduced, ElementForm::full})
        for (const Case kind :
             {Case::elastic, Case::no_yield, Case::all_yield, Case::cyclic_no_yield, Case::cyclic_all_yield})
          measure(block, kind, form);
    }
}
