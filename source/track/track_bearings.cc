#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <wheelrail/base/gather_all.h>
#include <wheelrail/track/track_support.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <vector>

namespace wheelrail
{
  // What of the track's support follows from the mesh, and its share in static solutions.

  namespace
  {
    /// Middles of the sleepers below a stretch.
    std::vector<double>
    sleepers_below(const FootPiece &whole, const double first, const double spacing)
    {
      std::vector<double> middles;
      for (double k = std::ceil((whole[0] - first) / spacing); first + k * spacing <= whole[1]; ++k)
        middles.push_back(first + k * spacing);
      return middles;
    }
  } // namespace


  void
  TrackSupport::prepare(const Solid &solid, std::vector<NodeInertia> &)
  {
    const std::vector<Kept> kept = stretches_of_all();
    find_bearings(solid);
    find_foot(solid);
    keep_stretches(kept);
    if (!sleepers_move())
      return;
    // from a first mesh on the sleepers are the same
    place_.resize(sleepers_.size());
    speed_.resize(sleepers_.size());
    mean_speed_.resize(sleepers_.size());
    std::vector<double> pads(sleepers_.size(), 0.);
    for (const Bearing &at : bearings_)
      pads[at.sleeper] += at.owned * at.share;
    ordered_sum(pads, communicator_);
    give_.clear();
    for (const double share : pads)
      {
        dealii::Tensor<2, 3> holds;
        for (int i = 0; i < 3; ++i)
          {
            holds[i][i] += data_.ballast[i];
            for (int j = 0; j < 3; ++j)
              for (int a = 0; a < 3; ++a)
                holds[i][j] += share * data_.pad[a] * axes_[a][i] * axes_[a][j];
          }
        const dealii::Tensor<2, 3> inverse = dealii::invert(holds);
        auto                      &give    = give_.emplace_back();
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            give[3 * i + j] = inverse[i][j];
      }
  }


  void
  TrackSupport::find_bearings(const Solid &solid)
  {
    const FootPiece        whole  = whole_foot(solid.mesh, communicator_);
    std::vector<FootPiece> pieces = {whole};
    if (!data_.continuous)
      {
        sleepers_ = sleepers_below(whole, data_.first, data_.spacing);
        pieces.clear();
        for (const double middle : sleepers_)
          pieces.push_back({middle - 0.5 * data_.pad_length, middle + 0.5 * data_.pad_length});
      }
    const RailFoot foot = rail_foot(solid, pieces, communicator_);
    axes_               = foot.axes;
    const double of_one = foot.width * (data_.continuous ? data_.spacing : data_.pad_length); // area [m2]
    bearings_.clear();
    at_.clear();
    for (std::size_t k = 0; k < foot.nodes.size(); ++k)
      {
        const unsigned int n = foot.nodes[k];
        const Vector3      X = solid.mesh.place(n);
        Bearing            bearing{n, 0, foot.area[k] / of_one, double(solid.mesh.owns(n)), 0};
        bearing.key = solid.mesh.node_key[n];
        if (!data_.continuous) // the nearest: pads lie apart by more than a block
          bearing.sleeper =
            static_cast<unsigned int>(std::min_element(sleepers_.begin(),
                                                       sleepers_.end(),
                                                       [&](const double a, const double b) {
                                                         return std::abs(a - X[2]) < std::abs(b - X[2]);
                                                       }) -
                                      sleepers_.begin());
        bearings_.push_back(bearing);
        at_.push_back(X);
      }
  }


  /// Nodes of the foot by their places along the track; hanging ones are left out.
  void
  TrackSupport::find_foot(const Solid &solid)
  {
    const LocalMesh       &mesh = solid.mesh;
    std::set<unsigned int> nodes;
    for (const BoundaryFace &face : mesh.faces)
      if (face.mark == Boundary::foot)
        nodes.insert(face.nodes.begin(), face.nodes.end());
    std::vector<double> own;
    foot_.clear();
    for (const unsigned int n : nodes)
      if (mesh.owns(n) && solid.mass[n] > 0)
        {
          own.push_back(mesh.reference[4 * n + 2]);
          foot_.push_back({n, 0, 0});
        }
    constexpr double    apart = 1e-6; // [m]
    std::vector<double> all   = gather_all(own, communicator_);
    std::sort(all.begin(), all.end());
    std::vector<double> stations;
    std::vector<int>    count;
    for (const double z : all)
      {
        if (stations.empty() || z > stations.back() + apart)
          {
            stations.push_back(z);
            count.push_back(0);
          }
        ++count.back();
      }
    for (FootNode &at : foot_)
      {
        at.station = static_cast<unsigned int>(
          std::upper_bound(stations.begin(), stations.end(), mesh.reference[4 * at.node + 2]) -
          stations.begin() - 1);
        at.share = 1. / count[at.station];
      }
    n_stations_ = static_cast<unsigned int>(stations.size());
  }


  /// Of all ranks, each node once; nothing without branches.
  std::vector<TrackSupport::Kept>
  TrackSupport::stretches_of_all() const
  {
    std::vector<Kept> own;
    if (!data_.pad_damping.branches.empty())
      for (std::size_t k = 0; k < stretch_.size(); ++k)
        if (bearings_[k].owned > 0)
          own.push_back({bearings_[k].key, at_[k], stretch_[k]});
    return gather_all(own, communicator_);
  }


