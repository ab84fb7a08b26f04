// Lights as dictionaries: {"type": "spot", "position": ..., ...}.
#pragma once

#include <pybind11/pybind11.h>

#include "aktina/illumination/light/light.h"

namespace aktina::python {

/// @throws Error usage, no_such_method (an unknown type), bad_param (a direction of no length)
Light light_from(const pybind11::dict& dict);
pybind11::dict light_dict(const Light& light);

}  // namespace aktina::python
