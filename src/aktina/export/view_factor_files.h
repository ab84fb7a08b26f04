// View-factor matrices -> files that other programs open.
#pragma once

#include "aktina/export/export.h"
#include "aktina/radiosity/viewfactor/gray_body.h"
#include "aktina/radiosity/viewfactor/view_factors.h"

namespace aktina {

/// Matrices of up to so many surfaces are written as N x N numbers, larger ones as compressed sparse rows.
inline constexpr size_t kMostDense = 2500;

struct ViewFactorFile {
  const ViewFactors& factors;
  const ViewFactorScene& scene;                   // the polygons, for .vtu
  const GrayExchange* exchange = nullptr;         // where it was asked for
  const GrayBalance* balance = nullptr;           // where temperatures or fluxes are known
  const std::vector<GrayBody>* bodies = nullptr;  // of both
  std::string certificate{};                      // JSON
  Metadata metadata{};
};

/// By the extension: .npz (NumPy; sparse ones as scipy.sparse.save_npz writes them), .h5 (HDF5), .csv, .vtu
/// (ParaView), .txt (View3D's text format at full precision).
/// @throws Error io, usage (another extension), limit (too many surfaces for the format)
void write_view_factors(const Path& path, const ViewFactorFile& file);

// One writer each.
void write_npz(const Path& path, const ViewFactorFile& file);
void write_hdf5(const Path& path, const ViewFactorFile& file);
void write_view_factors_csv(const Path& path, const ViewFactorFile& file);
void write_view_factors_vtu(const Path& path, const ViewFactorFile& file);
void write_view3d(const Path& path, const ViewFactorFile& file);

/// A row as N numbers; NaN where nothing is known (ViewFactors::complete).
std::vector<double> dense_row(const ViewFactors& factors, size_t i);

}  // namespace aktina
