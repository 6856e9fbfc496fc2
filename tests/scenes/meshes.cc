#include "meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <vector>

namespace scenes
{
  using namespace wheelrail;

  namespace
  {
    /// Finds nodes by their place: a hash of cubes as large as the tolerance.
    class NodeFinder
    {
    public:
      NodeFinder(LocalMesh &mesh, const double tolerance)
        : mesh_(mesh)
        , tolerance_(tolerance)
      {
      }

      /// Number of the node at this place, or none.
      std::optional<unsigned int>
      known(const Vector3 &X) const
      {
        const auto at = key(X);
        for (int n = 0; n < 27; ++n)
          if (const auto found = nodes_.find({at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1});
              found != nodes_.end())
            return found->second;
        return {};
      }

      /// Number of the node at this place, which is made when there is none.
      unsigned int
      operator()(const Vector3 &X)
      {
        if (const auto node = known(X))
          return *node;
        const unsigned int node = mesh_.n_nodes();
        nodes_[key(X)]          = node;
        mesh_.global_node.push_back(node);
        mesh_.node_key.push_back(node);
        mesh_.reference.insert(mesh_.reference.end(), {X[0], X[1], X[2], 0.});
        return node;
      }

    private:
      std::array<long, 3>
      key(const Vector3 &X) const
      {
        return {
          std::lround(X[0] / tolerance_), std::lround(X[1] / tolerance_), std::lround(X[2] / tolerance_)};
      }

      LocalMesh                                  &mesh_;
      double                                      tolerance_;
      std::map<std::array<long, 3>, unsigned int> nodes_;
    };

    /// Quadrilaterals that occur once.
    void
    find_faces(LocalMesh &mesh)
    {
      // corners of the six faces of a lexicographic cell, the normal (1 - 0) x (2 - 0) outwards
      constexpr int corner[6][4] = {
        {0, 4, 2, 6}, {1, 3, 5, 7}, {0, 1, 4, 5}, {2, 6, 3, 7}, {0, 2, 1, 3}, {4, 5, 6, 7}};
      std::map<std::array<unsigned int, 4>, std::pair<int, BoundaryFace>> found;
      const auto finest = *std::max_element(mesh.cell_level.begin(), mesh.cell_level.end());
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        for (const auto &which : corner)
          {
            BoundaryFace face{{},
                              Boundary::free,
                              mesh.cell_body[c],
                              static_cast<unsigned int>(c),
                              mesh.cell_level[c] == finest,
                              true};
            for (int k = 0; k < 4; ++k)
              face.nodes[k] = mesh.cells[c][which[k]];
            auto key = face.nodes;
            std::sort(key.begin(), key.end());
            ++found.try_emplace(key, 0, face).first->second.first;
          }
      for (const auto &[key, entry] : found)
        if (entry.first == 1)
          mesh.faces.push_back(entry.second);
    }

    void
    complete(LocalMesh &mesh, const Body body)
    {
      mesh.n_owned = mesh.n_nodes();
      mesh.node_body.assign(mesh.n_nodes(), body);
      mesh.cell_body.assign(mesh.cells.size(), body);
      mesh.cell_level.resize(mesh.cells.size(), 0);
      mesh.hanging_begin = {0};
      find_faces(mesh);
    }

    /// Corners of a cell whose mean is the place (0, 1 or 2 in each direction) of its lattice of halves.
    Nodes
    corners_around(const std::array<unsigned int, 8> &cell, const std::array<int, 3> &at)
    {
      Nodes corners;
      for (int a = 0; a < 8; ++a)
        {
          bool near = true;
          for (int i = 0; i < 3; ++i)
            near = near && (at[i] == 1 || at[i] / 2 == (a >> i & 1));
          if (near)
            corners.push_back(cell[a]);
        }
      return corners;
    }

    Vector3
    mean_place(const LocalMesh &mesh, const Nodes &nodes)
    {
      Vector3 X{};
      for (const unsigned int n : nodes)
        add(X, 1. / nodes.size(), place_of(mesh, n));
      return X;
    }
  } // namespace


  LocalMesh
  make_mesh(const std::vector<Block> &blocks, const Body body)
  {
    Vector3 low = blocks[0].place({0, 0, 0}), high = low;
    for (const auto &block : blocks)
      for (unsigned int a = 0; a < 8; ++a)
        {
          const Vector3 X = block.place({double(a & 1), double(a >> 1 & 1), double(a >> 2)});
          for (int i = 0; i < 3; ++i)
            low[i] = std::min(low[i], X[i]), high[i] = std::max(high[i], X[i]);
        }
    LocalMesh  mesh;
    NodeFinder find(mesh, 1e-6 * norm(high - low));
    for (const auto &block : blocks)
      {
        const auto               &n = block.cells;
        std::vector<unsigned int> node;
        for (unsigned int k = 0; k <= n[2]; ++k)
          for (unsigned int j = 0; j <= n[1]; ++j)
            for (unsigned int i = 0; i <= n[0]; ++i)
              node.push_back(find(block.place({double(i) / n[0], double(j) / n[1], double(k) / n[2]})));
        for (unsigned int k = 0; k < n[2]; ++k)
          for (unsigned int j = 0; j < n[1]; ++j)
            for (unsigned int i = 0; i < n[0]; ++i)
              {
                auto &cell = mesh.cells.emplace_back();
                for (unsigned int a = 0; a < 8; ++a)
                  cell[a] = node[i + (a & 1) + (n[0] + 1) * (j + (a >> 1 & 1) + (n[1] + 1) * (k + (a >> 2)))];
              }
      }
    complete(mesh, body);
    return mesh;
  }


