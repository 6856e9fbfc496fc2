#include <wheelrail/base/gather_all.h>
#include <wheelrail/statics/static_springs.h>

#include <algorithm>
#include <tuple>
#include <unordered_map>

// K_springs = B' C B: rows of B are springs, C = diag(stiffness) [N/m], entries of B are weights of nodes
// along the direction of the spring.

namespace wheelrail
{
  namespace
  {
    using SpringPart = StaticSprings::Part;

    /// Adds the part of a local node to a list; a hanging one hands it to its parents.
    class PartList
    {
    public:
      explicit PartList(const LocalMesh &mesh)
        : mesh_(mesh)
      {
        for (unsigned int k = 0; k < mesh.hanging.size(); ++k)
          hangs_[mesh.hanging[k]] = k;
      }

      void
      add(const unsigned int spring, const unsigned int node, const Vector3 &weight)
      {
        const auto hangs = hangs_.find(node);
        if (hangs == hangs_.end())
          {
            parts.push_back({spring, mesh_.global_node[node], weight});
            return;
          }
        for (unsigned int p = mesh_.hanging_begin[hangs->second]; p < mesh_.hanging_begin[hangs->second + 1];
             ++p)
          // u of a hanging node = sum of weights x u of its parents
          parts.push_back({spring, mesh_.global_node[mesh_.parents[p]], mesh_.weights[p] * weight});
      }

      std::vector<SpringPart> parts;

    private:
      const LocalMesh                               &mesh_;
      std::unordered_map<unsigned int, unsigned int> hangs_; ///< node, place in the list of hanging ones
    };

    std::unordered_map<std::uint32_t, unsigned int>
    local_numbers(const LocalMesh &mesh)
    {
      std::unordered_map<std::uint32_t, unsigned int> local;
      for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
        local[mesh.global_node[n]] = n;
      return local;
    }
  } // namespace


  StaticSprings::StaticSprings(const std::vector<Contact::Spring> &springs,
                               const LocalMesh                    &mesh,
                               const std::vector<unsigned char>   &held,
                               MPI_Comm                            communicator)
    : communicator_(communicator)
  {
    // a spring of the contact joins the nodes behind a filtered one of the rail (weights +) with those of a
    // facet of the wheel (weights -)
    const auto local = local_numbers(mesh);
    PartList   list(mesh);
    for (unsigned int k = 0; k < springs.size(); ++k)
      {
        // eps A of the node [N/m]
        stiffness_.push_back(springs[k].stiffness);
        for (const auto &[global, weight] : springs[k].nodes)
          if (const auto node = local.find(global); node != local.end() && mesh.owns(node->second))
            // row k of B: sum of weight_n n . u_n = minus the change of the gap; K_springs = B' C B with C =
            // diag(k A) (doc/theory/rolling.md, Static start, 2)
            list.add(k, node->second, weight * springs[k].normal);
      }
    take(std::move(list.parts), mesh, held);
  }


  StaticSprings::StaticSprings(const std::vector<JoinedNodes>   &joined,
                               const LocalMesh                  &mesh,
                               const std::vector<unsigned char> &held,
                               MPI_Comm                          communicator)
    : communicator_(communicator)
  {
    PartList list(mesh);
    for (unsigned int k = 0; k < joined.size(); ++k)
      {
        stiffness_.push_back(joined[k].stiffness);
        for (const auto &[node, weight] : joined[k].nodes)
          list.add(k, node, weight);
      }
    take(std::move(list.parts), mesh, held);
  }


  StaticSprings
  StaticSprings::coarsened(const CoarseLevel &coarse, const std::vector<unsigned char> &held) const
  {
    StaticSprings result;
    result.communicator_ = communicator_;
    result.stiffness_    = stiffness_;
    PartList list(coarse.mesh);
    for (std::size_t k = 0; k < parts_.size(); ++k)
      if (const unsigned int n = local_[k]; mesh_->owns(n))
        for (unsigned int p = coarse.begin[n]; p < coarse.begin[n + 1]; ++p)
          // B P, P the interpolation from the coarser level: the coarse springs are P' B' C B P (Galerkin)
          list.add(parts_[k].spring, coarse.nodes[p], coarse.weights[p] * parts_[k].weight);
    result.take(std::move(list.parts), coarse.mesh, held);
    return result;
  }


  /// Joins the parts that the ranks know.
  void
  StaticSprings::take(std::vector<SpringPart>           own,
                      const LocalMesh                  &mesh,
                      const std::vector<unsigned char> &held)
  {
    mesh_ = &mesh;
    // all ranks pass the same springs; each adds the parts of its own nodes
    const auto local = local_numbers(mesh);
    // 1. Held nodes take no part: their displacement is zero.
    for (SpringPart &part : own)
      if (held[local.at(part.node)])
        part.weight = {0, 0, 0};
    // 2. All ranks get all parts. Sorted stably by spring and node, so that sums have the same order, and the
    // same bits, whatever rank gave them.
    std::vector<SpringPart> all = gather_all(own, communicator_);
    const auto place = [](const SpringPart &part) { return std::make_tuple(part.spring, part.node); };
    std::stable_sort(
      all.begin(), all.end(), [&](const SpringPart &a, const SpringPart &b) { return place(a) < place(b); });
    for (const SpringPart &part : all)
      // parents of several nodes of one spring get the sum of their weights
      if (!parts_.empty() && place(parts_.back()) == place(part))
        wheelrail::add(parts_.back().weight, 1, part.weight);
      else
        parts_.push_back(part);
    for (const SpringPart &part : parts_)
      {
        // 3. Which of them this rank has
        const auto node = local.find(part.node);
        local_.push_back(node == local.end() ? none : node->second);
      }
  }


  std::vector<double>
  StaticSprings::stretch(const double *x) const
  {
    // each rank adds the parts of its own nodes, and the sum goes to all
    std::vector<double> stretch(size(), 0.);
    if (stretch.empty())
      return stretch;
    for (std::size_t k = 0; k < parts_.size(); ++k)
      if (const unsigned int n = local_[k]; mesh_->owns(n))
        for (int i = 0; i < 3; ++i)
          // B x
          stretch[parts_[k].spring] += parts_[k].weight[i] * x[4 * n + i];
    MPI_Allreduce(MPI_IN_PLACE, stretch.data(), static_cast<int>(size()), MPI_DOUBLE, MPI_SUM, communicator_);
    return stretch;
  }


  void
  StaticSprings::add(const std::vector<double> &forces, double *y) const
  {
    for (std::size_t k = 0; k < parts_.size(); ++k)
      if (const unsigned int n = local_[k]; mesh_->owns(n))
        for (int i = 0; i < 3; ++i)
          // B' f
          y[4 * n + i] += parts_[k].weight[i] * forces[parts_[k].spring];
  }


  void
  StaticSprings::add_product(const double factor, const double *x, double *y) const
  {
    // factor B' C B x
    std::vector<double> force = stretch(x);
    for (std::size_t k = 0; k < force.size(); ++k)
      force[k] *= factor * stiffness_[k];
    add(force, y);
  }


  std::size_t
  StaticSprings::band() const
  {
    // springs couple in B D^-1 B' where they share a node: their largest distance in the list is the band
    // width of that matrix
    std::unordered_map<std::uint32_t, unsigned int> first; // spring of each node
    std::size_t                                     band = 0;
    for (const SpringPart &part : parts_)
      band =
        std::max<std::size_t>(band, part.spring - first.try_emplace(part.node, part.spring).first->second);
    return band;
  }
} // namespace wheelrail
