// A radiosity solution for ParaView.
#include "aktina/export/vtu_writer.h"
#include "aktina/radiosity/error_estimate.h"

namespace aktina {
namespace {

constexpr uint8_t kTriangle = 5, kQuad = 9;  // VTK's cell types

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
  out.array("illuminance_error", "lx", 1, patch_errors(solution));
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
  VtuWriter out(metadata, solution.mesh.positions.size(), solution.mesh.size());
  add_point_data(out, solution);
  add_cell_data(out, solution);
  out.open("Points");
  out.vectors("Points", "m", solution.mesh.positions);
  out.close("Points");
  add_cells(out, solution.mesh);
  out.finish(path);
}

}  // namespace aktina
