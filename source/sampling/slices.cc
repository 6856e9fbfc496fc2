#include <wheelrail/sampling/fields.h>
#include <wheelrail/sampling/probes.h>
#include <wheelrail/sampling/slices.h>
#include <wheelrail/solid/point_state.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// Where a slice runs over the lattice of the contact: nodes at both sides of every point of the line,
    /// and the weight of the second.
    struct Line
    {
      std::vector<double>                     position;
      std::vector<std::array<std::size_t, 2>> nodes;
      double                                  weight = 0, offset = 0;
    };

    /// The row of points along the track at lateral coordinate s.
    Line
    line_along(const Contact &contact, const double travelled, const double s)
    {
      const Lattice &lattice = contact.lattice();
      const double   row     = (s - lattice.s_begin) / lattice.spacing_lateral;
      const int      last    = static_cast<int>(lattice.n_lateral) - 2;
      const int      j       = std::clamp(static_cast<int>(std::floor(row)), 0, last);
      Line           line;
      line.weight = row - j, line.offset = s;
      for (int i = contact.window().rail.first; i < contact.window().rail.last; ++i)
        {
          line.position.push_back((lattice.first_station + i) * lattice.spacing_along - travelled);
          line.nodes.push_back({lattice.index(i, j), lattice.index(i, j + 1)});
        }
      return line;
    }

    /// The row of points across the track at `along` ahead of the axle.
    Line
    line_across(const Contact &contact, const double travelled, const double along)
    {
      const Lattice &lattice = contact.lattice();
      const double   station = (travelled + along) / lattice.spacing_along - lattice.first_station;
      const int      i       = std::clamp(
        static_cast<int>(std::floor(station)), contact.window().rail.first, contact.window().rail.last - 2);
      Line line;
      line.weight = station - i, line.offset = along;
      for (unsigned int j = 0; j < lattice.n_lateral; ++j)
        {
          line.position.push_back(lattice.s_begin + j * lattice.spacing_lateral);
          line.nodes.push_back({lattice.index(i, j), lattice.index(i + 1, j)});
        }
      return line;
    }

    /// The points of a slice: from the deformed surface into the body, NaN where the wheel has no surface in
    /// front of the rail's.
    std::vector<Vector3>
    points_below(const Contact &contact, const Line &line, const Body body, const std::vector<double> &depths)
    {
      const Point2         n      = contact.surfaces().frame.normal();
      const Vector3        normal = {n.x, n.y, 0};
      const double         w      = line.weight;
      std::vector<Vector3> points;
      for (const auto &[a, b] : line.nodes)
        {
          Vector3 top = (1 - w) * contact.rail_position(a) + w * contact.rail_position(b);
          if (body == Body::wheel)
            {
              const double gap = (1 - w) * contact.nodes()[a].gap + w * contact.nodes()[b].gap;
              add(top, std::max(gap, 0.), normal);
              // without a facet in front of it a node has a gap of its own: no point there
              if (!(gap < depth_of_slices))
                top[0] = std::numeric_limits<double>::quiet_NaN();
            }
          for (const double depth : depths)
            points.push_back(top + (body == Body::wheel ? depth : -depth) * normal);
        }
      return points;
    }

    std::vector<double>
    depths(const Contact &contact)
    {
      std::vector<double> depths;
      const double        step = 0.5 * contact.lattice().spacing_along;
      for (double depth = 0; depth < depth_of_slices + 0.5 * step; depth += step)
        depths.push_back(depth);
      return depths;
    }

    /// Of each cell, of those of the other body 0 [1].
    std::vector<double>
    plastic_strain_of_cells(const Solid &solid, const Body body)
    {
      std::vector<double> strain(solid.mesh.cells.size(), 0.);
      const auto          of_elements = element_plastic_strain(solid.blocks[body]);
      for (std::size_t e = 0; e < of_elements.size(); ++e)
        strain[solid.block_cells[body][e]] = of_elements[e];
      return strain;
    }

    /// The slice of a line with the values at its points.
    Slice
    cut(const Model &model, const Line &line, const Body body, const Probes &probes, const NodalStress &nodal)
    {
      Slice slice;
      slice.offset   = line.offset;
      slice.position = line.position;
      slice.depth    = depths(*model.contact);
      slice.values.resize(7);
      for (const auto &stress : probe_stress(probes, model.solid.mesh, nodal))
        {
          slice.values[slice_von_mises].push_back(von_mises(stress.data()));
          for (int k = 0; k < 6; ++k)
            slice.values[slice_stress_xx + k].push_back(stress[k]);
        }
      if (model.solid.blocks[body].plastic())
        slice.values.push_back(probe_cells(probes, plastic_strain_of_cells(model.solid, body)));
      return slice;
    }

    /// Node of the largest pressure: lateral coordinate and position ahead of the axle [m].
    std::array<double, 2>
    place_of_peak(const Contact &contact, const double travelled)
    {
      const Lattice        &lattice = contact.lattice();
      std::array<double, 2> place{0, 0};
      double                largest = 0;
      for (int i = contact.window().rail.first; i < contact.window().rail.last; ++i)
        for (unsigned int j = 0; j < lattice.n_lateral; ++j)
          if (const double p = contact.nodes()[lattice.index(i, j)].pressure; p > largest)
            {
              largest = p;
              place   = {lattice.s_begin + j * lattice.spacing_lateral,
                         (lattice.first_station + i) * lattice.spacing_along - travelled};
            }
      return place;
    }

    /// A row of points on the undeformed surface of the rail that was rolled over: position as in a slice,
    /// place [m].
    struct RailRow
    {
      Line                 line;
      std::vector<Vector3> top;
    };

    /// Surface of the mesh between rows j and j + 1 of the lattice, at Z: the same all along the rail.
    Vector3
    rail_top(const Contact &contact, const int j, const double weight, const double z)
    {
      const auto    &X    = contact.rail().reference;
      const Lattice &rows = contact.lattice();
      Vector3        top  = X[rows.index(0, j)];
      if (weight > 0)
        top = (1 - weight) * top + weight * X[rows.index(0, j + 1)];
      top[2] = z;
      return top;
    }

    /// Along the rolled rail from the start to `unloaded` behind the axle, by the spacing of the lattice,
    /// which itself may have gone on with the wheel.
    RailRow
    row_behind(const Contact &contact, const double travelled, const double s, const double unloaded)
    {
      const Lattice &lattice = contact.lattice();
      const Line     here    = line_along(contact, travelled, s);
      const int      j       = static_cast<int>(here.nodes.front()[0] % lattice.n_lateral);
      RailRow        row;
      row.line.offset = s;
      for (int i = 0; i * lattice.spacing_along < travelled - unloaded; ++i)
        {
          row.line.position.push_back(i * lattice.spacing_along - travelled);
          row.top.push_back(rail_top(contact, j, here.weight, i * lattice.spacing_along));
        }
      return row;
    }

    /// Across the rail at the last point of a row along it.
    RailRow
    row_across_end(const Contact &contact, const RailRow &along)
    {
      const Lattice &lattice = contact.lattice();
      RailRow        row;
      row.line.offset = along.line.position.back();
      for (unsigned int j = 0; j < lattice.n_lateral; ++j)
        {
          row.line.position.push_back(lattice.s_begin + j * lattice.spacing_lateral);
          row.top.push_back(rail_top(contact, static_cast<int>(j), 0, along.top.back()[2]));
        }
      return row;
    }

    /// The points of a slice of the unloaded rail: from its undeformed surface down. The first ones lie a
    /// twentieth of a spacing deep, since the fine zone is lower than that surface.
    std::vector<Vector3>
    points_behind(const Contact &contact, const RailRow &row)
    {
      const Point2         n      = contact.surfaces().frame.normal();
      const Vector3        normal = {n.x, n.y, 0};
      const double         least  = 0.05 * contact.lattice().spacing_along;
      std::vector<Vector3> points;
      for (const Vector3 &top : row.top)
        for (const double depth : depths(contact))
          points.push_back(top - std::max(depth, least) * normal);
      return points;
    }
  } // namespace


  std::vector<Slice>
  make_slices(const Model &model, const NodalStress &nodal, const double travelled, MPI_Comm communicator)
  {
    const Contact                      &contact  = *model.contact;
    const auto                          peak     = place_of_peak(contact, travelled);
    const std::pair<const char *, Line> lines[4] = {{"AA", line_along(contact, travelled, 0)},
                                                    {"BB", line_across(contact, travelled, 0)},
                                                    {"AA_peak", line_along(contact, travelled, peak[0])},
                                                    {"BB_peak", line_across(contact, travelled, peak[1])}};
    std::vector<Slice>                  slices;
    for (const auto &[name, line] : lines)
      for (const Body body : both_bodies)
        {
          const auto points = points_below(contact, line, body, depths(contact));
          const auto probes = find_probes(model.solid, body, points, communicator);
          slices.push_back(cut(model, line, body, probes, nodal));
          slices.back().name = std::string(name) + "_" + body_name(body);
        }
    if (model.solid.blocks.rail.plastic())
      for (Slice &slice : slices_behind(model, nodal, travelled, unloaded_distance(model), communicator))
        slices.push_back(std::move(slice));
    return slices;
  }


  std::vector<Slice>
  slices_behind(const Model               &model,
                const NodalStress         &nodal,
                const double               travelled,
                const double               behind,
                MPI_Comm                   communicator,
                const std::vector<double> *forward)
  {
    const Contact     &contact = *model.contact;
    const double       s       = place_of_peak(contact, travelled)[0];
    const RailRow      along   = row_behind(contact, travelled, s, behind);
    std::vector<Slice> slices;
    if (along.top.size() < 2)
      return slices;
    const RailRow across = row_across_end(contact, along);
    for (const auto &[name, row] : {std::make_pair("AA_behind_rail", &along), {"BB_behind_rail", &across}})
      {
        const auto probes = find_probes(model.solid, Body::rail, points_behind(contact, *row), communicator);
        slices.push_back(cut(model, row->line, Body::rail, probes, nodal));
        slices.back().name     = name;
        slices.back().unloaded = true;
        if (forward != nullptr)
          slices.back().forward_shear = probe_nodes(probes, model.solid.mesh, *forward);
      }
    return slices;
  }
} // namespace wheelrail
