#include "block_motion.h"
#include "make_solid.h"

#include "rank_part.h"

#include <wheelrail/base/errors.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <fstream>
#include <vector>

namespace scenes
{
  using namespace wheelrail;

  namespace
  {
    /// CPU time of this process [s].
    double
    cpu_seconds()
    {
      timespec t;
      clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
      return t.tv_sec + 1e-9 * t.tv_nsec;
    }

    void
    complete(BlockScene &scene)
    {
      LocalMesh &mesh = scene.mesh;
      mesh.global_node.resize(mesh.reference.size() / 4);
      mesh.node_body.assign(mesh.n_nodes(), Body::rail);
      mesh.cell_body.assign(mesh.cells.size(), Body::rail);
      mesh.cell_level.assign(mesh.cells.size(), 0);
      mesh.hanging_begin = {0};
      for (int i = 0; i < 3; ++i)
        {
          scene.low[i] = 1e300, scene.high[i] = -1e300;
          for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
            {
              scene.low[i]  = std::min(scene.low[i], mesh.reference[4 * n + i]);
              scene.high[i] = std::max(scene.high[i], mesh.reference[4 * n + i]);
            }
        }
    }

    /// Reads up to the line given.
    void
    find_line(std::istream &in, const std::string &wanted, const std::string &path)
    {
      for (std::string line; std::getline(in, line);)
        if (line == wanted)
          return;
      throw InputError(path + " has no line " + wanted + "; a mesh in gmsh's format 2.2 (text) is accepted.");
    }

    LocalMesh
    read_mesh(const std::string &path)
    {
      std::ifstream in(path);
      if (!in)
        throw InputError("The mesh " + path + " cannot be read.");
      LocalMesh   mesh;
      std::size_t n;
      find_line(in, "$Nodes", path);
      in >> n;
      for (std::size_t k = 0; k < n; ++k)
        {
          std::size_t number;
          Vector3     X;
          in >> number >> X[0] >> X[1] >> X[2];
          if (!in || number != k + 1)
            throw InputError(path + ": node " + std::to_string(k + 1) +
                             " is missing; nodes are numbered 1, 2, ... in this order.");
          mesh.reference.insert(mesh.reference.end(), {X[0], X[1], X[2], 0.});
        }
      find_line(in, "$Elements", path);
      in >> n;
      for (std::size_t k = 0; k < n; ++k)
        {
          std::size_t                 number, kind, n_tags;
          std::array<unsigned int, 8> cell;
          in >> number >> kind >> n_tags;
          for (std::size_t ignored; in && n_tags > 0; --n_tags)
            in >> ignored;
          if (kind != 3 && kind != 5)
            throw InputError(path + ": element " + std::to_string(k + 1) + " has the kind " +
                             std::to_string(kind) + "; quadrilaterals (3) and hexahedra (5) are accepted.");
          const int corners = kind == 5 ? 8 : 4;
          for (int a = 0; a < corners; ++a)
            in >> cell[a];
          if (!in)
            throw InputError(path + " ends within element " + std::to_string(k + 1) + ".");
          if (kind == 5)
            {
              std::swap(cell[2], cell[3]); // gmsh goes around each of the two faces
              std::swap(cell[6], cell[7]);
              for (unsigned int &node : cell)
                --node;
              mesh.cells.push_back(cell);
            }
        }
      return mesh;
    }
  } // namespace


