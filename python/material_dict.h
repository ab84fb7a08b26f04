// Materials as dictionaries: classic coefficients (kd, ks, kr, ...) or glTF's (base_colour, metallic, ...).
#pragma once

#include "aktina/scene/material.h"
#include "fields.h"

namespace aktina::python {

template <class Visitor>
void fields_of(ClassicMaterial& m, Visitor& field) {
  field("ka", m.ka), field("kd", m.kd), field("ks", m.ks), field("kr", m.kr), field("kt", m.kt);
  field("exponent", m.exponent), field("index", m.index);
}
template <class Visitor>
void fields_of(Material& m, Visitor& field) {
  field("name", m.name);
  field("base_colour", m.base_colour), field("metallic", m.metallic), field("roughness", m.roughness);
  field("ior", m.ior), field("transmission", m.transmission);
  field("specular_weight", m.specular_weight), field("specular_tint", m.specular_tint);
  field("emission", m.emission), field("double_sided", m.double_sided), field("unlit", m.unlit);
  field("alpha", m.alpha);
}

inline bool is_classic(const py::dict& dict) {
  for (const char* name : {"ka", "kd", "ks", "kr", "kt", "exponent", "index"})
    if (dict.contains(name)) return true;
  return false;
}

/// @param extra  further fields that the caller reads
/// @throws Error usage
inline Material material_from(const py::dict& dict, FromDict& reader) {
  ClassicMaterial classic;
  fields_of(classic, reader);
  Material material;
  material.metallic = 0;
  if (is_classic(dict)) material = material_of(classic);
  fields_of(material, reader);
  if (material.alpha < 1) material.alpha_mode = AlphaMode::blend;
  return material;
}

}  // namespace aktina::python
