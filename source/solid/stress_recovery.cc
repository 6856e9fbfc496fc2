#include <wheelrail/solid/patch_slopes.h>
#include <wheelrail/solid/point_state.h>
#include <wheelrail/solid/stress_recovery.h>

#include <cmath>

// Nodal stresses (doc/theory/element.md, Stresses at nodes): 1. slopes of elements; 2. their means at nodes;
// 3. how slopes change, H, for elements at surfaces; 4. mean stress of a node less its slope times the
// distance of the mean centre; 5. what nodes do not give back at the centres, once more. Means alone would be
// 18 % too low at the surface of a Hertzian contact on 1 mm cells, this is 2 %.

namespace wheelrail
{
  namespace
  {
    using namespace patches;

    /// Sums over the elements around a node: gradients of stress, G d, and where the gradients were taken,
    /// from the node.
    struct GradientSum
    {
      std::array<Stress, 3> G{};
      Stress                Gd{};
      Vector3               place{};
    };

    /// Sums over the elements around a node of what G changes from the middle of its patch to the centre, of
    /// that times d, and of its change from the node to the mean centre.
    struct BendSum
    {
      std::array<Stress, 3> G{};
      Stress                Gd{};
      std::array<Stress, 3> to_mean{};
    };

    std::vector<Element>
    elements_of(const Solid &solid, const PerBody<std::vector<Stress>> &stress)
    {
      std::vector<Element> elements;
      for (const Body body : both_bodies)
        {
          const ElementBlocks &blocks = solid.blocks[body];
          // stress of an element belongs to its centre, the mean of its vertices, in the reference
          // configuration
          const auto strain = element_plastic_strain(blocks);
          for (std::size_t e = 0; e < blocks.n_elements; ++e)
            {
              const auto &nodes = solid.mesh.cells[solid.block_cells[body][e]];
              Vector3     centre{};
              for (const unsigned int node : nodes)
                add(centre, 0.125, solid.mesh.place(node));
              elements.push_back({&nodes, centre, stress[body][e], blocks.volume[e], strain[e] > 0});
            }
        }
      return elements;
    }

    std::vector<GradientSum>
    nodal_gradients(const Solid                        &solid,
                    const std::vector<Element>         &elements,
                    const std::vector<ElementGradient> &gradients)
    {
      // mean(G) and mean(G d) of the header, times V; place: mean of where the G hold, from the node
      std::vector<GradientSum> sums(solid.mesh.n_nodes());
      for (std::size_t e = 0; e < elements.size(); ++e)
        for (const unsigned int node : *elements[e].nodes)
          {
            const Element &element = elements[e];
            const Vector3  d       = element.centre - solid.mesh.place(node);
            GradientSum   &all     = sums[node];
            add(all.place, element.volume, d + gradients[e].place);
            for (int i = 0; i < 3; ++i)
              for (int k = 0; k < 6; ++k)
                {
                  all.G[i][k] += element.volume * gradients[e].G[i][k];
                  // sums of V G and V G d over the elements around the node; the gradient belongs to the
                  // middle of its patch
                  all.Gd[k] += element.volume * gradients[e].G[i][k] * d[i];
                }
          }
      sum_over_ranks(solid.mesh, sums);
      return sums;
    }

    /// How the gradient of stress changes in an element, H, by least squares from the means at its nodes and
    /// the places where these are met; zero along directions in which they do not differ.
    class Bend
    {
    public:
      Bend(const Solid                    &solid,
           const Element                  &element,
           const std::vector<Moments>     &moments,
           const std::vector<GradientSum> &gradients)
      {
        // 1. Where the mean G of each vertex of the element holds, from the element's centre
        std::array<Vector3, 8> place;
        Vector3                middle{};
        for (int v = 0; v < 8; ++v)
          {
            const unsigned int n = (*element.nodes)[v];
            place[v]             = solid.mesh.place(n) - element.centre;
            add(place[v], 1 / moments[n].volume, gradients[n].place);
            add(middle, 0.125, place[v]);
          }
        const double trifle = 1e-6 * std::pow(element.volume, 2. / 3);
        // H by least squares from eight nodes: G_v = G_0 + H (place_v - middle)
        // 2. Normal matrix of eight points; `trifle` keeps a layer of one element regular
        Rows spread = {{{trifle, 0, 0}, {0, trifle, 0}, {0, 0, trifle}}};
        for (int v = 0; v < 8; ++v)
          for (int i = 0; i < 3; ++i)
            add(spread[i], (place[v] - middle)[i], place[v] - middle);
        if (determinant(spread) < least_spread * element.volume * element.volume)
          return;
        // 3. H_[l] = dG/dx_l = sum over l' of spread^-1_ll' (place - middle)_l' G_v
        const Rows of_spread = inverse(spread);
        for (int v = 0; v < 8; ++v)
          {
            const unsigned int n    = (*element.nodes)[v];
            const Vector3      away = place[v] - middle;
            for (int l = 0; l < 3; ++l)
              {
                const double share = dot(of_spread[l], away) / moments[n].volume;
                for (int i = 0; i < 3; ++i)
                  for (int k = 0; k < 6; ++k)
                    H_[l][i][k] += share * gradients[n].G[i][k];
              }
          }
      }

      /// H r.
      std::array<Stress, 3>
      along(const Vector3 &r) const
      {
        std::array<Stress, 3> change{};
        for (int l = 0; l < 3; ++l)
          for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 6; ++k)
              change[i][k] += H_[l][i][k] * r[l];
        return change;
      }

