#include "aktina/export/view_factor_files.h"

#include <cmath>

#include "aktina/base/error.h"

namespace aktina {

std::vector<double> dense_row(const ViewFactors& factors, size_t i) {
  std::vector<double> row(factors.size(), 0);
  for (uint64_t k = factors.starts[i]; k < factors.starts[i + 1]; ++k) row[factors.columns[k]] = factors.factors[k];
  for (size_t j = 0; j < row.size(); ++j)
    if (!factors.known(i, j)) row[j] = std::nan("");
  return row;
}

void write_view_factors(const Path& path, const ViewFactorFile& file) {
  const std::string extension = lower_extension(path);
  if (extension == "npz")
    write_npz(path, file);
  else if (extension == "h5" || extension == "hdf5")
    write_hdf5(path, file);
  else if (extension == "csv")
    write_view_factors_csv(path, file);
  else if (extension == "vtu")
    write_view_factors_vtu(path, file);
  else if (extension == "txt")
    write_view3d(path, file);
  else
    throw Error(Code::usage, display(path), "cannot tell the format from the name",
                "one of .npz, .h5, .csv, .vtu, .txt");
}

}  // namespace aktina
