// What papers and the literature claim of methods, as data, and whether a study bears it out.
#pragma once

#include "aktina/render/study/study.h"

namespace aktina {

/// Fills the claims of each method of the study, and its remarks in plain words.
void judge_claims(Study& study);

}  // namespace aktina