  /// On a new mesh nodes keep their stretch; one that has come takes that of the nearest.
  void
  TrackSupport::keep_stretches(const std::vector<Kept> &kept)
  {
    stretch_.assign(bearings_.size(), Stretch{});
    if (kept.empty())
      return;
    std::unordered_map<std::uint64_t, const Kept *> known;
    for (const Kept &node : kept)
      known[node.key] = &node;
    for (std::size_t k = 0; k < bearings_.size(); ++k)
      if (const auto same = known.find(bearings_[k].key); same != known.end())
        stretch_[k] = same->second->stretch;
      else
        stretch_[k] = std::min_element(kept.begin(), kept.end(), [&](const Kept &a, const Kept &b) {
                        return norm(a.place - at_[k]) < norm(b.place - at_[k]);
                      })->stretch;
  }


  /// Where the sleepers are in equilibrium with the nodes; none when they do not move.
  std::vector<Vector3>
  TrackSupport::condensed(const double *x) const
  {
    std::vector<double> pull(3 * place_.size(), 0.);
    if (place_.empty())
      return {};
    for (const Bearing &at : bearings_)
      {
        Vector3 force = turned({x[4 * at.node], x[4 * at.node + 1], x[4 * at.node + 2]});
        for (int i = 0; i < 3; ++i)
          force[i] *= at.owned * at.share * data_.pad[i];
        force = turned_back(force);
        for (int i = 0; i < 3; ++i)
          pull[3 * at.sleeper + i] += force[i];
      }
    ordered_sum(pull, communicator_);
    std::vector<Vector3> places(place_.size(), Vector3{});
    for (std::size_t s = 0; s < places.size(); ++s)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          places[s][i] += give_[s][3 * i + j] * pull[3 * s + j];
    return places;
  }


  void
  TrackSupport::add_stiffness(const Solid &, const double *x, double *y) const
  {
    const std::vector<Vector3> sleepers = condensed(x);
    for (const Bearing &at : bearings_)
      {
        Vector3 moved = {x[4 * at.node], x[4 * at.node + 1], x[4 * at.node + 2]};
        if (!sleepers.empty())
          moved = moved - sleepers[at.sleeper];
        Vector3 force = turned(moved);
        for (int i = 0; i < 3; ++i)
          force[i] *= at.share * data_.pad[i];
        force = turned_back(force);
        for (int i = 0; i < 3; ++i)
          y[4 * at.node + i] += force[i];
      }
  }


  void
  TrackSupport::add_springs(double *stiffness) const
  {
    for (const Bearing &at : bearings_)
      for (int i = 0; i < 3; ++i)
        for (int a = 0; a < 3; ++a)
          stiffness[4 * at.node + i] += at.share * data_.pad[a] * axes_[a][i] * axes_[a][i];
  }


  /// A sleeper deflects by give x (sum of the pads' forces). With give = L L^T (Cholesky) that is one term
  /// for each column of L.
  std::vector<JoinedNodes>
  TrackSupport::joined() const
  {
    std::vector<JoinedNodes> terms(3 * give_.size());
    std::vector<Vector3>     columns;
    for (const auto &give : give_)
      {
        dealii::FullMatrix<double> whole(3, 3, give.data()), root(3, 3);
        root.cholesky(whole);
        for (int k = 0; k < 3; ++k)
          columns.push_back({root(0, k), root(1, k), root(2, k)});
      }
    for (JoinedNodes &term : terms)
      term.stiffness = -1;
    for (const Bearing &at : bearings_)
      if (!terms.empty() && at.owned > 0)
        for (unsigned int k = 3 * at.sleeper; k < 3 * at.sleeper + 3; ++k)
          {
            Vector3 force = turned(columns[k]);
            for (int a = 0; a < 3; ++a)
              force[a] *= at.share * data_.pad[a];
            terms[k].nodes.emplace_back(at.node, turned_back(force));
          }
    return terms;
  }


  void
  TrackSupport::start(const Solid &solid)
  {
    if (sleepers_move())
      {
        place_      = condensed(solid.displacement.data());
        speed_      = condensed(solid.velocity.data());
        mean_speed_ = speed_;
      }
    // relaxed but for what the slow motion of the start leaves
    const auto &branches = data_.pad_damping.branches;
    for (std::size_t k = 0; k < bearings_.size(); ++k)
      {
        const double *v     = &solid.velocity[4 * bearings_[k].node];
        Vector3       speed = {v[0], v[1], v[2]};
        if (!place_.empty())
          speed = speed - speed_[bearings_[k].sleeper];
        speed = turned(speed);
        for (std::size_t b = 0; b < branches.size(); ++b)
          stretch_[k][b] = branches[b].time * speed;
      }
  }


  Vector3
  TrackSupport::force_at_rest(const Solid &solid) const
  {
    std::vector<double> force(solid.force.size(), 0.);
    add_stiffness(solid, solid.displacement.data(), force.data());
    Vector3 sum{};
    for (const Bearing &at : bearings_)
      for (int i = 0; i < 3; ++i)
        sum[i] += at.owned * force[4 * at.node + i];
    ordered_sum(sum, communicator_);
    return sum;
  }
} // namespace wheelrail
