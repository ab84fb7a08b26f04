// Analytic shapes as dictionaries: {"type": "cone", "radius": 0.5, ...}.
#pragma once

#include "aktina/trace/primitive/primitive.h"
#include "fields.h"

namespace aktina::python {

template <class Visitor>
void fields_of(Sphere& shape, Visitor& field) {
  field("radius", shape.radius);
}
template <class Visitor>
void fields_of(Disc& shape, Visitor& field) {
  field("radius", shape.radius);
}
template <class Visitor>
void fields_of(Cylinder& shape, Visitor& field) {
  field("radius", shape.radius), field("height", shape.height);
}
template <class Visitor>
void fields_of(Cone& shape, Visitor& field) {
  field("radius", shape.radius), field("top_radius", shape.top_radius), field("height", shape.height);
}

/// The shape called `type`, its sizes from `field`. @throws Error no_such_method
inline Primitive read_primitive(const std::string& type, FromDict& field) {
  Primitive shape = make_method(primitives(), "primitive", type);
  std::visit([&](auto& s) { fields_of(s, field); }, shape);
  return shape;
}

}  // namespace aktina::python
