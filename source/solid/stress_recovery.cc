#include <wheelrail/solid/point_state.h>
#include <wheelrail/solid/stress_recovery.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    using Stress = std::array<double, 6>;

    /// Sums over the elements around a point, weighted by volume; d counts from the point to the centres.
    struct Moments
    {
      double                volume = 0;
      double                flowed = 0; ///< volume that has flowed
      Vector3               d{};
      std::array<double, 6> dd{}; ///< xx yy zz yz xz xy
      Stress                s{};
      std::array<Stress, 3> sd{}; ///< s times each component of d
    };

    /// Sums over the elements around a node: gradients of stress, and G d.
    struct GradientSum
    {
      std::array<Stress, 3> G{};
      Stress                Gd{};
    };

    constexpr int first_of[6] = {0, 1, 2, 1, 0, 0}, second_of[6] = {0, 1, 2, 2, 2, 1};

    template <typename Sums>
    constexpr std::size_t numbers = sizeof(Sums) / sizeof(double);

    /// Adds up what the ranks have for their shared nodes; Sums is a struct of doubles alone.
    template <typename Sums>
    void
    sum_over_ranks(SharedSum &sum, std::vector<Sums> &sums)
    {
      AlignedVector<double> part(4 * sums.size());
      for (std::size_t first = 0; first < numbers<Sums>; first += 4)
        {
          const std::size_t count = std::min<std::size_t>(4, numbers<Sums> - first);
          for (std::size_t n = 0; n < sums.size(); ++n)
            std::copy_n(reinterpret_cast<const double *>(&sums[n]) + first, count, &part[4 * n]);
          sum(part.data(), count);
          for (std::size_t n = 0; n < sums.size(); ++n)
            std::copy_n(&part[4 * n], count, reinterpret_cast<double *>(&sums[n]) + first);
        }
    }

    /// One element as the recovery sees it.
    struct Element
    {
      const std::array<unsigned int, 8> *nodes;
      Vector3                            centre;
      Stress                             stress;
      double                             volume;
      bool                               flowed;
    };

    Vector3
    reference_place(const LocalMesh &mesh, const unsigned int node)
    {
      return {mesh.reference[4 * node], mesh.reference[4 * node + 1], mesh.reference[4 * node + 2]};
    }

    std::vector<Element>
    elements_of(const Solid &solid, const PerBody<std::vector<Stress>> &stress)
    {
      std::vector<Element> elements;
      for (const Body body : both_bodies)
        {
          const ElementBlocks &blocks = solid.blocks[body];
          const auto           strain = element_plastic_strain(blocks);
          for (std::size_t e = 0; e < blocks.n_elements; ++e)
            {
              const auto &nodes = solid.mesh.cells[solid.block_cells[body][e]];
              Vector3     centre{};
              for (const unsigned int node : nodes)
                add(centre, 0.125, reference_place(solid.mesh, node));
              elements.push_back({&nodes, centre, stress[body][e], blocks.volume[e], strain[e] > 0});
            }
        }
      return elements;
    }

    std::vector<Moments>
    nodal_moments(const Solid &solid, const std::vector<Element> &elements, SharedSum &sum)
    {
      std::vector<Moments> moments(solid.mesh.n_nodes());
      for (const Element &element : elements)
        for (const unsigned int node : *element.nodes)
          {
            Moments      &m = moments[node];
            const Vector3 d = element.centre - reference_place(solid.mesh, node);
            const double  V = element.volume;
            m.volume += V;
            m.flowed += element.flowed ? V : 0;
            add(m.d, V, d);
            for (int k = 0; k < 6; ++k)
              {
                m.dd[k] += V * d[first_of[k]] * d[second_of[k]];
                m.s[k] += V * element.stress[k];
                for (int i = 0; i < 3; ++i)
                  m.sd[i][k] += V * element.stress[k] * d[i];
              }
          }
      sum_over_ranks(sum, moments);
      return moments;
    }

    /// Moments about the point that lies -r from the one of `m`, added to `all`.
    void
    add_moved(Moments &all, const Moments &m, const Vector3 &r)
    {
      all.volume += m.volume;
      add(all.d, 1, m.d);
      add(all.d, m.volume, r);
      for (int k = 0; k < 6; ++k)
        {
          const int i = first_of[k], j = second_of[k];
          all.dd[k] += m.dd[k] + m.d[i] * r[j] + r[i] * m.d[j] + m.volume * r[i] * r[j];
          all.s[k] += m.s[k];
          for (int l = 0; l < 3; ++l)
            all.sd[l][k] += m.sd[l][k] + m.s[k] * r[l];
        }
    }

    /// Slope of the plane through the stresses by least squares; zero where all centres lie in one layer.
    std::array<Stress, 3>
    slope(const Moments &m)
    {
      // spread of the centres about their mean, of the size V^(5/3), with a trifle that keeps a single layer
      // regular: half way between round-off and what would change a slope in the sixth digit
      double C[3][3];
      for (int k = 0; k < 6; ++k)
        C[first_of[k]][second_of[k]] = C[second_of[k]][first_of[k]] =
          m.dd[k] - m.d[first_of[k]] * m.d[second_of[k]] / m.volume;
      const double trifle = 1e-10 * std::pow(m.volume, 5. / 3);
      for (int i = 0; i < 3; ++i)
        C[i][i] += trifle;
      const Vector3 row[3] = {
        {C[0][0], C[0][1], C[0][2]}, {C[1][0], C[1][1], C[1][2]}, {C[2][0], C[2][1], C[2][2]}};
      const double          det        = dot(row[0], cross(row[1], row[2]));
      const Vector3         inverse[3] = {(1 / det) * cross(row[1], row[2]),
                                          (1 / det) * cross(row[2], row[0]),
                                          (1 / det) * cross(row[0], row[1])};
      std::array<Stress, 3> G{};
      for (int k = 0; k < 6; ++k)
        {
          Vector3 rhs;
          for (int i = 0; i < 3; ++i)
            rhs[i] = m.sd[i][k] - m.s[k] * m.d[i] / m.volume;
          for (int i = 0; i < 3; ++i)
            G[i][k] = dot(inverse[i], rhs);
        }
      return G;
    }

    std::vector<GradientSum>
    nodal_gradients(const Solid                &solid,
                    const std::vector<Element> &elements,
                    const std::vector<Moments> &moments,
                    SharedSum                  &sum)
    {
      std::vector<GradientSum> sums(solid.mesh.n_nodes());
      for (const Element &element : elements)
        {
          Moments around;
          for (const unsigned int node : *element.nodes)
            add_moved(around, moments[node], reference_place(solid.mesh, node) - element.centre);
          const std::array<Stress, 3> G = slope(around);
          for (const unsigned int node : *element.nodes)
            {
              const Vector3 d = element.centre - reference_place(solid.mesh, node);
              for (int i = 0; i < 3; ++i)
                for (int k = 0; k < 6; ++k)
                  {
                    sums[node].G[i][k] += element.volume * G[i][k];
                    sums[node].Gd[k] += element.volume * G[i][k] * d[i];
                  }
            }
        }
      sum_over_ranks(sum, sums);
      return sums;
    }

    /// Nodal stresses and gradients from the elements' stresses, and whether elements around a node have
    /// flowed.
    NodalStress
    recover(const Solid                &solid,
            const std::vector<Element> &elements,
            SharedSum                  &sum,
            std::vector<char>          &flowed)
    {
      const std::vector<Moments>     moments   = nodal_moments(solid, elements, sum);
      const std::vector<GradientSum> gradients = nodal_gradients(solid, elements, moments, sum);
      flowed.resize(solid.mesh.n_nodes());
      NodalStress result;
      result.stress.resize(6 * solid.mesh.n_nodes());
      result.gradient.resize(18 * solid.mesh.n_nodes());
      for (std::size_t node = 0; node < solid.mesh.n_nodes(); ++node)
        {
          const Moments &m = moments[node];
          flowed[node]     = m.flowed > 0;
          for (int k = 0; k < 6 && m.volume > 0; ++k)
            {
              result.stress[6 * node + k] = m.s[k] / m.volume;
              if (m.flowed > 0)
                continue;
              double slant = 0; // <G> <d>
              for (int i = 0; i < 3; ++i)
                {
                  const double G                         = gradients[node].G[i][k] / m.volume;
                  result.gradient[18 * node + 6 * i + k] = G;
                  slant += G * m.d[i] / m.volume;
                }
              result.stress[6 * node + k] -= 0.5 * (slant + gradients[node].Gd[k] / m.volume);
            }
        }
      return result;
    }

    /// Adds to the elements' stresses what the nodal ones do not give back at the centres, where no
    /// element around has flowed. What is missing there is about twice that at the nodes: three quarters of
    /// it leave a like part of both.
    void
    sharpen(const Solid             &solid,
            const NodalStress       &nodal,
            const std::vector<char> &flowed,
            std::vector<Element>    &elements)
    {
      constexpr double part = 0.75;
      for (Element &element : elements)
        {
          if (std::any_of(element.nodes->begin(), element.nodes->end(), [&](const unsigned int n) {
                return flowed[n];
              }))
            continue;
          Stress centre{};
          for (const unsigned int node : *element.nodes)
            {
              const Vector3 away = element.centre - reference_place(solid.mesh, node);
              for (int k = 0; k < 6; ++k)
                {
                  double change = 0;
                  for (int i = 0; i < 3; ++i)
                    change += nodal.gradient[18 * node + 6 * i + k] * away[i];
                  centre[k] += 0.125 * (nodal.stress[6 * node + k] + 0.5 * change);
                }
            }
          for (int k = 0; k < 6; ++k)
            element.stress[k] += part * (element.stress[k] - centre[k]);
        }
    }
  } // namespace


  NodalStress
  recovered_stress(const Solid &solid, const PerBody<std::vector<Stress>> &stress, MPI_Comm communicator)
  {
    SharedSum            sum(solid.mesh, communicator);
    std::vector<Element> elements = elements_of(solid, stress);
    std::vector<char>    flowed;
    sharpen(solid, recover(solid, elements, sum, flowed), flowed, elements);
    return recover(solid, elements, sum, flowed);
  }


  NodalStress
  nodal_stress(const Solid &solid, MPI_Comm communicator)
  {
    PerBody<std::vector<Stress>> stress;
    for (const Body body : both_bodies)
      stress[body] = element_stress(solid.blocks[body], solid.displacement.data());
    return recovered_stress(solid, stress, communicator);
  }
} // namespace wheelrail
