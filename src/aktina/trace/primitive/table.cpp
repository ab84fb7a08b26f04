// The primitives: the only list.
#include "aktina/trace/primitive/primitive.h"

namespace aktina {

extern const Method<Primitive> sphere_primitive, disc_primitive, cylinder_primitive, cone_primitive;

std::span<const Method<Primitive>* const> primitives() {
  static constexpr const Method<Primitive>* kTable[] = {&sphere_primitive, &disc_primitive, &cylinder_primitive,
                                                        &cone_primitive};
  return kTable;
}

}  // namespace aktina
