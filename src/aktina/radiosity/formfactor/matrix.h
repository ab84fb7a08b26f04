// All rows of a scene, by all cores.
#pragma once

#include <string>
#include <vector>

#include "aktina/base/progress.h"
#include "aktina/radiosity/formfactor/formfactor.h"

namespace aktina {

struct FormFactorMatrix {
  size_t size;
  std::vector<double> factors;  // row after row: factors[i * size + j] = F_ij
  std::vector<double> errors;   // estimates of their absolute errors
};

/// @param method  "METHOD" or "METHOD:parameter=number,...", as formfactors() lists them
/// @throws Error no_such_method, bad_param, usage; bad_input (polygons); limit (more than 20,000 surfaces); cancelled
FormFactorMatrix form_factor_matrix(const FormFactorScene& scene, const std::string& method,
                                    Progress* progress = nullptr);

}  // namespace aktina
