// The numbers of a study by name: the same ones in report.json, report.csv and the tables of report.html.
#pragma once

#include <span>
#include <string_view>

#include "aktina/render/study/study.h"

namespace aktina {

struct StudyColumn {
  enum class Group { quality, cost, operations, growth, energy };
  Group group;
  std::string_view name;   // in JSON and CSV
  std::string_view unit;   // "1", "dB", "ms", "ns"
  std::string_view title;  // in a table
  std::string_view help;   // what it means
  double (*value)(const MethodStudy& method);
};

std::span<const StudyColumn> study_columns();

}  // namespace aktina
