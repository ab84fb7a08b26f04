// The surfaces of a view-factor matrix for ParaView: a cell is one of their polygons.
#include "aktina/export/view_factor_files.h"
#include "aktina/export/vtu_writer.h"

namespace aktina {
namespace {

constexpr uint8_t kPolygon = 7;       // VTK's cell type
constexpr size_t kMostColumns = 256;  // matrices of so many surfaces are in the file, an array a surface

/// Values of surfaces on the cells of their polygons.
std::vector<double> on_cells(const ViewFactorFile& file, const std::vector<double>& values) {
  std::vector<double> cells;
  for (const uint32_t owner : file.scene.owners) cells.push_back(values[owner]);
  return cells;
}

void add_cells(VtuWriter& out, const ViewFactorScene& scene) {
  std::vector<int64_t> corners, ends;
  for (const Polygon& piece : scene.pieces) {
    for (size_t k = 0; k < piece.vertices.size(); ++k) corners.push_back(int64_t(corners.size()));
    ends.push_back(int64_t(corners.size()));
  }
  out.open("Cells");
  out.array("connectivity", "", 1, corners);
  out.array("offsets", "", 1, ends);
  out.array("types", "", 1, std::vector<uint8_t>(scene.pieces.size(), kPolygon));
  out.close("Cells");
}

void add_matrix(VtuWriter& out, const ViewFactorFile& file) {
  const ViewFactors& f = file.factors;
  if (f.size() > kMostColumns) return;
  for (size_t i = 0; i < f.size(); ++i) out.array("F from " + f.names[i], "1", 1, on_cells(file, dense_row(f, i)));
}

void add_cell_data(VtuWriter& out, const ViewFactorFile& file) {
  const ViewFactors& f = file.factors;
  std::vector<double> sums(f.size()), errors(f.size(), 0);
  for (size_t i = 0; i < f.size(); ++i) {
    sums[i] = f.row_sum(i);
    for (uint64_t k = f.starts[i]; k < f.starts[i + 1]; ++k) errors[i] += double(f.errors[k]);
  }
  std::vector<int64_t> owners(file.scene.owners.begin(), file.scene.owners.end());
  out.open(R"(CellData Scalars="row_sum")");
  out.array("row_sum", "1", 1, on_cells(file, sums));
  out.array("row_error", "1", 1, on_cells(file, errors));
  out.array("area", "m^2", 1, on_cells(file, f.areas));
  out.array("surface", "", 1, owners);
  if (file.balance) {
    out.array("temperature", "K", 1, on_cells(file, file.balance->temperatures));
    out.array("flux", "W/m^2", 1, on_cells(file, file.balance->fluxes));
    out.array("radiosity", "W/m^2", 1, on_cells(file, file.balance->radiosities));
  }
  add_matrix(out, file);
  out.close("CellData");
}

}  // namespace

void write_view_factors_vtu(const Path& path, const ViewFactorFile& file) {
  std::vector<double> positions;
  for (const Polygon& piece : file.scene.pieces)
    for (const Point3d& p : piece.vertices) positions.insert(positions.end(), {p.x, p.y, p.z});
  VtuWriter out(file.metadata, positions.size() / 3, file.scene.pieces.size());
  add_cell_data(out, file);
  out.open("Points");
  out.array("Points", "m", 3, positions);
  out.close("Points");
  add_cells(out, file.scene);
  out.finish(path);
}

}  // namespace aktina
