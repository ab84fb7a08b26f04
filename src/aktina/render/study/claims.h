// What papers and the literature claim of methods, as data, and whether a study bears it out.
#pragma once

#include <span>

#include "aktina/render/study/study.h"

namespace aktina {

/// What a claim is judged by.
struct Evidence {
  const Study& study;
  const MethodStudy& method;

  /// Null where the study has no such method, or it failed.
  const MethodStudy* find(std::string_view id) const;
};

struct Judgement {
  ClaimResult::Verdict verdict = ClaimResult::Verdict::unknown;
  std::string measured = "not measured in this study";
};
Judgement decide(bool holds, std::string measured);

struct Claim {
  std::string_view family, method, text, source;
  Judgement (*judge)(const Evidence&);
};

/// Of the families that are compared by runs.
std::span<const Claim> run_claims();

/// Fills the claims of each method of the study, and its remarks in plain words.
void judge_claims(Study& study);

}  // namespace aktina
