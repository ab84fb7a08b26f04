// The meshers: the only list.
#include "aktina/radiosity/mesher/mesher.h"

namespace aktina {

extern const Method<std::unique_ptr<Mesher>> uniform_mesher, quadtree_mesher, discontinuity_mesher;

std::span<const Method<std::unique_ptr<Mesher>>* const> meshers() {
  static constexpr const Method<std::unique_ptr<Mesher>>* kTable[] = {&uniform_mesher, &quadtree_mesher,
                                                                      &discontinuity_mesher};
  return kTable;
}

}  // namespace aktina
