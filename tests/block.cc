// ranks: 1 2
// label: fast

// A block of cubes: exact waves, energy of central differences, equal answers on any number of ranks, and
// the reader of such scenes.

#include "error_of.h"
#include "parallel.h"
#include "scenes/block_motion.h"

#include <wheelrail/base/errors.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

using namespace scenes;
using wheelrail::ElementForm;

namespace
{
  /// Largest error of the pressed face over its largest displacement, until the reflected wave is back.
  double
  wave_error(const BlockScene &scene, const ElementForm form)
  {
    BlockMotion  block(scene, form, 0.06, MPI_COMM_WORLD);
    const double back  = 2 * (scene.high[0] - scene.low[0]) / scene.material.wave_speed();
    double       worst = 0, largest = 0;
    for (double time = scene.time_step; time < back; time += scene.time_step)
      {
        block.step();
        worst   = std::max(worst, std::abs(block.face_displacement() - exact_face(scene, time)));
        largest = exact_face(scene, time);
      }
    return worst / largest;
  }

  BOOST_FIXTURE_TEST_CASE(waves, test::Parallel)
  {
    for (const auto form : {ElementForm::reduced, ElementForm::full})
      {
        const std::string name    = form == ElementForm::full ? "full: " : "reduced: ";
        BlockScene        elastic = block_of_cubes(16, 1e-3, 1e8, 0.9, 0);
        BOOST_TEST(
          test::near(wave_error(elastic, form), 0, 0.02, name + "face under pressure, elastic wave"));
        BlockScene plastic = block_of_cubes(16, 1e-3, 1e9, 0.9, 0);
        plastic.plasticity = {280e6, 21e9, 0};
        BOOST_TEST(test::near(wave_error(plastic, form), 0, 0.03, name + "face under pressure, two waves"));
        const double ratio =
          exact_face(plastic, 1e-6) / (10 * exact_face(elastic, 1e-6)); // the plastic wave pushes more
        BOOST_TEST(ratio > 1.1, name + "the plastic face is faster than the elastic one");
      }
  }

  /// A free block that shakes at random, cell against cell. The strain energy belongs to the start of a step.
  BOOST_FIXTURE_TEST_CASE(energy_of_shaking, test::Parallel)
  {
    BlockScene  scene = block_of_cubes(6, 1e-3, 0, 0.9, 0);
    BlockMotion block(scene, ElementForm::reduced, 0, MPI_COMM_SELF);
    Solid      &solid = block.solid;
    // without the rollers
    wheelrail::TimeLoop loop(solid, {scene.time_step, 0, 0}, MPI_COMM_SELF);
    loop.prepare();
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      for (int i = 0; i < 3; ++i)
        solid.velocity[4 * n + i] = 1e-3 * (((3 * n + i) * 2654435761u >> 8) * 0x1p-23 - 1); // linear
    double worst = 0, squares = 0;
    for (int k = 0; k < 300; ++k)
      {
        const auto before = solid.velocity;
        loop.step(true);
        const auto  &energy = loop.energy();
        const double start  = energy.start();
        double       mean   = 0;
        for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
          for (int i = 0; i < 3; ++i)
            mean += 0.25 * solid.mass[n] *
                    (std::pow(before[4 * n + i], 2) + std::pow(solid.velocity[4 * n + i], 2));
        worst = std::max(worst, std::abs(energy.residual()) / start);
        squares =
          std::max(squares, std::abs(mean + energy.stored() - energy["kinetic_energy"] - start) / start);
      }
    BOOST_TEST(test::near(worst, 0, 1e-6, "a shaking block keeps its energy"));
    BOOST_TEST(squares > 0.01, "the mean of the squares would not");
  }

  /// All ranks together move as one does alone.
  BOOST_FIXTURE_TEST_CASE(ranks_agree, test::Parallel)
  {
    BlockScene scene = block_of_cubes(7, 1e-3, 1e9, 0.9, 0);
    scene.plasticity = {280e6, 21e9, 0};
    BlockMotion all(scene, ElementForm::reduced, 0.06, MPI_COMM_WORLD);
    BlockMotion one(scene, ElementForm::reduced, 0.06, MPI_COMM_SELF);
    for (int k = 0; k < 40; ++k)
      {
        all.step();
        one.step();
      }
    std::vector<double> alone(one.solid.displacement.size());
    for (unsigned int n = 0; n < one.solid.mesh.n_nodes(); ++n)
      for (int i = 0; i < 3; ++i)
        alone[4 * one.solid.mesh.node_key[n] + i] = one.solid.displacement[4 * n + i];
    double worst = 0, largest = 0;
    for (unsigned int n = 0; n < all.solid.mesh.n_nodes(); ++n)
      for (int i = 0; i < 3; ++i)
        {
          const double other = alone[4 * all.solid.mesh.node_key[n] + i];
          worst              = std::max(worst, std::abs(all.solid.displacement[4 * n + i] - other));
          largest            = std::max(largest, std::abs(other));
        }
    BOOST_TEST(test::near(worst / largest, 0, 1e-10, "ranks move the block as one rank does"));
  }

  /// Whether reading this mesh is refused with a text that names `what`.
  bool
  refused(const std::string &path, const std::string &mesh, const std::string &what)
  {
    std::ofstream(path + ".msh") << mesh;
    return test::error_of<wheelrail::InputError>([&]() { read_block(path); }).find(what) != std::string::npos;
  }

  BOOST_FIXTURE_TEST_CASE(reader, test::Parallel)
  {
    int rank;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const std::string path = "block_scene_" + std::to_string(rank);
    const std::string mesh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n5 0 0 1\n6 1 0 "
      "1\n"
      "7 0 1 1\n8 1 1 1\n$EndNodes\n$Elements\n2\n1 3 2 1 1 1 5 7 3\n2 5 2 1 1 1 2 4 3 5 6 8 "
      "7\n$EndElements\n";
    std::ofstream(path + ".msh") << mesh;
    std::ofstream(path + ".json") << R"({"E": 2e11, "nu": 0.25, "rho": 8000, "sigma_y": 3e8, "E_t": 2e10,
      "material": "plastic", "pressure": 5e8, "dt": 1e-7, "steps": 200.00000000000003})";
    const BlockScene scene = read_block(path);
    BOOST_TEST((scene.mesh.cells.size() == 1 && scene.mesh.n_nodes() == 8), "one hexahedron is read");
    bool lexicographic = true;
    for (unsigned int a = 0; a < 8; ++a)
      lexicographic = lexicographic && scene.mesh.cells[0][a] == a;
    BOOST_TEST(lexicographic, "its corners are in lexicographic order");
    BOOST_TEST((scene.steps == 200 && scene.plasticity.yield_stress == 3e8 && scene.material.density == 8000),
               "its figures are read");
    BOOST_TEST(refused(path, mesh.substr(0, 60), "block_scene"), "a mesh that ends early is refused");
    BOOST_TEST(refused(path, "$Elements\n", "$Nodes"), "a mesh without nodes is refused");
    std::string other = mesh;
    other.replace(other.find("1 3 2 1 1"), 9, "1 2 2 1 1");
    BOOST_TEST(refused(path, other, "kind 2"), "triangles are refused");
  }
} // namespace
