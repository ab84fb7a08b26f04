// Coefficients of a surface as a row of floats, which Python fills by name.
#pragma once

#include "aktina/illumination/surface.h"
#include "arrays.h"

namespace aktina::python {

/// The coefficients of a Surface, in the order of a row of floats: the name in Python, and a colour or a number.
struct SurfaceField {
  const char* name;
  Rgb Surface::*colour = nullptr;
  float Surface::*number = nullptr;
  int size() const { return colour ? 3 : 1; }
};
inline constexpr SurfaceField kSurfaceFields[] = {
    {"ka", &Surface::ka},
    {"kd", &Surface::kd},
    {"ks", &Surface::ks},
    {"kr", &Surface::kr},
    {"kt", &Surface::kt},
    {"exponent", nullptr, &Surface::exponent},
    {"base_colour", &Surface::base},
    {"metallic", nullptr, &Surface::metallic},
    {"roughness", nullptr, &Surface::roughness},
    {"ior", nullptr, &Surface::ior},
    {"specular_tint", &Surface::specular_tint},
    {"specular_weight", nullptr, &Surface::specular_weight},
};

inline int surface_row_size() {
  int size = 0;
  for (const SurfaceField& field : kSurfaceFields) size += field.size();
  return size;
}

inline Surface surface(const float* row) {
  Surface s;
  for (const SurfaceField& field : kSurfaceFields) {
    if (field.colour) s.*field.colour = rgb(row);
    if (field.number) s.*field.number = *row;
    row += field.size();
  }
  return s;
}

}  // namespace aktina::python
