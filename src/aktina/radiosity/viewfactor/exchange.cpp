#include "aktina/radiosity/viewfactor/exchange.h"

#include <algorithm>

#include "aktina/base/parallel.h"
#include "aktina/radiosity/formfactor/occluded.h"

namespace aktina {

Exchanges exchanges(const Faces& faces, double target_error, Progress* progress) {
  Exchanges result;
  result.rows.resize(faces.size());
  if (progress) progress->begin("view factors", "surfaces", faces.size());
  parallel_for(faces.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (progress) progress->throw_if_cancelled();
      for (size_t j = i + 1; j < faces.size(); ++j) {
        const double tolerance = target_error * std::min(1.0, faces[j].area / faces[i].area);
        const Estimate e = exchange_area(faces[i], faces[j], faces.blockers(i, j), tolerance);
        if (e.value > 0) result.rows[i].push_back({uint32_t(j), float(e.error), e.value});
      }
      if (progress) progress->advance();
    }
  });
  return result;
}

}  // namespace aktina
