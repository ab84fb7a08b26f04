// VTK XML unstructured grid, as the VTK book's chapter "VTK File Formats" describes it: an XML head whose arrays point
// into one appended block of raw bytes, each array preceded by its length in 64 bits.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "aktina/base/error.h"
#include "aktina/base/markup.h"
#include "aktina/base/quantity.h"
#include "aktina/base/vec.h"
#include "aktina/export/export.h"

namespace aktina {

class VtuWriter {
 public:
  /// The file's frame, metadata and counts; point data, cell data, points and cells follow.
  VtuWriter(const Metadata& metadata, size_t points, size_t cells) {
    head = "<?xml version=\"1.0\"?>\n";
    open(R"(VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64")");
    open("UnstructuredGrid");
    open("FieldData");
    for (const auto& [name, value] : metadata) text(name, one_line(value));
    close("FieldData");
    open(fmt::format(R"(Piece NumberOfPoints="{}" NumberOfCells="{}")", points, cells));
  }
  /// Closes the frame and writes the file.
  void finish(const Path& path) {
    close("Piece");
    close("UnstructuredGrid");
    head += "<AppendedData encoding=\"raw\">\n_";
    write_file(path, head + data + "\n</AppendedData>\n</VTKFile>\n");
  }

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
  static std::string_view type(const double*) { return "Float64"; }
  static std::string_view type(const int64_t*) { return "Int64"; }
  static std::string_view type(const uint8_t*) { return "UInt8"; }
  std::string head, data;

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

}  // namespace aktina
