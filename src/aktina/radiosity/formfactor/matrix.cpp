#include "aktina/radiosity/formfactor/matrix.h"

#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"

namespace aktina {
namespace {

constexpr size_t kMostSurfaces = 20000;  // two matrices of them are 6.4 GB

}  // namespace

FormFactorMatrix form_factor_matrix(const FormFactorScene& scene, const std::string& method, Progress* progress) {
  const size_t n = scene.surfaces.size();
  const auto estimator = make_method(formfactors(), "formfactor", method);
  if (n > kMostSurfaces)
    throw Error(Code::limit, "surfaces", fmt::format("there are {}", n), fmt::format("at most {}", kMostSurfaces));
  estimator->build(scene);
  if (progress) progress->begin("form factors", "rows", n);
  FormFactorMatrix matrix{n, std::vector<double>(n * n), std::vector<double>(n * n)};
  parallel_for(n, 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (progress) progress->throw_if_cancelled();
      const FormFactorRow row = estimator->row(i);
      std::copy(row.factors.begin(), row.factors.end(), matrix.factors.begin() + std::ptrdiff_t(i * n));
      std::copy(row.errors.begin(), row.errors.end(), matrix.errors.begin() + std::ptrdiff_t(i * n));
      if (progress) progress->advance();
    }
  });
  return matrix;
}

}  // namespace aktina