  LocalMesh
  box(const Vector3 &low, const Vector3 &high, const Cells &cells, const Body body)
  {
    const auto place = [=](const Vector3 &s) -> Vector3 {
      Vector3 X;
      for (int i = 0; i < 3; ++i)
        X[i] = low[i] + s[i] * (high[i] - low[i]);
      return X;
    };
    return make_mesh({{cells, place}}, body);
  }


  LocalMesh
  two_level_box(const Vector3   &low,
                const Vector3   &high,
                const Cells     &cells,
                const Predicate &fine,
                const double     distortion,
                const Body       body)
  {
    LocalMesh coarse = box(low, high, cells);
    Vector3   size;
    for (int i = 0; i < 3; ++i)
      size[i] = (high[i] - low[i]) / cells[i];
    distort(coarse, distortion * std::min({size[0], size[1], size[2]}), [&](const Vector3 &X) {
      bool inside = true;
      for (int i = 0; i < 3; ++i)
        inside = inside && X[i] > low[i] + 0.5 * size[i] && X[i] < high[i] - 0.5 * size[i];
      return inside;
    });

    LocalMesh                 mesh;
    NodeFinder                find(mesh, 1e-6 * norm(high - low));
    std::vector<unsigned int> kept;
    for (std::size_t c = 0; c < coarse.cells.size(); ++c)
      {
        const auto &parent = coarse.cells[c];
        const bool  divide = fine(mean_place(coarse, {parent.begin(), parent.end()}));
        if (!divide)
          kept.push_back(c);
        for (int child = 0; child < (divide ? 8 : 1); ++child)
          {
            auto &cell = mesh.cells.emplace_back();
            mesh.cell_level.push_back(divide);
            for (int a = 0; a < 8; ++a)
              {
                std::array<int, 3> at;
                for (int i = 0; i < 3; ++i)
                  at[i] = divide ? (child >> i & 1) + (a >> i & 1) : 2 * (a >> i & 1);
                cell[a] = find(mean_place(coarse, corners_around(parent, at)));
              }
          }
      }
    complete(mesh, body);

    // nodes of fine cells in the middle of an edge or face of a coarse one
    std::map<unsigned int, Nodes> hanging;
    for (const unsigned int c : kept)
      for (int n = 0; n < 27; ++n)
        {
          const Nodes corners = corners_around(coarse.cells[c], {n % 3, n / 3 % 3, n / 9});
          const auto  node    = find.known(mean_place(coarse, corners));
          if (!node || corners.size() == 1)
            continue;
          auto &parents = hanging[*node];
          parents.clear();
          for (const unsigned int corner : corners)
            parents.push_back(*find.known(place_of(coarse, corner)));
        }
    for (const auto &[node, parents] : hanging)
      {
        mesh.hanging.push_back(node);
        mesh.parents.insert(mesh.parents.end(), parents.begin(), parents.end());
        mesh.weights.insert(mesh.weights.end(), parents.size(), 1. / parents.size());
        mesh.hanging_begin.push_back(mesh.parents.size());
      }
    return mesh;
  }


  void
  distort(LocalMesh &mesh, const double size, const Predicate &which)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> shift(-size, size);
    for (const unsigned int n : select(mesh, which))
      for (int i = 0; i < 3; ++i)
        mesh.reference[4 * n + i] += shift(random);
  }


  LocalMesh
  join(const LocalMesh &first, const LocalMesh &second)
  {
    LocalMesh          mesh  = first;
    const unsigned int shift = first.n_nodes(), parent_shift = first.parents.size();
    const auto append = [](auto &to, const auto &from) { to.insert(to.end(), from.begin(), from.end()); };
    for (const auto n : second.global_node)
      mesh.global_node.push_back(n + shift);
    for (const auto n : second.node_key)
      mesh.node_key.push_back(n + shift);
    append(mesh.reference, second.reference);
    mesh.n_owned += second.n_owned;
    append(mesh.node_body, second.node_body);
    for (auto cell : second.cells)
      {
        for (auto &n : cell)
          n += shift;
        mesh.cells.push_back(cell);
      }
    append(mesh.cell_body, second.cell_body);
    append(mesh.cell_level, second.cell_level);
    for (const auto n : second.hanging)
      mesh.hanging.push_back(n + shift);
    for (std::size_t k = 1; k < second.hanging_begin.size(); ++k)
      mesh.hanging_begin.push_back(second.hanging_begin[k] + parent_shift);
    for (const auto n : second.parents)
      mesh.parents.push_back(n + shift);
    append(mesh.weights, second.weights);
    for (auto face : second.faces)
      {
        for (auto &n : face.nodes)
          n += shift;
        mesh.faces.push_back(face);
      }
    return mesh;
  }


  Nodes
  select(const LocalMesh &mesh, const Predicate &which)
  {
    Nodes nodes;
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      if (which(place_of(mesh, n)))
        nodes.push_back(n);
    return nodes;
  }


  std::vector<BoundaryFace>
  select_faces(const LocalMesh &mesh, const Predicate &which)
  {
    std::vector<BoundaryFace> faces;
    for (const auto &face : mesh.faces)
      if (which(mean_place(mesh, {face.nodes.begin(), face.nodes.end()})))
        faces.push_back(face);
    return faces;
  }


  void
  mark_faces(LocalMesh &mesh, const Boundary mark, const Predicate &which)
  {
    for (auto &face : mesh.faces)
      if (which(mean_place(mesh, {face.nodes.begin(), face.nodes.end()})))
        face.mark = mark;
  }


  Vector3
  place_of(const LocalMesh &mesh, const unsigned int node)
  {
    const double *X = &mesh.reference[4 * node];
    return {X[0], X[1], X[2]};
  }


  Predicate
  plane(const int component, const double value)
  {
    return [=](const Vector3 &X) { return std::abs(X[component] - value) < 1e-9; };
  }
} // namespace scenes
