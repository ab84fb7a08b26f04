// The parts of the shipped suite; each adds its cases.
#pragma once

#include "aktina/render/validate.h"

namespace aktina {

void add_photometry_cases(std::vector<ValidationCase>& cases);
void add_form_factor_cases(std::vector<ValidationCase>& cases);
void add_enclosure_cases(std::vector<ValidationCase>& cases);
void add_furnace_cases(std::vector<ValidationCase>& cases);

}  // namespace aktina
