// One run of a command: its progress, its interruption, what it says and what it wrote.
#pragma once

#include <string>
#include <vector>

#include "aktina/base/file.h"
#include "aktina/base/progress.h"
#include "aktina/render/report.h"
#include "command.h"

namespace aktina::app {

class Session {
 public:
  /// @param words  the command line as it was typed, for the report
  Session(const Command& command, const Arguments& arguments, std::span<const char* const> words);

  Progress& progress() { return progress_; }
  const std::string& settings() const { return settings_; }

  /// From here on Ctrl-C stops the work and keeps what there is; before, it ends the program.
  void begin_work();

  /// To be called for each output before long work. @throws Error io
  void will_write(const Path& path);
  /// Records an output that is there now, and says so.
  void wrote(const Path& path);

  void note(std::string_view line) const;  // on standard error unless --quiet
  void show_warnings(const Warnings& warnings) const;

  bool json() const { return json_; }
  bool quiet() const { return quiet_; }
  /// With --json prints the report with the outputs, and `result` (a JSON object as text) in it; without, `text`.
  /// Returns the exit status: that of an interrupted run where the report is not complete, else `status`.
  int finish(const Report& report, const std::string& text, const std::string& result = {}, int status = 0) const;

 private:
  struct Output {
    Path path;
    uint64_t bytes;
  };
  std::string command_, line_, settings_;
  bool json_ = false, quiet_ = false;
  Progress progress_;
  Stopwatch watch_;
  mutable Stopwatch total_;
  std::vector<Output> outputs_;
};

}  // namespace aktina::app
