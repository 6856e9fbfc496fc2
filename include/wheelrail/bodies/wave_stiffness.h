#pragma once

#include <wheelrail/base/vector3.h>
#include <wheelrail/bodies/section_mesh.h>
#include <wheelrail/material/elasticity.h>

#include <memory>
#include <vector>

namespace wheelrail
{
  /// A strip of the running surface under a uniform traction: whole edges of cells.
  struct SurfaceRow
  {
    Point2                    place; ///< its middle, on the running surface, in the frame of the section [m]
    double                    angle  = 0; ///< of the running direction there against x [rad]
    double                    width  = 0; ///< along the section [m]
    double                    radius = 0; ///< of a wheel: distance from the axle [m]; of a rail 0
    std::vector<unsigned int> edges;      ///< numbers in SectionMesh::running
  };

  /// Stiffness of a body whose section is the same all along, for displacements that go like a wave: 2.5-D
  /// finite elements (Gavric 1995; Nilsson, Jones, Thompson and Ryue 2009).
  ///
  /// Rail: u = (u_x, u_y, i w)(x, y) exp(i k z), k [1/m]. Wheel: the same around its axle with z = r theta
  /// and exp(i n theta); its section has the radius as second coordinate, u_y points outwards, and n takes
  /// the place of k. With the factor i the stiffness K = K0 + k K1 + k^2 K2 is real and symmetric.
  class WaveStiffness
  {
  public:
    /// `wheel`: a body of revolution; the y of its section is the distance from the axle.
    WaveStiffness(const SectionMesh &mesh, const Elasticity &elasticity, bool wheel);
    ~WaveStiffness();

    /// Number of displacements that are free.
    std::size_t
    size() const;

    /// The compliance between rows of the running surface: mean displacements (x, y, w) of all rows under
    /// unit tractions (x, y, and i times z) on each row per its width [m/(N/m), that is 1/Pa], a symmetric
    /// matrix of 3 m columns, row after row: value at 3 m (3 i + a) + 3 j + b. For a wheel the tractions are
    /// those for each metre along the circle of the row's own radius; between two rows the root of the
    /// product of their radii counts. Throws RunError where the body moves without strain at this k.
    std::vector<double>
    compliance(double k, const std::vector<SurfaceRow> &rows);

    /// Displacements (x, y, w) of all nodes of the section under forces (x, y, and i times z) on the rows,
    /// each spread evenly over its row: of a wave of 1 N for each metre along a rail [m/(N/m)], for each
    /// radian around a wheel [m/(N/rad)]. Throws RunError as compliance() does.
    std::vector<Vector3>
    displacements(double k, const std::vector<SurfaceRow> &rows, const std::vector<Vector3> &forces);

    /// Displacements (x, and outwards) of all nodes of a wheel that turns at `rate` [rad/s] with `density`
    /// [kg/m3]: under the centrifugal force rho rate^2 r [m].
    std::vector<Point2>
    growth(double rate, double density);

    /// The same in the mean over each row.
    std::vector<Point2>
    growth(double rate, double density, const std::vector<SurfaceRow> &rows);

  private:
    struct Data;
    std::unique_ptr<Data> data_;
  };

  /// Rows of `cells` edges each, from the ends inwards as many as there are.
  std::vector<SurfaceRow>
  surface_rows(const SectionMesh &mesh, unsigned int cells, bool wheel);
} // namespace wheelrail
