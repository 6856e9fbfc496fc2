#include <wheelrail/solid/patch_slopes.h>

#include <algorithm>
#include <cmath>

// Slopes of the stresses in the elements by least squares over the elements around them, from moments at the
// nodes, which ranks add up (doc/theory/element.md, Stresses at nodes).

namespace wheelrail::patches
{
  namespace
  {
    constexpr int first_of[6] = {0, 1, 2, 1, 0, 0}, second_of[6] = {0, 1, 2, 2, 2, 1};

    /// `share` of the moments about the point that lies -r from the one of `m`, added to `all`.
    void
    add_moved(Moments &all, const Moments &m, const Vector3 &r, const double share)
    {
      // Steiner's theorem for all moments: those about a node become those about the element's centre, so
      // that nodes give sums once, and each element adds eight of them
      all.volume += share * m.volume;
      add(all.d, share, m.d);
      add(all.d, share * m.volume, r);
      for (int k = 0; k < 6; ++k)
        {
          const int i = first_of[k], j = second_of[k];
          // (d + r)(d + r)' and s (d + r), from moments about the node
          all.dd[k] += share * (m.dd[k] + m.d[i] * r[j] + r[i] * m.d[j] + m.volume * r[i] * r[j]);
          all.s[k] += share * m.s[k];
          for (int l = 0; l < 3; ++l)
            all.sd[l][k] += share * (m.sd[l][k] + m.s[k] * r[l]);
        }
    }

    /// Slope of the plane through the stresses by least squares; zero where all centres lie in one layer.
    ElementGradient
    slope(const Moments &m)
    {
      // spread of the centres about their mean, of the size V^(5/3), with a trifle that keeps a single layer
      // regular: half way between round-off and what would change a slope in the sixth digit
      // G of element centres [Pa/m]: three unknown slopes for each of six stresses, one 3 x 3 matrix for all
      Rows C;
      for (int k = 0; k < 6; ++k)
        C[first_of[k]][second_of[k]] = C[second_of[k]][first_of[k]] =
          m.dd[k] - m.d[first_of[k]] * m.d[second_of[k]] / m.volume;
      const double trifle = 1e-10 * std::pow(m.volume, 5. / 3);
      for (int i = 0; i < 3; ++i)
        C[i][i] += trifle;
      // gradient.place is the middle of the patch seen from the element's centre: where this slope holds to
      // second order
      const Rows      of_spread = inverse(C);
      ElementGradient gradient{{}, (1 / m.volume) * m.d};
      for (int k = 0; k < 6; ++k)
        {
          Vector3 rhs;
          for (int i = 0; i < 3; ++i)
            // normal equations of s = s_0 + G (d - mean d), volumes as weights: C G = sum of V s d - (sum V
            // s)(sum V d)/V
            rhs[i] = m.sd[i][k] - m.s[k] * m.d[i] / m.volume;
          for (int i = 0; i < 3; ++i)
            gradient.G[i][k] = dot(of_spread[i], rhs);
        }
      return gradient;
    }

    /// How much a node counts in the patch of an element of this size: hardly, where its own elements lie to
    /// one side of it. Below a surface the layers then weigh the same, and least squares give the slope in
    /// their middle.
    double
    share_of(const Moments &m, const double size)
    {
      // distance of the mean centre of the node's cells from the node, in cells: 0 inside, 1/2 on a face of
      // cubes, where the share is 1e-4
      const double aside = norm(m.d) / (m.volume * size);
      return std::max(1e-4, 1 - 2.5 * aside);
    }
  } // namespace


  std::vector<Moments>
  nodal_moments(const LocalMesh &mesh, const std::vector<Element> &elements)
  {
    // sums are linear in the elements: ranks add theirs, and an element sees its whole patch though it lies
    // on several ranks
    std::vector<Moments> moments(mesh.n_nodes());
    for (const Element &element : elements)
      for (const unsigned int node : *element.nodes)
        {
          Moments &m = moments[node];
          // moments with the volume as weight, d from the node to the element's centre
          const Vector3 d = element.centre - mesh.place(node);
          const double  V = element.volume;
          m.volume += V;
          // volume of elements that have flowed: gradients would cross the edge of the plastic zone
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
    sum_over_ranks(mesh, moments);
    return moments;
  }


  double
  determinant(const Rows &row)
  {
    return dot(row[0], cross(row[1], row[2]));
  }

  Rows
  inverse(const Rows &row)
  {
    // of a symmetric matrix: columns of the cofactors may stand as rows
    const double det = determinant(row);
    return {(1 / det) * cross(row[1], row[2]),
            (1 / det) * cross(row[2], row[0]),
            (1 / det) * cross(row[0], row[1])};
  }


  std::vector<ElementGradient>
  element_gradients(const LocalMesh            &mesh,
                    const std::vector<Element> &elements,
                    const std::vector<Moments> &moments)
  {
    std::vector<ElementGradient> gradients;
    gradients.reserve(elements.size());
    for (const Element &element : elements)
      {
        Moments      around;
        const double size = std::cbrt(element.volume);
        for (const unsigned int node : *element.nodes)
          // patch of an element: all elements around its eight nodes, counted by their nodes
          add_moved(around, moments[node], mesh.place(node) - element.centre, share_of(moments[node], size));
        // inside, 27 elements of which the middle one counts eight times, its neighbours over faces four,
        // over edges two, over corners once
        gradients.push_back(slope(around));
      }
    return gradients;
  }
} // namespace wheelrail::patches
