#include <wheelrail/base/errors.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>
#include <wheelrail/output/vtu.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <filesystem>
#include <sstream>
#include <tuple>

namespace wheelrail
{
  namespace
  {
    using dealii::DataOutBase::VtkFlags;
    using Ranges = std::vector<std::tuple<unsigned int,
                                          unsigned int,
                                          std::string,
                                          dealii::DataComponentInterpretation::DataComponentInterpretation>>;

    /// What does not fit together in the arrays, or an empty string.
    std::string
    inconsistency(const FieldMesh &mesh)
    {
      if (mesh.points_per_cell != 4 && mesh.points_per_cell != 8)
        return "cells of " + std::to_string(mesh.points_per_cell) + " points (accepted: 4 or 8)";
      if (mesh.cells.size() % mesh.points_per_cell != 0)
        return "a cell list of " + std::to_string(mesh.cells.size()) + " numbers, no multiple of " +
               std::to_string(mesh.points_per_cell);
      for (const unsigned int point : mesh.cells)
        if (point >= mesh.points.size())
          return "a cell that uses point " + std::to_string(point) + " of " +
                 std::to_string(mesh.points.size());
      for (const PointField &field : mesh.fields)
        {
          if (field.components != 1 && field.components != 3)
            return "field " + field.name + " with " + std::to_string(field.components) +
                   " components (accepted: 1 or 3)";
          if (field.values.size() != field.components * mesh.points.size())
            return "field " + field.name + " with " + std::to_string(field.values.size()) + " values for " +
                   std::to_string(mesh.points.size()) + " points";
        }
      return "";
    }

    template <int dim>
    std::vector<dealii::DataOutBase::Patch<dim, 3>>
    make_patches(const FieldMesh &mesh)
    {
      constexpr unsigned int n_points = 1u << dim;
      const std::size_t      n_cells  = mesh.cells.size() / n_points;
      unsigned int           n_values = 0;
      for (const PointField &field : mesh.fields)
        n_values += field.components;

      std::vector<dealii::DataOutBase::Patch<dim, 3>> patches(n_cells);
      for (std::size_t cell = 0; cell < n_cells; ++cell)
        {
          auto &patch          = patches[cell];
          patch.patch_index    = static_cast<unsigned int>(cell);
          patch.n_subdivisions = 1;
          patch.reference_cell = dealii::ReferenceCells::get_hypercube<dim>();
          patch.data.reinit(n_values, n_points);
          for (unsigned int q = 0; q < n_points; ++q)
            {
              const unsigned int point = mesh.cells[cell * n_points + q];
              for (unsigned int d = 0; d < 3; ++d)
                patch.vertices[q][d] = mesh.points[point][d];
              unsigned int row = 0;
              for (const PointField &field : mesh.fields)
                for (unsigned int c = 0; c < field.components; ++c)
                  patch.data(row++, q) =
                    static_cast<float>(field.values[std::size_t(point) * field.components + c]);
            }
        }
      return patches;
    }

    /// One <Piece> of the file: the part of this rank; empty without cells.
    template <int dim>
    std::string
    make_piece(const FieldMesh &mesh, const VtkFlags &flags)
    {
      if (mesh.cells.empty())
        return "";
      std::vector<std::string> names;
      Ranges                   vectors;
      for (const PointField &field : mesh.fields)
        {
          if (field.components == 3)
            vectors.emplace_back(names.size(),
                                 names.size() + 2,
                                 field.name,
                                 dealii::DataComponentInterpretation::component_is_part_of_vector);
          names.insert(names.end(), field.components, field.name);
        }
      std::ostringstream piece;
      dealii::DataOutBase::write_vtu_main(make_patches<dim>(mesh), names, vectors, flags, piece);
      return piece.str();
    }
  } // namespace

  void
  write_vtu(const FieldMesh &mesh, const std::string &folder, const std::string &name, MPI_Comm comm)
  {
    const std::string path   = folder + "/" + name + ".vtu";
    const std::string wrong  = inconsistency(mesh);
    const auto        wrongs = dealii::Utilities::MPI::all_gather(comm, wrong);
    for (unsigned int rank = 0; rank < wrongs.size(); ++rank)
      if (!wrongs[rank].empty())
        throw RunError("The fields for \"" + path + "\" do not fit together: rank " + std::to_string(rank) +
                       " holds " + wrongs[rank] + ".");

    VtkFlags flags;
    flags.compression_level = VtkFlags::ZlibCompressionLevel::best_speed;
    for (const PointField &field : mesh.fields)
      flags.physical_units[field.name] = field.unit;

    // The parts are small once compressed. Through rank 0 they need no parallel file system, and a
    // full disk is reported with its reason.
    const auto pieces = dealii::Utilities::MPI::gather(
      comm, mesh.points_per_cell == 8 ? make_piece<3>(mesh, flags) : make_piece<2>(mesh, flags));
    on_root(comm, [&]() {
      std::ostringstream file;
      dealii::DataOutBase::write_vtu_header(file, flags);
      for (const std::string &piece : pieces)
        file << piece;
      dealii::DataOutBase::write_vtu_footer(file);
      replace_file(path, file.str());
    });
  }

  PvdSeries::PvdSeries(std::string path)
    : path_(std::move(path))
  {
  }

  void
  PvdSeries::add(const double time, const std::string &file)
  {
    while (!entries_.empty() && entries_.back().first >= time)
      entries_.pop_back();
    entries_.emplace_back(time, file);

    std::ostringstream text;
    dealii::DataOutBase::write_pvd_record(text, entries_);
    replace_file(path_, text.str());
  }

  void
  PvdSeries::load(const std::size_t keep)
  {
    entries_.clear();
    if (!std::filesystem::exists(path_))
      return;
    std::istringstream          text(read_whole_file(path_));
    boost::property_tree::ptree tree;
    try
      {
        boost::property_tree::read_xml(text, tree);
        for (const auto &child : tree.get_child("VTKFile.Collection"))
          if (child.first == "DataSet" && entries_.size() < keep)
            entries_.emplace_back(child.second.get<double>("<xmlattr>.timestep"),
                                  child.second.get<std::string>("<xmlattr>.file"));
      }
    catch (const boost::property_tree::ptree_error &error)
      {
        throw RunError("The series file \"" + path_ + "\" is not a readable .pvd file: " + error.what() +
                       ". Delete it, or start without --resume.");
      }
  }
} // namespace wheelrail
