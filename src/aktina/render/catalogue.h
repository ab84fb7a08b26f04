// The catalogue: every family's table joined. The program, the Python module, the studio and docs/methods/ read it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "aktina/base/method.h"

namespace aktina {

struct Family {
  std::string_view id;       // "shading"
  std::string_view title;    // "Shading interpolation"
  std::string_view summary;  // what its methods are, and what they are good for
  std::string_view folder;   // of the methods' files, below src/aktina: "raster/shading"
  std::vector<const MethodInfo*> methods;
};

/// In the order in which light meets them: from lamps to solvers.
const std::vector<Family>& families();

/// @throws Error no_such_method, listing the families
const Family& find_family(std::string_view id);

/// @throws Error no_such_method, listing the family's methods
const MethodInfo& find_method(const Family& family, std::string_view id);

/// All families, or the one called `family`, as JSON text: {"schema_version": 1, "families": [...]}.
std::string catalogue_json(std::string_view family = {});

}  // namespace aktina
