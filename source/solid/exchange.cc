#include <wheelrail/solid/exchange.h>
#include <wheelrail/solid/lanes.h>

#include <algorithm>

namespace wheelrail
{
  SharedSum::SharedSum(const LocalMesh &mesh, MPI_Comm communicator)
    : communicator_(communicator)
  {
    MPI_Comm_rank(communicator, &rank_);
    for (const auto &neighbour : mesh.neighbours)
      {
        links_.push_back({neighbour.rank, neighbour.nodes, {}, {}});
        shared_.insert(shared_.end(), neighbour.nodes.begin(), neighbour.nodes.end());
      }
    std::sort(links_.begin(), links_.end(), [](const Link &a, const Link &b) { return a.rank < b.rank; });
    std::sort(shared_.begin(), shared_.end());
    shared_.erase(std::unique(shared_.begin(), shared_.end()), shared_.end());
  }


  void
  SharedSum::operator()(double *values, const int components, const std::size_t stride)
  {
    if (links_.empty())
      return;
    std::vector<MPI_Request> requests;
    for (auto &link : links_)
      {
        const std::size_t n = link.nodes.size() * components;
        link.send.resize(n);
        link.receive.resize(n);
        MPI_Irecv(link.receive.data(), n, MPI_DOUBLE, link.rank, 17, communicator_, &requests.emplace_back());
        double *out = link.send.data();
        for (const unsigned int node : link.nodes)
          for (int i = 0; i < components; ++i)
            *out++ = values[stride * node + i];
        MPI_Isend(link.send.data(), n, MPI_DOUBLE, link.rank, 17, communicator_, &requests.emplace_back());
      }
    own_.resize(shared_.size() * components);
    double *own = own_.data();
    for (const unsigned int node : shared_)
      for (int i = 0; i < components; ++i)
        {
          *own++                    = values[stride * node + i];
          values[stride * node + i] = 0;
        }
    MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);

    const auto add_own = [&]() {
      const double *in = own_.data();
      for (const unsigned int node : shared_)
        for (int i = 0; i < components; ++i)
          values[stride * node + i] += *in++;
    };
    bool own_added = false;
    for (const auto &link : links_)
      {
        if (link.rank > rank_ && !own_added)
          {
            add_own();
            own_added = true;
          }
        const double *in = link.receive.data();
        for (const unsigned int node : link.nodes)
          for (int i = 0; i < components; ++i)
            values[stride * node + i] += *in++;
      }
    if (!own_added)
      add_own();
  }


  void
  condense(const LocalMesh &mesh, double *values)
  {
    Four *node = reinterpret_cast<Four *>(values);
    for (std::size_t k = 0; k < mesh.hanging.size(); ++k)
      {
        const Four from = node[mesh.hanging[k]];
        for (unsigned int p = mesh.hanging_begin[k]; p < mesh.hanging_begin[k + 1]; ++p)
          node[mesh.parents[p]] += mesh.weights[p] * from;
        node[mesh.hanging[k]] = Four{0, 0, 0, 0};
      }
  }


  void
  distribute(const LocalMesh &mesh, double *values)
  {
    Four *node = reinterpret_cast<Four *>(values);
    for (std::size_t k = 0; k < mesh.hanging.size(); ++k)
      {
        Four mean = {0, 0, 0, 0};
        for (unsigned int p = mesh.hanging_begin[k]; p < mesh.hanging_begin[k + 1]; ++p)
          mean += mesh.weights[p] * node[mesh.parents[p]];
        node[mesh.hanging[k]] = mean;
      }
  }
} // namespace wheelrail
