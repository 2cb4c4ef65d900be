#include "export/vtk_frame.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <string_view>

#include "export/base64.hpp"

namespace zenosphere {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say so");

template <class T>
constexpr const char* type_name = nullptr;
template <>
constexpr const char* type_name<double> = "Float64";
template <>
constexpr const char* type_name<std::int64_t> = "Int64";

template <class T>
void write_bytes(Base64& base64, const T& value) {
  std::array<std::uint8_t, sizeof(T)> bytes;
  std::memcpy(bytes.data(), &value, sizeof(T));
  base64.write(bytes);
}

/// A DataArray: its number of bytes and then the tuples `value(0)`, `value(1)`, ...
///
/// \param extent  further attributes of the element
/// \param value   gives std::array<T, Components>
template <class T, std::size_t Components, class Value>
void write_array(NewFile& file, std::string_view name, std::int64_t tuples, std::string_view extent,
                 Value value) {
  file.write(fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"binary\">",
      type_name<T>, name, Components, extent));
  Base64 base64(file);
  write_bytes(base64, static_cast<std::uint64_t>(tuples) * sizeof(std::array<T, Components>));
  for (std::int64_t n = 0; n < tuples; ++n) {
    const std::array<T, Components> tuple = value(n);
    write_bytes(base64, tuple);
  }
  base64.close();
  file.write("</DataArray>\n");
}

/// An array of field data: one tuple.
template <class T, std::size_t Components>
void write_field(NewFile& file, std::string_view name, const std::array<T, Components>& values) {
  write_array<T, Components>(file, name, 1, " NumberOfTuples=\"1\"",
                             [&](std::int64_t) { return values; });
}

void write_field_data(NewFile& file, const Frame& frame) {
  const Cell& cell = frame.cell;
  file.write("<FieldData>\n");
  write_field<double, 1>(file, "TimeValue", {frame.snapshot.time});
  write_field<std::int64_t, 1>(file, "step", {frame.snapshot.step});
  write_field<double, 9>(file, "cell",
                         {cell.sides[0], 0, 0, cell.tilt, cell.sides[1], 0, 0, 0, cell.sides[2]});
  write_field<double, 3>(file, "origin", cell.origin);
  file.write("</FieldData>\n");
}

void write_point_data(NewFile& file, const Frame& frame) {
  const std::int64_t spheres = frame.spheres();
  file.write("<PointData Scalars=\"id\" Vectors=\"velocity\">\n");
  write_array<std::int64_t, 1>(file, "id", spheres, "",
                               [](std::int64_t i) { return std::array{i}; });
  write_array<double, 3>(file, "velocity", spheres, "",
                         [&](std::int64_t i) { return frame.velocity(i); });
  write_array<double, 1>(file, "radius", spheres, "",
                         [&](std::int64_t i) { return std::array{frame.radius(i)}; });
  if (!frame.are_alike()) {
    write_array<double, 1>(file, "mass", spheres, "",
                           [&](std::int64_t i) { return std::array{frame.mass(i)}; });
    write_array<std::int64_t, 1>(file, "kind", spheres, "",
                                 [&](std::int64_t i) { return std::array{frame.kind(i)}; });
  }
  if (frame.has_spins()) {
    write_array<double, 3>(file, "angular_velocity", spheres, "",
                           [&](std::int64_t i) { return frame.spin(i); });
  }
  if (!frame.collisions.empty()) {
    write_array<std::int64_t, 1>(file, "collisions", spheres, "", [&](std::int64_t i) {
      return std::array{frame.collisions[static_cast<std::size_t>(i)]};
    });
  }
  file.write("</PointData>\n");
}

/// Every point is a cell of its own, so that what works on cells (thresholds) works.
void write_vertices(NewFile& file, std::int64_t spheres) {
  file.write("<Verts>\n");
  write_array<std::int64_t, 1>(file, "connectivity", spheres, "",
                               [](std::int64_t i) { return std::array{i}; });
  write_array<std::int64_t, 1>(file, "offsets", spheres, "",
                               [](std::int64_t i) { return std::array{i + 1}; });
  file.write("</Verts>\n");
}

/// A path for an XML attribute.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

bool is_vtk_frame(const std::filesystem::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  return entry.is_regular_file() && name.starts_with("frame-") && name.ends_with(".vtp");
}

}  // namespace

std::filesystem::path vtk_frame_name(std::int64_t number) {
  return fmt::format("frame-{:06}.vtp", number);
}

FolderOf folder_of_vtk_frames() { return {"frames (frame-*.vtp)", is_vtk_frame}; }

void write_vtk_frame(NewFile& file, const Frame& frame) {
  const std::int64_t spheres = frame.spheres();
  // OVITO takes a file for spheres only if nothing but elements comes before the piece.
  file.write(
      fmt::format("<?xml version=\"1.0\"?>\n"
                  "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                  "header_type=\"UInt64\">\n<PolyData>\n"
                  "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" "
                  "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
                  spheres, spheres));
  write_point_data(file, frame);
  file.write("<Points>\n");
  write_array<double, 3>(file, "Points", spheres, "",
                         [&](std::int64_t i) { return frame.position(i); });
  file.write("</Points>\n");
  write_vertices(file, spheres);
  file.write("</Piece>\n");
  write_field_data(file, frame);
  file.write(
      "</PolyData>\n"
      "<!-- zenosphere: lengths in diameters, velocities in diameters/time, time of the case -->\n"
      "</VTKFile>\n");
}

std::string vtk_collection(const std::vector<TimedFile>& files) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const TimedFile& file : files) {
    text += fmt::format("<DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", file.time,
                        escaped(file.path.generic_string()));
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace zenosphere
