#include <wheelrail/contactfiles/gap_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace wheelrail
{
  namespace
  {
    constexpr double no_gap = 1; // [m]

    CurveAt
    curve_of(const ProfileLine &line, const RigidMotion &to_track)
    {
      return [&](const double t) {
        const ProfileLine::Place p = line.at(t);
        return std::optional<Vector3>(to_track({0, p.y, p.z}));
      };
    }

    /// Where the gap passes the height between a cell and its neighbour, as a part of the step.
    double
    part_to(const GapMesh &mesh, const double height, const int cell, const int neighbour)
    {
      const double a = mesh.gap[std::size_t(cell)] - height, b = mesh.gap[std::size_t(neighbour)] - height;
      return b > a ? std::min(1., -a / (b - a)) : 0;
    }

    PatchPlace
    patch_of(const GapMesh &mesh, const double height, const std::vector<int> &cells)
    {
      PatchPlace patch;
      double     x = 0, y = 0, angle = 0;
      patch.x_low = patch.y_low = 1e9;
      patch.x_high = patch.y_high = -1e9;
      for (const int cell : cells)
        {
          const int    i = cell % mesh.nx, j = cell / mesh.nx;
          const double depth = height - mesh.gap[std::size_t(cell)], weight = std::max(depth * depth, 1e-30);
          const double here_x = mesh.x0 + i * mesh.dx, here_y = mesh.y0 + j * mesh.dy;
          patch.weight += weight;
          x += weight * here_x;
          y += weight * here_y;
          angle += weight * mesh.angle[std::size_t(j)];
          const auto reach = [&](const bool there, const int step) {
            return there ? part_to(mesh, height, cell, cell + step) : 0.;
          };
          patch.x_low       = std::min(patch.x_low, here_x - mesh.dx * reach(i > 0, -1));
          patch.x_high      = std::max(patch.x_high, here_x + mesh.dx * reach(i + 1 < mesh.nx, 1));
          const double low  = here_y - mesh.dy * reach(j > 0, -mesh.nx),
                       high = here_y + mesh.dy * reach(j + 1 < mesh.ny, mesh.nx);
          if (low < patch.y_low)
            {
              patch.y_low = low;
              patch.z_low = mesh.rail_z[std::size_t(cell)];
            }
          if (high > patch.y_high)
            {
              patch.y_high = high;
              patch.z_high = mesh.rail_z[std::size_t(cell)];
            }
        }
      patch.reference = {x / patch.weight, y / patch.weight, 0};
      patch.angle     = angle / patch.weight;
      return patch;
    }

    /// Cells below the height that hang together.
    std::vector<std::vector<int>>
    overlaps(const GapMesh &mesh, const double height)
    {
      std::vector<std::vector<int>> found;
      std::vector<char>             seen(mesh.gap.size(), 0);
      for (std::size_t start = 0; start < mesh.gap.size(); ++start)
        {
          if (seen[start] || mesh.gap[start] >= height)
            continue;
          std::vector<int> cells{int(start)};
          seen[start] = 1;
          for (std::size_t k = 0; k < cells.size(); ++k)
            for (int dj = -1; dj <= 1; ++dj)
              for (int di = -1; di <= 1; ++di)
                {
                  const int i = cells[k] % mesh.nx + di, j = cells[k] / mesh.nx + dj;
                  if (i < 0 || j < 0 || i >= mesh.nx || j >= mesh.ny)
                    continue;
                  const auto next = std::size_t(i) + std::size_t(mesh.nx) * std::size_t(j);
                  if (!seen[next] && mesh.gap[next] < height)
                    {
                      seen[next] = 1;
                      cells.push_back(int(next));
                    }
                }
          found.push_back(std::move(cells));
        }
      return found;
    }

    /// The inclinations of the section under the wheelset.
    void
    set_angles(const RigidMotion &to_track, const ProfileLine &section, GapMesh &mesh)
    {
      const auto n     = std::size_t(mesh.ny);
      const auto found = points_over(section.samples(), curve_of(section, to_track), mesh.y0, mesh.dy, n, -1);
      for (std::size_t j = 0; j < n; ++j)
        if (found[j])
          {
            const ProfileLine::Place p       = section.at(found[j]->t);
            const Vector3            tangent = to_track.turned({0, p.dy, p.dz});
            mesh.angle[j]                    = std::atan2(tangent[2], tangent[1]);
          }
    }

    /// Sets the reference on the rail and the ends of the patch as lengths from it.
    void
    set_on_section(PatchPlace &patch, const RigidMotion &to_track, const ProfileLine &line)
    {
      const CurveAt at = curve_of(line, to_track);
      const auto    on = [&](const double y) {
        const auto found  = points_over(line.samples(), at, y, 1, 1, -1);
        const bool beyond = y > (*at(line.end()))[1];
        return found[0] ? found[0]->t : beyond ? line.end() : 0.;
      };
      patch.line      = on(patch.reference[1]);
      const Vector3 p = *at(patch.line);
      patch.reference = {patch.reference[0], p[1], p[2]};
      patch.arc       = line.arc(patch.line);
      patch.s_low     = line.arc(on(patch.y_low)) - patch.arc;
      patch.s_high    = line.arc(on(patch.y_high)) - patch.arc;
    }
  } // namespace


  double
  GapMesh::least() const
  {
    return gap.empty() ? no_gap : *std::min_element(gap.begin(), gap.end());
  }


  GapMesh
  gap_mesh(const WheelRailPose &pose,
           const RailShape     &rail,
           const WheelShape    &wheel,
           const double         dx,
           const double         ds)
  {
    const RigidMotion to_track = then(pose.wheel, pose.wheelset);
    GapMesh           mesh;
    const double      half = pose.wheel_radius / 8;
    mesh.nx                = 2 * int(std::ceil(half / (1.5 * dx))) + 1;
    mesh.dx                = 2 * half / (mesh.nx - 1);
    mesh.x0                = to_track.move[0] - half;
    mesh.dy                = 0.75 * ds;
    std::vector<std::optional<ProfileLine>> sections;
    double                                  low = 1e9, high = -1e9;
    for (int i = 0; i < mesh.nx; ++i)
      {
        sections.push_back(rail.at(mesh.x0 + i * mesh.dx));
        if (!sections.back())
          continue;
        const CurveAt at = curve_of(*sections.back(), pose.rail);
        for (const double t : sections.back()->samples())
          {
            low  = std::min(low, (*at(t))[1]);
            high = std::max(high, (*at(t))[1]);
          }
      }
    if (high < low)
      return mesh;
    mesh.y0 = low;
    mesh.ny = int((high - low) / mesh.dy) + 1;
    mesh.gap.assign(std::size_t(mesh.nx) * std::size_t(mesh.ny), no_gap);
    mesh.rail_z.assign(mesh.gap.size(), 0.);
    mesh.angle.assign(std::size_t(mesh.ny), 0.);
    const auto n = std::size_t(mesh.ny);
    for (int i = 0; i < mesh.nx; ++i)
      {
        const auto &section = sections[std::size_t(i)];
        if (!section)
          continue;
        const double x = mesh.x0 + i * mesh.dx;
        const auto   on_rail =
          points_over(section->samples(), curve_of(*section, pose.rail), mesh.y0, mesh.dy, n, -1);
        const auto on_wheel = points_over(
          wheel.middle().samples(),
          [&](const double t) { return wheel_point(wheel, to_track, pose.wheel_radius, x, t); },
          mesh.y0,
          mesh.dy,
          n,
          1);
        for (std::size_t j = 0; j < n; ++j)
          if (on_rail[j])
            {
              const std::size_t cell = std::size_t(i) + std::size_t(mesh.nx) * j;
              mesh.rail_z[cell]      = on_rail[j]->place[2];
              if (on_wheel[j])
                mesh.gap[cell] = on_rail[j]->place[2] - on_wheel[j]->place[2];
            }
      }
    set_angles(pose.rail, rail.middle(), mesh);
    return mesh;
  }


  std::vector<PatchPlace>
  patch_places(const GapMesh         &mesh,
               const WheelRailPose   &pose,
               const RailShape       &rail,
               const ContactElements &elements)
  {
    std::vector<PatchPlace> patches;
    for (const std::vector<int> &cells : overlaps(mesh, pose.height))
      patches.push_back(patch_of(mesh, pose.height, cells));
    std::sort(patches.begin(), patches.end(), [](const PatchPlace &a, const PatchPlace &b) {
      return a.reference[1] > b.reference[1];
    });
    patches = joined_patches(std::move(patches), elements);
    for (PatchPlace &patch : patches)
      set_on_section(patch, pose.rail, rail.at(patch.reference[0]).value_or(rail.middle()));
    return patches;
  }
} // namespace wheelrail
