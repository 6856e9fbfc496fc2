#include <wheelrail/sampling/fields.h>
#include <wheelrail/solid/point_state.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Displacement of a node against the rigid motion of its body.
    Vector3
    deformation(const Solid &solid, const unsigned int n, const Axle::Motion &wheel)
    {
      const Vector3 X = solid.mesh.place(n);
      if (solid.mesh.node_body[n] == Body::rail)
        return solid.position(n) - X;
      return solid.position(n) - wheel(X);
    }

    /// Numbers the chosen nodes and fills points and fields.
    class FieldBuilder
    {
    public:
      explicit FieldBuilder(FieldMesh &mesh)
        : mesh_(mesh)
      {
      }

      /// Adds a cell of n nodes, which belong to one body.
      void
      cell(const unsigned int *nodes, const unsigned int n, const Body body)
      {
        mesh_.body.push_back(static_cast<std::uint8_t>(body == Body::wheel));
        for (unsigned int a = 0; a < n; ++a)
          {
            const auto [entry, fresh] = number_.try_emplace(nodes[a], nodes_.size());
            if (fresh)
              nodes_.push_back(nodes[a]);
            mesh_.cells.push_back(entry->second);
          }
      }

      /// Adds a field given by a function of the node that fills `components` numbers.
      template <typename Function>
      void
      field(const std::string &name,
            const std::string &unit,
            const unsigned int components,
            const Function    &value)
      {
        field_of(name, unit, components, [&](const std::size_t k, double *v) { value(nodes_[k], v); });
      }

      /// The same by a function of the place in nodes().
      template <typename Function>
      void
      field_of(const std::string &name,
               const std::string &unit,
               const unsigned int components,
               const Function    &value)
      {
        PointField field{name, unit, components, std::vector<double>(components * nodes_.size())};
        for (std::size_t k = 0; k < nodes_.size(); ++k)
          value(k, &field.values[components * k]);
        mesh_.fields.push_back(std::move(field));
      }

      const std::vector<unsigned int> &
      nodes() const
      {
        return nodes_;
      }

    private:
      FieldMesh                                     &mesh_;
      std::unordered_map<unsigned int, unsigned int> number_;
      std::vector<unsigned int>                      nodes_;
    };

    /// Cells of the finest level whose first vertex lies within the contact window along the track.
    void
    add_window_cells(FieldBuilder &builder, const Solid &solid, const Axle &axle, const Contact &contact)
    {
      const double reach =
        0.5 * (contact.window().rail.last - contact.window().rail.first) * contact.lattice().spacing_along;
      for (std::size_t c = 0; c < solid.mesh.cells.size(); ++c)
        {
          const Vector3 x = solid.position(solid.mesh.cells[c][0]);
          if (solid.mesh.cell_level[c] == solid.finest_level && std::abs(x[2] - axle.travelled()) < reach)
            builder.cell(solid.mesh.cells[c].data(), 8, solid.mesh.cell_body[c]);
        }
    }

    void
    copy(const Vector3 &v, double *to)
    {
      std::copy(v.begin(), v.end(), to);
    }

    /// Principal values of xx yy zz yz xz xy, largest first.
    Vector3
    principal_stresses(const double *s)
    {
      dealii::SymmetricTensor<2, 3> tensor;
      for (int d = 0; d < 3; ++d)
        tensor[d][d] = s[d];
      tensor[1][2] = s[3], tensor[0][2] = s[4], tensor[0][1] = s[5];
      const auto values = dealii::eigenvalues(tensor);
      return {values[0], values[1], values[2]};
    }

    /// Contact values of the surface nodes: those of the rail's own, and for the wheel's, which lie between
    /// them, interpolated, with tractions that act on the wheel.
    class ContactValues
    {
    public:
      ContactValues(const Solid &solid, const Contact &contact)
        : solid_(solid)
        , contact_(contact)
      {
        for (std::size_t k = 0; k < contact.rail().local.size(); ++k)
          if (contact.rail().local[k] >= 0)
            lattice_node_[contact.rail().local[k]] = k;
      }

      /// Pressure, traction, slip velocity of the wheel against the rail; zero away from the contact window.
      ContactNode
      at(const unsigned int n) const
      {
        if (solid_.mesh.node_body[n] == Body::wheel)
          return between(solid_.position(n));
        const auto found = lattice_node_.find(n);
        return found == lattice_node_.end() ? ContactNode() : contact_.nodes()[found->second];
      }

    private:
      ContactNode
      between(const Vector3 &x) const
      {
        const Lattice      &lattice = contact_.lattice();
        const ContactFrame &frame   = contact_.surfaces().frame;
        const Point2        t = frame.tangent(), n = frame.normal();
        const Vector3       d       = {x[0] - frame.origin.x, x[1] - frame.origin.y, x[2]};
        const double        row     = (d[0] * t.x + d[1] * t.y - lattice.s_begin) / lattice.spacing_lateral;
        const double        station = d[2] / lattice.spacing_along - lattice.first_station;
        const auto         &window  = contact_.window().rail;
        ContactNode         node;
        // the wheel's other side has the same row and station
        if (!(std::abs(d[0] * n.x + d[1] * n.y) < 20e-3 && station >= window.first &&
              station < window.last - 1 && row >= 0 && row < lattice.n_lateral - 1))
          return node;
        const int    i = int(station), j = int(row);
        const double u = station - i, v = row - j;
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b)
            {
              const ContactNode &corner = contact_.nodes()[lattice.index(i + a, j + b)];
              const double       weight = (a ? u : 1 - u) * (b ? v : 1 - v);
              node.pressure += weight * corner.pressure;
              add(node.traction, -weight, corner.traction);
              add(node.slip, weight, corner.slip);
            }
        return node;
      }

      const Solid                                  &solid_;
      const Contact                                &contact_;
      std::unordered_map<unsigned int, std::size_t> lattice_node_;
    };

    void
    add_contact_fields(FieldBuilder &builder, const Solid &solid, const Contact &contact)
    {
      const ContactValues      values(solid, contact);
      std::vector<ContactNode> found;
      for (const unsigned int n : builder.nodes())
        found.push_back(values.at(n));
      builder.field_of("pressure", "Pa", 1, [&](std::size_t k, double *v) { *v = found[k].pressure; });
      builder.field_of(
        "shear_traction", "Pa", 3, [&](std::size_t k, double *v) { copy(found[k].traction, v); });
      builder.field_of("slip_velocity", "m/s", 3, [&](std::size_t k, double *v) { copy(found[k].slip, v); });
    }

    /// Six components of the nodes' `stress`, in VTK's order.
    void
    add_tensor(FieldBuilder &builder, const std::string &name, const std::vector<double> &stress)
    {
      builder.field(name, "Pa", 6, [&](unsigned int n, double *v) {
        const double *s = &stress[6 * n]; // xx yy zz yz xz xy
        std::copy_n(s, 3, v);
        v[3] = s[5], v[4] = s[3], v[5] = s[4];
      });
    }

    void
    add_residual_fields(FieldBuilder &builder, const std::vector<double> &stress)
    {
      builder.field("residual_von_mises_stress", "Pa", 1, [&](unsigned int n, double *v) {
        *v = von_mises(&stress[6 * n]);
      });
      add_tensor(builder, "residual_stress", stress);
    }

    /// Plastic strain, and the stress in the rail where its z is below `unloaded` [m].
    void
    add_plastic_fields(FieldBuilder              &builder,
                       const Solid               &solid,
                       const std::vector<double> &stress,
                       const double               unloaded)
    {
      const auto strain = nodal_plastic_strain(solid);
      builder.field("plastic_strain", "1", 1, [&](unsigned int n, double *v) { *v = strain[n]; });
      builder.field("von_mises_stress_behind_wheel", "Pa", 1, [&](unsigned int n, double *v) {
        const bool free = solid.mesh.node_body[n] == Body::rail && solid.position(n)[2] < unloaded;
        *v              = free ? von_mises(&stress[6 * n]) : std::numeric_limits<double>::quiet_NaN();
      });
    }
  } // namespace


  PatchFields
  patch_fields(const Contact &contact, const Axle &axle, const double time)
  {
    const Lattice &lattice = contact.lattice();
    const auto    &window  = contact.window();
    const Point2   t       = contact.surfaces().frame.tangent();
    const double   along = axle.contact_along(), velocity = axle.velocity();
    PatchFields    patch;
    patch.time            = time;
    patch.rolled_distance = axle.travelled();
    patch.n_along         = window.rail.last - window.rail.first;
    patch.n_lateral       = lattice.n_lateral;
    for (int i = window.rail.first; i < window.rail.last; ++i)
      for (unsigned int j = 0; j < lattice.n_lateral; ++j)
        {
          const std::size_t  k    = lattice.index(i, j);
          const ContactNode &node = contact.nodes()[k];
          patch.along.push_back((lattice.first_station + i) * lattice.spacing_along - along);
          patch.lateral.push_back(lattice.s_begin + j * lattice.spacing_lateral);
          patch.gap.push_back(node.gap);
          patch.pressure.push_back(node.pressure);
          patch.traction_along.push_back(node.traction[2]);
          patch.traction_lateral.push_back(node.traction[0] * t.x + node.traction[1] * t.y);
          patch.slip_along.push_back(node.slip[2] / velocity);
          patch.slip_lateral.push_back((node.slip[0] * t.x + node.slip[1] * t.y) / velocity);
          patch.state.push_back(node.pressure <= 0 ? 0 : node.slipping ? 2 : 1);
          patch.area.push_back(contact.rail().area[k]);
        }
    return patch;
  }


  FieldMesh
  field_mesh(const Solid       &solid,
             const Axle        &axle,
             const Contact     &contact,
             const Selection    selection,
             const NodalStress &nodal,
             const double       unloaded,
             const NodalStress *residual)
  {
    FieldMesh    mesh;
    FieldBuilder builder(mesh);
    if (selection == Selection::all)
      for (std::size_t c = 0; c < solid.mesh.cells.size(); ++c)
        builder.cell(solid.mesh.cells[c].data(), 8, solid.mesh.cell_body[c]);
    else if (selection == Selection::window)
      add_window_cells(builder, solid, axle, contact);
    else
      {
        mesh.points_per_cell = 4;
        for (const auto &face : solid.mesh.faces)
          if (face.mark == Boundary::running && face.finest)
            builder.cell(face.nodes.data(), 4, solid.mesh.node_body[face.nodes[0]]);
      }
    for (const unsigned int n : builder.nodes())
      mesh.points.push_back(solid.position(n));
    const Axle::Motion wheel(axle);
    builder.field(
      "displacement", "m", 3, [&](unsigned int n, double *v) { copy(deformation(solid, n, wheel), v); });
    const std::vector<double> &stress = nodal.stress;
    if (selection == Selection::surface)
      add_contact_fields(builder, solid, contact);
    else
      {
        builder.field(
          "von_mises_stress", "Pa", 1, [&](unsigned int n, double *v) { *v = von_mises(&stress[6 * n]); });
        add_tensor(builder, "stress", stress);
        builder.field("principal_stresses", "Pa", 3, [&](unsigned int n, double *v) {
          copy(principal_stresses(&stress[6 * n]), v);
        });
      }
    if (solid.blocks.rail.plastic() || solid.blocks.wheel.plastic())
      add_plastic_fields(builder, solid, stress, axle.travelled() - unloaded);
    if (residual)
      add_residual_fields(builder, residual->stress);
    return mesh;
  }


  double
  unloaded_distance(const Model &model)
  {
    return 4 * model.reach;
  }
} // namespace wheelrail
