#include <wheelrail/base/errors.h>
#include <wheelrail/base/gather_all.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>
#include <wheelrail/output/vtu.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace wheelrail
{
  namespace
  {
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
      if (!mesh.body.empty() && mesh.body.size() * mesh.points_per_cell != mesh.cells.size())
        return "a body for " + std::to_string(mesh.body.size()) + " cells of " +
               std::to_string(mesh.cells.size() / mesh.points_per_cell);
      for (const PointField &field : mesh.fields)
        {
          if (field.components != 1 && field.components != 3 && field.components != 6)
            return "field " + field.name + " with " + std::to_string(field.components) +
                   " components (accepted: 1, 3 or 6)";
          if (field.values.size() != field.components * mesh.points.size())
            return "field " + field.name + " with " + std::to_string(field.values.size()) + " values for " +
                   std::to_string(mesh.points.size()) + " points";
        }
      return "";
    }

    /// Numbers as VTK reads them: zlib at its fastest level in one block, in base64, with the sizes in front.
    template <typename Number>
    std::string
    packed(const std::vector<Number> &values)
    {
      const uLong                bytes = values.size() * sizeof(Number);
      uLong                      size  = compressBound(bytes);
      std::vector<unsigned char> data(size);
      if (compress2(
            data.data(), &size, reinterpret_cast<const Bytef *>(values.data()), bytes, Z_BEST_SPEED) != Z_OK)
        throw std::logic_error("zlib: a buffer that is too small");
      data.resize(size);
      const std::uint32_t sizes[4] = {1, std::uint32_t(bytes), std::uint32_t(bytes), std::uint32_t(size)};
      std::vector<unsigned char> header(sizeof sizes);
      std::memcpy(header.data(), sizes, sizeof sizes);
      return dealii::Utilities::encode_base64(header) + dealii::Utilities::encode_base64(data);
    }

    template <typename Number>
    void
    write_array(std::ostream              &out,
                const std::string         &type,
                const std::string         &attributes,
                const std::vector<Number> &values)
    {
      out << "<DataArray type=\"" << type << "\"" << attributes << " format=\"binary\">\n"
          << packed(values) << "\n</DataArray>\n";
    }

    /// Name, number of components with their names, and unit of a field.
    std::string
    attributes_of(const PointField &field)
    {
      std::string text = " Name=\"" + field.name + "\"";
      if (field.components > 1)
        text += " NumberOfComponents=\"" + std::to_string(field.components) + "\"";
      if (field.components == 6) // VTK's order of a symmetric tensor
        for (const auto &[number, name] :
             {std::pair(0, "XX"), {1, "YY"}, {2, "ZZ"}, {3, "XY"}, {4, "YZ"}, {5, "XZ"}})
          text += " ComponentName" + std::to_string(number) + "=\"" + name + "\"";
      return text + " units=\"" + field.unit + "\"";
    }

    /// VTK goes around quadrilaterals, deal.II row by row.
    std::vector<std::int32_t>
    connectivity(const FieldMesh &mesh)
    {
      std::vector<std::int32_t> cells(mesh.cells.begin(), mesh.cells.end());
      for (std::size_t first = 0; first < cells.size(); first += 4)
        std::swap(cells[first + 2], cells[first + 3]);
      return cells;
    }

    /// One <Piece> of the file: the part of this rank; empty without cells.
    std::string
    make_piece(const FieldMesh &mesh)
    {
      if (mesh.cells.empty())
        return "";
      const std::size_t  n_cells = mesh.cells.size() / mesh.points_per_cell;
      std::ostringstream out;
      out << "<Piece NumberOfPoints=\"" << mesh.points.size() << "\" NumberOfCells=\"" << n_cells
          << "\">\n<Points>\n";
      std::vector<float> points;
      for (const auto &point : mesh.points)
        points.insert(points.end(), point.begin(), point.end());
      write_array(out, "Float32", " NumberOfComponents=\"3\"", points);
      std::vector<std::int32_t> offsets;
      for (std::size_t cell = 1; cell <= n_cells; ++cell)
        offsets.push_back(std::int32_t(cell * mesh.points_per_cell));
      out << "</Points>\n<Cells>\n";
      write_array(out, "Int32", " Name=\"connectivity\"", connectivity(mesh));
      write_array(out, "Int32", " Name=\"offsets\"", offsets);
      const std::uint8_t type = mesh.points_per_cell == 8 ? 12 : 9; // VTK_HEXAHEDRON, VTK_QUAD
      write_array(out, "UInt8", " Name=\"types\"", std::vector<std::uint8_t>(n_cells, type));
      out << "</Cells>\n<PointData>\n";
      for (const PointField &field : mesh.fields)
        write_array(
          out, "Float32", attributes_of(field), std::vector<float>(field.values.begin(), field.values.end()));
      out << "</PointData>\n";
      if (!mesh.body.empty())
        {
          out << "<CellData>\n";
          write_array(out, "UInt8", " Name=\"body\"", mesh.body);
          out << "</CellData>\n";
        }
      out << "</Piece>\n";
      return out.str();
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

    // The parts are small once compressed. Through rank 0 they need no parallel file system, and a
    // full disk is reported with its reason.
    const std::string pieces = gather_on_root(make_piece(mesh), comm);
    on_root(comm, [&]() {
      std::ostringstream file;
      file << "<?xml version=\"1.0\"?>\n<!-- wheelrail " WHEELRAIL_VERSION
              " -->\n"
              "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\" "
              "compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n"
           << pieces << "</UnstructuredGrid>\n</VTKFile>\n";
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
