#include <deal.II/base/quadrature_lib.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/receptance/track_waves.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace wheelrail
{
  namespace
  {
    using Complex = std::complex<double>;
    using Edge    = std::array<unsigned int, 3>;

    /// Edges of cells whose nodes all lie on the foot.
    std::vector<Edge>
    foot_edges(const SectionMesh &mesh)
    {
      const std::set<unsigned int> foot(mesh.held.begin(), mesh.held.end());
      constexpr unsigned int       faces[4][3] = {{0, 3, 6}, {2, 5, 8}, {0, 1, 2}, {6, 7, 8}};
      std::vector<Edge>            edges;
      for (const auto &cell : mesh.cells)
        for (const auto &face : faces)
          if (foot.count(cell[face[0]]) && foot.count(cell[face[1]]) && foot.count(cell[face[2]]))
            edges.push_back({cell[face[0]], cell[face[1]], cell[face[2]]});
      return edges;
    }

    /// A force along `direction` (x, y; or along the rail) on edges, weighted at each place.
    SectionForce
    force_on(const SectionMesh                           &mesh,
             const WaveMatrices                          &matrices,
             const std::vector<Edge>                     &edges,
             const Vector3                               &direction,
             const std::function<double(const Point2 &)> &weight)
    {
      SectionForce force;
      force.along = direction[2] != 0;
      for (const Edge &edge : edges)
        {
          const auto weights = edge_weights(mesh, edge, weight);
          for (int n = 0; n < 3; ++n)
            for (const auto &[unknown, share] : matrices.unknowns[edge[n]])
              for (int a = 0; a < 3; ++a)
                if (direction[a] != 0 && weights[n] != 0)
                  force.shares.emplace_back(3 * unknown + a, weights[n] * share * direction[a]);
        }
      return force;
    }

    double
    integral(const SectionMesh                           &mesh,
             const std::vector<Edge>                     &edges,
             const std::function<double(const Point2 &)> &weight)
    {
      double sum = 0;
      for (const Edge &edge : edges)
        for (const double part : edge_weights(mesh, edge, weight))
          sum += part;
      return sum;
    }
  } // namespace


  TrackWaves::TrackWaves(const Section                 &section,
                         const Elasticity              &elasticity,
                         const RailSupport              support,
                         const TrackData               &track,
                         const std::vector<HammerFace> &faces)
    : support_(support)
    , track_(track)
  {
    SectionMesh mesh = mesh_section(section, Boundary::foot, 0);
    const auto  foot = foot_edges(mesh);
    if (support != RailSupport::clamped_foot)
      mesh.held.clear();
    matrices_ = assemble_waves(mesh, elasticity, false);
    add_faces(mesh, faces);
    first_foot_ = forces_.size();
    if (support != RailSupport::clamped_foot)
      add_foot(mesh, foot);
    waves_ = std::make_unique<SectionWaves>(matrices_, forces_);
  }


  /// Faces that differ by their place along the rail alone share a force of the section.
  void
  TrackWaves::add_faces(const SectionMesh &mesh, const std::vector<HammerFace> &faces)
  {
    std::vector<Edge> running;
    for (const auto &edge : mesh.running)
      running.push_back(edge.node);
    std::vector<const HammerFace *> known;
    face_spread_ = {Spread::bump, faces.front().radius};
    for (const HammerFace &face : faces)
      {
        const auto same = std::find_if(known.begin(), known.end(), [&](const HammerFace *other) {
          return other->middle[0] == face.middle[0] && other->middle[1] == face.middle[1] &&
                 other->direction == face.direction;
        });
        face_force_.push_back(same - known.begin());
        face_place_.push_back(face.middle[2]);
        if (same != known.end())
          continue;
        known.push_back(&face);
        const auto share = [&](const Point2 &p) {
          return face_share(std::hypot(p.x - face.middle[0], p.y - face.middle[1]), face.radius);
        };
        const double whole = integral(mesh, running, share);
        if (!(whole > 0))
          throw RunError("There is no running surface below the face of the hammer.");
        forces_.push_back(force_on(
          mesh, matrices_, running, face.direction, [&](const Point2 &p) { return share(p) / whole; }));
      }
  }


  void
  TrackWaves::add_foot(const SectionMesh &mesh, const std::vector<Edge> &foot)
  {
    const auto one   = [](const Point2 &) { return 1.; };
    Point2     first = mesh.nodes[foot.front()[0]], last = first;
    for (const Edge &edge : foot)
      for (const unsigned int node : edge)
        {
          first = mesh.nodes[node].x < first.x ? mesh.nodes[node] : first;
          last  = mesh.nodes[node].x > last.x ? mesh.nodes[node] : last;
        }
    const Point2  middle = 0.5 * (first + last), along_foot = (1 / norm(last - first)) * (last - first);
    const double  width  = integral(mesh, foot, one);
    const Vector3 across = {along_foot.x, along_foot.y, 0}, normal = {-along_foot.y, along_foot.x, 0};
    axes_            = {across, normal};
    const auto place = [=](const Point2 &p) {
      return 2 * ((p.x - middle.x) * along_foot.x + (p.y - middle.y) * along_foot.y) / width;
    };
    const auto even = [=](const Point2 &) { return 1 / width; };
    const auto tilt = [=](const Point2 &p) { return std::sqrt(3.) * place(p) / width; };
    const auto bend = [=](const Point2 &p) {
      return std::sqrt(5.) * (1.5 * place(p) * place(p) - 0.5) / width;
    };
    const Vector3 along = {0, 0, 1};
    const auto    add   = [&](const Vector3 &direction, const std::function<double(const Point2 &)> &weight) {
      forces_.push_back(force_on(mesh, matrices_, foot, direction, weight));
    };
    add(normal, even), add(normal, tilt), add(normal, bend);
    add(across, even);
    add(along, even), add(along, tilt);
  }


  /// Of one pad, for each of the forces of the foot [N/m].
  std::vector<Complex>
  TrackWaves::pad_stiffness(const Complex w) const
  {
    const Complex        dynamic = track_.pad_damping.dynamic_stiffness(w);
    std::vector<Complex> springs(n_foot_forces);
    for (const unsigned int f : {normal_even, normal_tilt, normal_bend})
      springs[f] = track_.pad[1] * dynamic;
    springs[across_even] = track_.pad[0] * dynamic;
    for (const unsigned int f : {along_even, along_tilt})
      springs[f] = track_.pad[2] * dynamic;
    return springs;
  }


  std::vector<Complex>
  TrackWaves::receptances(const double frequency, const double fading) const
  {
    const Complex        w(2 * M_PI * frequency, -fading);
    std::vector<Complex> springs;
    if (support_ == RailSupport::continuous_pads)
      {
        springs.assign(first_foot_, 0.);
        for (const Complex pad : pad_stiffness(w))
          springs.push_back(pad / track_.spacing);
      }
    const auto           waves = waves_->waves(w, loss, springs);
    std::vector<Complex> moved = of_free_rail(waves);
    if (support_ == RailSupport::sleepers)
      add_sleepers(w, waves, moved);
    return moved;
  }


  std::vector<Complex>
  TrackWaves::of_free_rail(const std::vector<SectionWaves::Wave> &waves) const
  {
    std::vector<Complex> moved, factors(waves.size());
    for (std::size_t f = 0; f < face_place_.size(); ++f)
      {
        const SpreadPair pair(face_spread_, face_spread_, face_place_[f] - face_place_[0], false);
        for (std::size_t n = 0; n < waves.size(); ++n)
          factors[n] = pair.mean(waves[n].k);
        moved.push_back(waves_->response(waves, face_force_[f], face_force_[0], factors));
      }
    return moved;
  }


  double
  TrackWaves::pinned_pinned() const
  {
    // the wave of the unsupported rail that moves most where it is struck
    const double k    = M_PI / track_.spacing;
    double       most = 0, found = std::nan("");
    for (const double frequency : waves_->frequencies(k, 6))
      if (frequency > 1)
        {
          const auto   waves = waves_->waves(2 * M_PI * frequency, 1e-6);
          const double near  = 1e-3 * k;
          for (const auto &wave : waves)
            if (std::abs(wave.k.real() - k) < near && std::abs(wave.k.imag()) < near)
              {
                const double moves = std::abs(wave.at[face_force_[0]] * wave.at[face_force_[0]] / wave.turn);
                if (moves > most)
                  most = moves, found = frequency;
              }
        }
    return found;
  }


  namespace
  {
    /// Calls f(place, weight) at Gauss points of a stretch.
    template <typename F>
    void
    gauss(const double from, const double to, const F &f)
    {
      static const dealii::QGauss<1> points(10);
      for (unsigned int q = 0; q < points.size(); ++q)
        f(from + points.point(q)[0] * (to - from), points.weight(q) * (to - from));
    }

    /// int a(z) b(z - s) dz
    double
    overlap(const Spread &a, const Spread &b, const double s)
    {
      const double from = std::max(-a.half, s - b.half), to = std::min(a.half, s + b.half);
      double       sum = 0;
      if (from < to)
        gauss(from, to, [&](const double z, const double weight) { sum += weight * a.at(z) * b.at(z - s); });
      return sum;
    }
  } // namespace


  double
  Spread::at(const double s) const
  {
    switch (kind)
      {
        case bump:
          return (1 + std::cos(M_PI * s / half)) / (2 * half);
        case even:
          return 1 / (2 * half);
        default:
          return std::sqrt(3.) * s / (2 * half * half);
      }
  }


  SpreadPair::SpreadPair(const Spread &a, const Spread &b, const double ahead, const bool odd)
  {
    // kinks: where both meet, where one begins to lie within the other
    const double        reach = a.half + b.half, inner = std::abs(a.half - b.half);
    std::vector<double> borders = {-reach, -inner, inner, reach};
    if (std::abs(ahead) < reach)
      // near fields die fast: panels shrink towards the distance zero
      for (const double part : {0., 0.003, 0.01, 0.03, 0.1, 0.3})
        for (const double side : {-1., 1.})
          borders.push_back(std::clamp(-ahead + side * part * reach, -reach, reach));
    std::sort(borders.begin(), borders.end());
    for (std::size_t p = 0; p + 1 < borders.size(); ++p)
      if (borders[p + 1] > borders[p])
        gauss(borders[p], borders[p + 1], [&](const double s, const double part) {
          const double x = ahead + s;
          distance.push_back(std::abs(x));
          weight.push_back(part * overlap(a, b, s) * (odd && x < 0 ? -1 : 1));
        });
  }


  std::complex<double>
  SpreadPair::mean(const std::complex<double> k) const
  {
    const std::complex<double> factor = std::complex<double>(0, -1) * k;
    std::complex<double>       sum    = 0;
    for (std::size_t n = 0; n < distance.size(); ++n)
      sum += weight[n] * std::exp(factor * distance[n]);
    return sum;
  }
} // namespace wheelrail
