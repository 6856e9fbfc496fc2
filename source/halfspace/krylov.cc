#include <wheelrail/halfspace/krylov.h>

#include <cmath>

namespace wheelrail
{
  namespace
  {
    double
    dot(const std::vector<double> &a, const std::vector<double> &b)
    {
      double sum = 0;
      for (std::size_t k = 0; k < a.size(); ++k)
        sum += a[k] * b[k];
      return sum;
    }

    void
    add(const double factor, const std::vector<double> &a, std::vector<double> &b)
    {
      for (std::size_t k = 0; k < a.size(); ++k)
        b[k] += factor * a[k];
    }
  } // namespace

  int
  solve_gmres(const LinearMap           &A,
              const LinearMap           &M,
              const std::vector<double> &b,
              const double               tolerance,
              const int                  max_iterations,
              std::vector<double>       &x,
              double                    &reached)
  {
    x.assign(b.size(), 0.);
    reached           = 0;
    const double norm = std::sqrt(dot(b, b));
    if (norm == 0)
      return 0;
    std::vector<std::vector<double>> basis(1, b), h; // h[k]: column k of the triangle
    for (double &v : basis[0])
      v /= norm;
    std::vector<double> cosine, sine, rest(1, norm), z;
    int                 k = 0;
    for (; k < max_iterations && std::abs(rest[k]) > tolerance * norm; ++k)
      {
        std::vector<double> w, column(k + 2);
        // GMRES, preconditioned from the right (Saad and Schultz 1986): Arnoldi's basis by modified
        // Gram-Schmidt
        M(basis[k], z);
        A(z, w);
        for (int i = 0; i <= k; ++i)
          {
            column[i] = dot(w, basis[i]);
            add(-column[i], basis[i], w);
          }
        const double length = std::sqrt(dot(w, w));
        // Givens' rotations keep the triangle
        for (int i = 0; i < k; ++i)
          {
            const double upper = cosine[i] * column[i] + sine[i] * column[i + 1];
            column[i + 1]      = -sine[i] * column[i] + cosine[i] * column[i + 1];
            column[i]          = upper;
          }
        const double diagonal = std::hypot(column[k], length);
        if (diagonal == 0)
          break;
        cosine.push_back(column[k] / diagonal);
        sine.push_back(length / diagonal);
        column[k] = diagonal;
        column.pop_back();
        h.push_back(std::move(column));
        rest.push_back(-sine[k] * rest[k]);
        rest[k] *= cosine[k];
        if (length > 0)
          for (double &v : w)
            v /= length;
        basis.push_back(std::move(w));
      }
    std::vector<double> y(rest.begin(), rest.begin() + k), sum(b.size(), 0.);
    for (int i = k - 1; i >= 0; --i)
      {
        y[i] /= h[i][i];
        for (int j = 0; j < i; ++j)
          y[j] -= h[i][j] * y[i];
        add(y[i], basis[i], sum);
      }
    if (k > 0)
      M(sum, x);
    reached = std::abs(rest[k]) / norm;
    return k;
  }
} // namespace wheelrail
