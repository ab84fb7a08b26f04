// Faults that the reading itself can live with: what accessors claim about their values, alignment, names, and parts of
// a file that nothing shows.
#pragma once

#include "aktina/import/gltf/document.h"

namespace aktina::gltf {

/// Counts them in the document's warnings; throws nothing.
void check_data(Document& document);

}  // namespace aktina::gltf