  BlockScene
  block_of_cubes(const unsigned int  n,
                 const double        h,
                 const double        pressure,
                 const double        factor,
                 const unsigned long steps)
  {
    BlockScene         scene;
    const unsigned int m = n + 1;
    for (unsigned int k = 0; k < m; ++k)
      for (unsigned int j = 0; j < m; ++j)
        for (unsigned int i = 0; i < m; ++i)
          scene.mesh.reference.insert(scene.mesh.reference.end(), {h * i, h * j, h * k, 0.});
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            std::array<unsigned int, 8> cell;
            for (unsigned int a = 0; a < 8; ++a)
              cell[a] = i + (a & 1) + m * (j + (a >> 1 & 1) + m * (k + (a >> 2)));
            scene.mesh.cells.push_back(cell);
          }
    complete(scene);
    scene.pressure  = pressure;
    scene.time_step = factor * h / scene.material.wave_speed();
    scene.steps     = steps;
    return scene;
  }


  BlockScene
  read_block(const std::string &path)
  {
    BlockScene scene;
    scene.mesh = read_mesh(path + ".msh");
    std::ifstream in(path + ".json");
    try
      {
        const auto figures            = nlohmann::json::parse(in);
        scene.material.youngs_modulus = figures.at("E");
        scene.material.poissons_ratio = figures.at("nu");
        scene.material.density        = figures.at("rho");
        scene.pressure                = figures.at("pressure");
        scene.time_step               = figures.at("dt");
        scene.steps                   = std::lround(figures.at("steps").get<double>());
        if (figures.at("material") == "plastic")
          scene.plasticity = {figures.at("sigma_y"), figures.at("E_t"), 0.};
      }
    catch (const nlohmann::json::exception &problem)
      {
        throw InputError(path + ".json cannot be used: " + problem.what() + ".");
      }
    complete(scene);
    return scene;
  }


  double
  exact_face(const BlockScene &scene, const double t)
  {
    const Elasticity &steel = scene.material;
    const double      c = steel.wave_speed(), length = scene.high[0] - scene.low[0];
    const double      lambda = steel.lame_lambda(), mu = steel.shear_modulus();
    // von Mises' stress is 2 mu / (lambda + 2 mu) of the stress along the axis
    const double limit = scene.plasticity.yield_stress * (lambda + 2 * mu) / (2 * mu);
    if (scene.pressure <= limit)
      {
        const double period = 4 * length / c, phase = std::fmod(t, period);
        return scene.pressure / (steel.density * c) * std::min(phase, period - phase);
      }
    const double tangent = BilinearLaw(steel, scene.plasticity).tangent_ratio * mu;
    const double slow    = std::sqrt((lambda + 2. / 3 * mu + 4. / 3 * tangent) / steel.density);
    return (limit / c + (scene.pressure - limit) / slow) / steel.density * t;
  }


  void
  BlockBoundary::prepare(const Solid &solid, std::vector<NodeInertia> &)
  {
    const double near = 1e-6 * (scene_.high[0] - scene_.low[0]),
                 area = (scene_.high[1] - scene_.low[1]) * (scene_.high[2] - scene_.low[2]);
    double mass       = 0;
    face_.clear();
    held_.clear();
    load_.clear();
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      {
        const double *X = &solid.mesh.reference[4 * n];
        for (int i = 0; i < 3; ++i)
          if ((i > 0 && X[i] < scene_.low[i] + near) || X[i] > scene_.high[i] - near)
            held_.push_back(4 * n + i);
        if (X[0] < scene_.low[0] + near && solid.mesh.owns(n))
          {
            face_.push_back(n);
            mass += solid.mass[n];
          }
      }
    // equal cells: a node's share of the face is that of its mass
    MPI_Allreduce(MPI_IN_PLACE, &mass, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    for (const unsigned int n : face_)
      load_.push_back(scene_.pressure * area * solid.mass[n] / mass);
  }


  void
  BlockBoundary::add_shares(const Instant &, Solid &solid)
  {
    for (std::size_t k = 0; k < face_.size(); ++k)
      solid.force[4 * face_[k]] += load_[k];
  }


  void
  BlockBoundary::constrain(const Instant &, Solid &solid, const std::vector<NodeInertia> &)
  {
    for (const std::size_t k : held_)
      solid.force[k] = 0;
  }


  BlockMotion::BlockMotion(const BlockScene &scene,
                           const ElementForm form,
                           const double      bulk_viscosity,
                           MPI_Comm          communicator)
    : solid(make_solid(rank_part(scene.mesh, communicator),
                       material_law(scene.material, scene.plasticity),
                       material_law(scene.material, scene.plasticity),
                       bulk_viscosity,
                       communicator,
                       {form, form}))
    , boundary(scene, communicator)
    , loop(solid, {scene.time_step, bulk_viscosity, 0}, communicator)
    , communicator_(communicator)
  {
    loop.clock = cpu_seconds;
    loop.add(boundary);
    loop.prepare();
  }


  double
  BlockMotion::face_displacement() const
  {
    double sums[2] = {0, double(boundary.face().size())};
    for (const unsigned int n : boundary.face())
      sums[0] += solid.displacement[4 * n];
    MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, communicator_);
    return sums[0] / sums[1];
  }
} // namespace scenes
