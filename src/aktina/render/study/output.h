// A study as files: report.html for people, report.json and report.csv for programs.
#pragma once

#include <span>

#include "aktina/base/file.h"
#include "aktina/render/study/study.h"

namespace aktina {

inline constexpr int kStudySchema = 1;  // of report.json and report.csv

/// One object: {"schema_version": 1, "program": ..., "studies": [...]}; what is not known is null.
std::string study_json(std::span<const Study> studies);

/// A line a method of a study, after a line of names; what is not known is empty.
std::string study_csv(std::span<const Study> studies);

/// A page that needs nothing else: tables, chart, pictures with a slider, maps of differences. UTF-8.
std::string study_html(std::span<const Study> studies);

/// Checks that write_study() can write there: a new folder, an empty one, or one that holds an earlier study alone.
/// @throws Error usage (other files in it), io
void check_study_folder(const Path& folder);

/// Writes the three files into a folder that appears whole or not at all; an earlier study in it is replaced.
/// @return  the files. @throws Error usage, io
std::vector<Path> write_study(const Path& folder, std::span<const Study> studies);

}  // namespace aktina
