// The parts of report.html, each a piece of HTML that needs nothing else.
#pragma once

#include <string>
#include <string_view>

#include "aktina/render/study/study.h"

namespace aktina {

/// Three digits; a dash for what is not known.
std::string shown(double value);

/// Error against time on one thread: a point a method, the Pareto front as a line. Inline SVG.
std::string html_chart(const Study& study);

/// The same of a study by runs: a line a method through its best runs, against time, or against size where the study
/// has one.
std::string html_run_chart(const Study& study);
/// All runs.
std::string html_run_table(const Study& study);

/// What papers say, and whether it holds; empty where they say nothing.
std::string html_claims(const Study& study);

/// Quality, cost, operations, growth.
std::string html_tables(const Study& study);

/// The reference and each method: picture, difference and FLIP map, and the slider that compares two of them.
/// @param number  of the study in the page
std::string html_pictures(const Study& study, size_t number);

extern const std::string_view kStudyStyle, kStudyScript;  // the page's CSS and JavaScript

}  // namespace aktina
