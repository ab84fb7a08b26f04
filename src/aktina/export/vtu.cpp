// VTK XML unstructured grid, as the VTK book's chapter "VTK File Formats" describes it: an XML head whose arrays point
// into one appended block of raw bytes, each array preceded by its length in 64 bits.
#include <fmt/format.h>

#include "aktina/base/error.h"
#include "aktina/export/export.h"

namespace aktina {
namespace {

constexpr uint8_t kTriangle = 5, kQuad = 9;  // VTK's cell types

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

class VtuWriter {
 public:
  std::string head, data;

  void open(std::string_view element) { head += fmt::format("<{}>\n", element); }
  void close(std::string_view element) { head += fmt::format("</{}>\n", element); }

  template <class T>
  void array(std::string_view name, std::string_view unit, int components, const std::vector<T>& values) {
    head += fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}">)",
                        type(values.data()), name, components, data.size());
    if (!unit.empty())
      head += fmt::format(R"(<InformationKey name="UNITS_LABEL" location="vtkDataArray">{}</InformationKey>)", unit);
    head += "</DataArray>\n";
    const uint64_t bytes = values.size() * sizeof(T);
    data.append(reinterpret_cast<const char*>(&bytes), 8).append(reinterpret_cast<const char*>(values.data()), bytes);
  }
  template <class T>
  void colours(std::string_view name, std::string_view unit, const std::vector<T>& values) {
    array(name, unit, 3, floats(values, [](const T& v) {
            if constexpr (requires { v.v; })
              return v.v;
            else
              return v;
          }));
  }
  void vectors(std::string_view name, std::string_view unit, const std::vector<Vec3>& values) {
    array(name, unit, 3, floats(values, [](Vec3 v) { return Rgb(v.x, v.y, v.z); }));
  }
  void luminances(std::string_view name, const std::vector<Irradiance>& values) {
    std::vector<float> out;
    for (const Irradiance e : values) out.push_back(luminance(e.v));
    array(name, "lx", 1, out);
  }
  /// A string as VTK has it: its bytes as numbers, and a zero.
  void text(const std::string& name, const std::string& value) {
    head += fmt::format(R"(<Array type="String" Name="{}" NumberOfTuples="1" format="ascii">)", escaped(name));
    for (const unsigned char c : value) head += fmt::format("{} ", int(c));
    head += "0</Array>\n";
  }

 private:
  static std::string_view type(const float*) { return "Float32"; }
  static std::string_view type(const int64_t*) { return "Int64"; }
  static std::string_view type(const uint8_t*) { return "UInt8"; }
  template <class T>
  static std::vector<float> floats(const std::vector<T>& values, auto&& get) {
    std::vector<float> out;
    out.reserve(3 * values.size());
    for (const T& value : values) {
      const Rgb c = get(value);
      out.insert(out.end(), {c.r, c.g, c.b});
    }
    return out;
  }
};

void add_cells(VtuWriter& out, const PatchMesh& mesh) {
  std::vector<int64_t> corners, ends;
  std::vector<uint8_t> types;
  for (size_t i = 0; i < mesh.size(); ++i) {
    const int count = mesh.is_quad(i) ? 4 : 3;
    for (int k = 0; k < count; ++k) corners.push_back(mesh.patches[i][size_t(k)]);
    ends.push_back(int64_t(corners.size()));
    types.push_back(count == 4 ? kQuad : kTriangle);
  }
  out.open("Cells");
  out.array("connectivity", "", 1, corners);
  out.array("offsets", "", 1, ends);
  out.array("types", "", 1, types);
  out.close("Cells");
}

void add_cell_data(VtuWriter& out, const Solution& solution) {
  const PatchMesh& mesh = solution.mesh;
  std::vector<int64_t> instances;
  for (const SurfacePoint& centre : mesh.centres) instances.push_back(centre.instance);
  out.open(R"(CellData Scalars="illuminance")");
  out.luminances("illuminance", solution.irradiances);
  out.colours("irradiance", "lx", solution.irradiances);
  out.colours("radiosity", "lm/m^2", solution.radiosities);
  out.colours("back_irradiance", "lx", solution.back_irradiances);
  out.colours("emission", "lm/m^2", mesh.emissions);
  out.colours("reflectance", "1", mesh.reflectances);
  out.colours("transmittance", "1", mesh.transmittances);
  out.vectors("normal", "1", mesh.patch_normals);
  out.array("area", "m^2", 1, mesh.areas);
  out.array("two_sided", "", 1, mesh.two_sided);
  out.array("instance", "", 1, instances);
  out.close("CellData");
}

void add_point_data(VtuWriter& out, const Solution& solution) {
  out.open(R"(PointData Scalars="illuminance")");
  out.luminances("illuminance", solution.vertex_irradiances);
  out.colours("irradiance", "lx", solution.vertex_irradiances);
  out.colours("radiosity", "lm/m^2", solution.vertex_radiosities);
  out.colours("back_irradiance", "lx", solution.vertex_back_irradiances);
  out.vectors("normal", "1", solution.mesh.normals);
  out.close("PointData");
}

}  // namespace

void write_vtu(const Path& path, const Solution& solution, const Metadata& metadata) {
  VtuWriter out;
  out.head = "<?xml version=\"1.0\"?>\n";
  out.open(R"(VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64")");
  out.open("UnstructuredGrid");
  out.open("FieldData");
  for (const auto& [name, value] : metadata) out.text(name, one_line(value));
  out.close("FieldData");
  out.open(fmt::format(R"(Piece NumberOfPoints="{}" NumberOfCells="{}")", solution.mesh.positions.size(),
                       solution.mesh.size()));
  add_point_data(out, solution);
  add_cell_data(out, solution);
  out.open("Points");
  out.vectors("Points", "m", solution.mesh.positions);
  out.close("Points");
  add_cells(out, solution.mesh);
  out.close("Piece");
  out.close("UnstructuredGrid");
  out.head += "<AppendedData encoding=\"raw\">\n_";
  write_file(path, out.head + out.data + "\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace aktina
