#include <wheelrail/contact/contact.h>
#include <wheelrail/contact/surface_filter.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  Contact::Contact(Surface         rail,
                   Surface         wheel,
                   RunningSurfaces surfaces,
                   ContactLaw      law,
                   const double    half_window,
                   MPI_Comm        communicator)
    : rail_(std::move(rail))
    , wheel_(std::move(wheel))
    , surfaces_(std::move(surfaces))
    , law_(law)
    , half_window_(half_window)
    , communicator_(communicator)
    , wheel_normal_(wheel_.reference.size())
    , nodes_(rail_.reference.size())
  {
    for (int body = 0; body < 2; ++body)
      {
        SurfaceState  &state   = state_[body];
        const Surface &surface = body == 0 ? rail_ : wheel_;
        state.x                = surface.reference;
        state.v.assign(surface.reference.size(), {0, 0, 0});
        state.sliding = state.f = state.shear = state.v;
        state.reference                       = surface.reference;
        filter_surface(
          surface.lattice, 0, surface.lattice.n_along, normal_weights(law_.filter[body]), state.reference);
      }
    position_ = rail_.reference;
    for (const Vector3 &X : state_[0].reference)
      rail_offset_.push_back(surfaces_.rail_offset(X));
    move_window(0, 0);
  }


  void
  Contact::move_window(const double along, const double wheel_ahead)
  {
    const Lattice &r = rail_.lattice, &w = wheel_.lattice;
    const auto     station = [](const Lattice &lattice, const double place) {
      return static_cast<int>(std::lround(place / lattice.spacing_along)) - lattice.first_station;
    };
    const int rail = station(r, along), wheel = station(w, along + wheel_ahead);
    // the wheel's part reaches one station further, so that every rail node finds a facet
    const Window window{std::max(0, rail - half_window(r)),
                        std::min<int>(r.n_along, rail + half_window(r) + 1),
                        std::max(0, wheel - half_window(w) - 2),
                        std::min<int>(w.n_along, wheel + half_window(w) + 3)};
    const bool   same = window.rail_first == window_.rail_first && window.rail_last == window_.rail_last &&
                      window.wheel_first == window_.wheel_first && window.wheel_last == window_.wheel_last;
    wheel_ahead_ = wheel_ahead;
    if (same)
      return;
    // nodes that leave the window have left the patch long ago
    for (int i = window_.rail_first; i < window_.rail_last; ++i)
      if (i < window.rail_first || i >= window.rail_last)
        for (unsigned int j = 0; j < r.n_lateral; ++j)
          nodes_[r.index(i, j)] = ContactNode();
    window_ = window;
    share_window();
  }


  int
  Contact::half_window(const Lattice &lattice) const
  {
    return static_cast<int>(std::ceil(half_window_ / lattice.spacing_along));
  }


  void
  Contact::share_window()
  {
    int rank, size;
    MPI_Comm_rank(communicator_, &rank);
    MPI_Comm_size(communicator_, &size);
    std::vector<std::vector<std::array<unsigned int, 2>>> by_rank(size);
    for (unsigned int body = 0; body < 2; ++body)
      {
        const Surface &surface = body == 0 ? rail_ : wheel_;
        const int      first   = body == 0 ? window_.rail_first : window_.wheel_first;
        const int      last    = body == 0 ? window_.rail_last : window_.wheel_last;
        for (int i = first; i < last; ++i)
          for (unsigned int j = 0; j < surface.lattice.n_lateral; ++j)
            {
              const unsigned int k = surface.lattice.index(i, j);
              by_rank[surface.owner[k]].push_back({body, k});
            }
      }
    share_.own = by_rank[rank];
    share_.all.clear();
    share_.counts.assign(size, 0);
    share_.begin.assign(size, 0);
    for (int r = 0; r < size; ++r)
      {
        share_.begin[r]  = 6 * share_.all.size();
        share_.counts[r] = 6 * by_rank[r].size();
        share_.all.insert(share_.all.end(), by_rank[r].begin(), by_rank[r].end());
      }
    send_.resize(6 * share_.own.size());
    receive_.resize(6 * share_.all.size());
  }


  void
  Contact::gather(const double *displacement, const double *velocity)
  {
    double *out = send_.data();
    for (const auto &[body, k] : share_.own)
      {
        const unsigned int node = (body == 0 ? rail_ : wheel_).local[k];
        for (int i = 0; i < 3; ++i)
          *out++ = displacement[4 * node + i];
        for (int i = 0; i < 3; ++i)
          *out++ = velocity[4 * node + i];
      }
    if (share_.counts.size() > 1)
      MPI_Allgatherv(send_.data(),
                     send_.size(),
                     MPI_DOUBLE,
                     receive_.data(),
                     share_.counts.data(),
                     share_.begin.data(),
                     MPI_DOUBLE,
                     communicator_);
    else
      receive_ = send_;
    const double *in = receive_.data();
    for (const auto &[body, k] : share_.all)
      {
        SurfaceState  &state = state_[body];
        const Vector3 &X     = (body == 0 ? rail_ : wheel_).reference[k];
        state.x[k]           = {X[0] + in[0], X[1] + in[1], X[2] + in[2]};
        state.v[k] = state.sliding[k] = {in[3], in[4], in[5]};
        if (body == 0)
          position_[k] = state.x[k];
        in += 6;
      }
    filter_window(&SurfaceState::x, false);
    filter_window(&SurfaceState::v, false);
    filter_window(&SurfaceState::sliding, true);
  }


  void
  Contact::filter_window(std::vector<Vector3> SurfaceState::*field, const bool shear)
  {
    for (int body = 0; body < 2; ++body)
      filter_surface((body == 0 ? rail_ : wheel_).lattice,
                     body == 0 ? window_.rail_first : window_.wheel_first,
                     body == 0 ? window_.rail_last : window_.wheel_last,
                     shear ? shear_weights(law_.filter[body]) : normal_weights(law_.filter[body]),
                     state_[body].*field);
  }


  ContactSums
  Contact::evaluate(const double time_step)
  {
    // 1. normals of the wheel's surface, continuous across facets
    wheel_normals();
    for (const auto &[body, k] : share_.all)
      state_[body].f[k] = state_[body].shear[k] = {0, 0, 0};

    // 2. every rail node of the window against the wheel
    ContactSums    sums;
    const Lattice &r = rail_.lattice, &w = wheel_.lattice;
    for (int i = window_.rail_first; i < window_.rail_last; ++i)
      for (unsigned int j = 0; j < r.n_lateral; ++j)
        {
          const std::size_t k        = r.index(i, j);
          const double      along    = (r.first_station + i) * r.spacing_along + wheel_ahead_,
                       s             = r.s_begin + j * r.spacing_lateral;
          ContactNode          &node = nodes_[k];
          std::array<double, 4> weight;
          if (project(node,
                      state_[0].x[k],
                      static_cast<int>(std::lround(along / w.spacing_along)) - w.first_station,
                      static_cast<int>(std::lround((s - w.s_begin) / w.spacing_lateral))))
            node.gap = true_gap(node, k, weight);
          else
            {
              sums.at_border = sums.at_border || node.pressure > 0;
              node           = ContactNode();
            }
          if (node.gap >= 0)
            {
              node.pressure = 0;
              node.shear = node.traction = node.slip = {0, 0, 0};
              node.slipping                          = false;
              continue;
            }
          apply_law(node, k, weight, time_step, sums);
          if (node.pressure > 0 &&
              (i <= window_.rail_first + 1 || i >= window_.rail_last - 2 || j <= 1 || j + 2 >= r.n_lateral ||
               node.facet_i <= window_.wheel_first || node.facet_i >= window_.wheel_last - 2))
            sums.at_border = true;
        }
    // 3. forces go back through the same filters
    filter_window(&SurfaceState::f, false);
    filter_window(&SurfaceState::shear, true);
    return sums;
  }


  double
  Contact::true_gap(ContactNode &node, const std::size_t index, std::array<double, 4> &weight) const
  {
    const double xi = node.xi, eta = node.eta;
    weight       = {(1 - xi) * (1 - eta), xi * (1 - eta), (1 - xi) * eta, xi * eta};
    const auto c = corners(node);
    Vector3    foot{}, normal{}, X{};
    for (int m = 0; m < 4; ++m)
      {
        add(foot, weight[m], state_[1].x[c[m]]);
        add(normal, weight[m], wheel_normal_[c[m]]);
        add(X, weight[m], state_[1].reference[c[m]]);
      }
    node.normal = normalised(normal);
    // facets and filter hide a part of the true profiles
    return dot(foot - state_[0].x[index], node.normal) - surfaces_.wheel_offset(X) - rail_offset_[index];
  }


  void
  Contact::apply_law(ContactNode                 &node,
                     const std::size_t            index,
                     const std::array<double, 4> &weight,
                     const double                 time_step,
                     ContactSums                 &sums)
  {
    const auto    c       = corners(node);
    const double  A       = rail_.area[index];
    const Vector3 n       = node.normal;
    double        opening = 0; // velocity of the wheel against the rail
    Vector3       sliding{};
    if (time_step > 0)
      {
        Vector3 velocity{};
        for (int m = 0; m < 4; ++m)
          {
            add(velocity, weight[m], state_[1].v[c[m]]);
            add(sliding, weight[m], state_[1].sliding[c[m]]);
          }
        opening = dot(velocity - state_[0].v[index], n);
        sliding = sliding - state_[0].sliding[index];
        add(sliding, -dot(sliding, n), n);
      }

    // pressure: spring and damper, no suction
    const double spring = -law_.stiffness * node.gap;
    node.pressure       = std::max(0., spring - law_.damping * opening);

    // shear: elastic trial in the tangent plane, return to the Coulomb bound
    const Vector3 before = node.shear - dot(node.shear, n) * n;
    Vector3       trial  = before;
    add(trial, law_.stiffness * time_step, sliding);
    Vector3      total = trial;
    const double bound = friction_coefficient(law_.friction, norm(sliding)) * node.pressure;
    if (time_step > 0)
      add(total, law_.damping, sliding);
    const double size = norm(total);
    node.slipping     = size > bound;
    if (node.slipping)
      {
        const double factor = size > 0 ? bound / size : 0;
        total               = factor * total;
        trial               = total;
      }
    node.shear    = trial;
    node.traction = total;
    node.slip     = sliding;
    if (time_step > 0)
      add(node.slip, -1 / (law_.stiffness * time_step), trial - before);

    // forces: on the rail -p n + t, on the wheel the opposite, spread over the facet
    const Vector3 push = (node.pressure * A) * n, drag = -A * total;
    for (int m = 0; m < 4; ++m)
      {
        add(state_[1].f[c[m]], weight[m], push);
        add(state_[1].shear[c[m]], weight[m], drag);
      }
    add(state_[0].f[index], -1, push);
    add(state_[0].shear[index], -1, drag);

    add(sums.force, 1, push + drag);
    sums.normal_force += node.pressure * A;
    sums.stored_energy += A * (spring * spring + dot(trial, trial)) / (2 * law_.stiffness);
    sums.friction_power += A * dot(total, node.slip);
    sums.damping_power += A * (spring - node.pressure) * opening;
    sums.damping_power += A * dot(total - trial, sliding - node.slip);
    sums.largest_pressure = std::max(sums.largest_pressure, node.pressure);
    ++sums.nodes;
  }


  void
  Contact::add_forces(double *force) const
  {
    for (const auto &[body, k] : share_.all)
      {
        const int node = (body == 0 ? rail_ : wheel_).local[k];
        if (node >= 0)
          for (int i = 0; i < 3; ++i)
            force[4 * node + i] += state_[body].f[k][i] + state_[body].shear[k][i];
      }
  }


  void
  Contact::set_shear(const std::size_t node, const Vector3 &shear)
  {
    nodes_[node].shear = shear;
  }
} // namespace wheelrail