    private:
      /// Product of the spreads of the places along three directions, over the volume squared: 8 inside of
      /// even cells, 1/8 below a face and 1/512 in a corner. Below, as at the edge of a rail's foot, small
      /// differences of gradients would be met at nearly the same place and make stresses of gigapascals.
      static constexpr double least_spread = 1e-3;

      std::array<std::array<Stress, 3>, 3> H_{};
    };

    /// Of elements whose patch lies to one side of them, at surfaces and where cells of two sizes meet.
    std::vector<BendSum>
    nodal_bends(const Solid                        &solid,
                const std::vector<Element>         &elements,
                const std::vector<ElementGradient> &gradients,
                const std::vector<Moments>         &moments,
                const std::vector<GradientSum>     &sums)
    {
      constexpr double     aside = 0.02; // of the cell's size
      std::vector<BendSum> bends(solid.mesh.n_nodes());
      for (std::size_t e = 0; e < elements.size(); ++e)
        {
          const Element &element = elements[e];
          // inside of even cells the middle of the patch is the centre, and G needs no correction
          if (norm(gradients[e].place) < aside * std::cbrt(element.volume))
            continue;
          const Bend bend(solid, element, moments, sums);
          // G at the element's centre = G of the patch - H (middle of the patch less centre)
          const std::array<Stress, 3> change = bend.along(-1. * gradients[e].place);
          for (const unsigned int node : *element.nodes)
            {
              const Vector3 d       = element.centre - solid.mesh.place(node);
              const auto    to_mean = bend.along((1 / moments[node].volume) * moments[node].d);
              for (int i = 0; i < 3; ++i)
                for (int k = 0; k < 6; ++k)
                  {
                    bends[node].G[i][k] += element.volume * change[i][k];
                    bends[node].Gd[k] += element.volume * change[i][k] * d[i];
                    bends[node].to_mean[i][k] += element.volume * to_mean[i][k];
                  }
            }
        }
      sum_over_ranks(solid.mesh, bends);
      return bends;
    }

    /// Nodal stresses and gradients from the elements' stresses; means alone where elements around a node
    /// have flowed.
    NodalStress
    recover(const Solid &solid, const std::vector<Element> &elements)
    {
      const std::vector<Moments>         moments     = nodal_moments(solid.mesh, elements);
      const std::vector<ElementGradient> of_elements = element_gradients(solid.mesh, elements, moments);
      const std::vector<GradientSum>     gradients   = nodal_gradients(solid, elements, of_elements);
      const std::vector<BendSum> bends = nodal_bends(solid, elements, of_elements, moments, gradients);
      NodalStress                result;
      result.stress.resize(6 * solid.mesh.n_nodes());
      result.gradient.resize(18 * solid.mesh.n_nodes());
      for (std::size_t node = 0; node < solid.mesh.n_nodes(); ++node)
        {
          const Moments &m = moments[node];
          for (int k = 0; k < 6 && m.volume > 0; ++k)
            {
              result.stress[6 * node + k] = m.s[k] / m.volume;
              if (m.flowed > 0)
                continue;
              double slant = 0, bend = 0; // <G> <d>, <d> <H> <d>
              for (int i = 0; i < 3; ++i)
                {
                  // s(node) = mean s - slope times mean d. Where G changes by H, half of <G> <d> + <G d> with
                  // the bend taken off is exact for quadratic stresses on even cells (doc/theory/element.md,
                  // Stresses at nodes).
                  // mean(G), moved to the centres of the elements
                  const double G       = (gradients[node].G[i][k] + bends[node].G[i][k]) / m.volume;
                  const double to_mean = bends[node].to_mean[i][k] / m.volume;
                  // slope at the node itself: mean slope at the centres, less H times the mean distance
                  result.gradient[18 * node + 6 * i + k] = G - to_mean;
                  slant += G * m.d[i] / m.volume;
                  bend += to_mean * m.d[i] / m.volume;
                }
              const double Gd = (gradients[node].Gd[k] + bends[node].Gd[k]) / m.volume;
              result.stress[6 * node + k] -= 0.5 * (slant + Gd - bend);
            }
        }
      return result;
    }

    /// Adds to the elements' stresses what the nodal ones do not give back at the centres. What is missing
    /// there is about twice that at the nodes: three quarters of it leave a like part of both.
    void
    sharpen(const Solid &solid, const NodalStress &nodal, std::vector<Element> &elements)
    {
      constexpr double part = 0.75;
      for (Element &element : elements)
        {
          Stress centre{};
          for (const unsigned int node : *element.nodes)
            {
              const Vector3 away = element.centre - solid.mesh.place(node);
              for (int k = 0; k < 6; ++k)
                {
                  double change = 0;
                  for (int i = 0; i < 3; ++i)
                    // mean over eight nodes of s + G d/2: from a quadratic field, its value at the centre
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
  recovered_stress(const Solid &solid, const PerBody<std::vector<Stress>> &stress)
  {
    // twice: the second time from stresses that have got back what the first one flattened
    std::vector<Element> elements = elements_of(solid, stress);
    sharpen(solid, recover(solid, elements), elements);
    return recover(solid, elements);
  }


  NodalStress
  nodal_stress(const Solid &solid)
  {
    PerBody<std::vector<Stress>> stress;
    for (const Body body : both_bodies)
      stress[body] = element_stress(solid.blocks[body], solid.displacement.data());
    return recovered_stress(solid, stress);
  }
} // namespace wheelrail
