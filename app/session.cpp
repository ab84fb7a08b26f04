#include "session.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "interrupt.h"
#include "terminal.h"

namespace aktina::app {
namespace {

ProgressStyle chosen_style(const Command& command, const Arguments& arguments) {
  if (!command.long_work || arguments.given("quiet")) return ProgressStyle::none;
  const std::string& how = arguments.text("progress");
  if (how == "json") return ProgressStyle::json;
  if (how == "none") return ProgressStyle::none;
  if (error_is_terminal()) return ProgressStyle::bar;
  return how == "bar" ? ProgressStyle::lines : ProgressStyle::none;
}

/// A bar moves ten times a second; lines of text that somebody keeps come once a second.
double interval(ProgressStyle style) { return style == ProgressStyle::lines ? 1 : 0.1; }

std::string typed(std::span<const char* const> words) {
  std::string line = "aktina";
  for (const std::string word : words)
    line += word.find_first_of(" \t\n'\"\\") == word.npos && !word.empty() ? " " + word : fmt::format(" '{}'", word);
  return line;
}

std::string shown_size(uint64_t bytes) {
  if (bytes < 10000) return fmt::format("{} bytes", bytes);
  return bytes < 10000000 ? fmt::format("{:.0f} kB", double(bytes) / 1e3)
                          : fmt::format("{:.1f} MB", double(bytes) / 1e6);
}

}  // namespace

Session::Session(const Command& command, const Arguments& arguments, std::span<const char* const> words)
    : command_(command.name),
      line_(typed(words)),
      settings_(settings_line(command, arguments)),
      json_(arguments.given("json")),
      quiet_(arguments.given("quiet")),
      progress_(progress_watcher(chosen_style(command, arguments)), interval(chosen_style(command, arguments))) {
  if (command.long_work) set_thread_count(int(arguments.whole("threads")));
  watch_interrupts(progress_);
}

void Session::begin_work() { keep_result_when_interrupted(); }

void Session::will_write(const Path& path) { check_writable(path); }

void Session::wrote(const Path& path) {
  std::error_code unknown;
  const auto bytes = uint64_t(std::filesystem::file_size(path, unknown));
  outputs_.push_back({path, unknown ? 0 : bytes});
  note(fmt::format("wrote {}, {}", display(path), shown_size(outputs_.back().bytes)));
}

void Session::note(std::string_view line) const {
  if (!quiet_) print_error_line("aktina: " + one_line(line));
}

void Session::show_warnings(const Warnings& warnings) const {
  for (const Warnings::Item& item : warnings.items())
    note(fmt::format("warning: {}{}", item.text, item.count > 1 ? fmt::format(" ({} times)", item.count) : ""));
}

int Session::finish(const Report& report, const std::string& text, const std::string& result, int status) const {
  if (!report.complete) {
    note(outputs_.empty() ? "stopped before the end" : "stopped before the end; the best result so far was written");
    status = info(Code::cancelled).exit_status;
  }
  if (!json_) {
    print(text);
    return status;
  }
  nlohmann::ordered_json json = {{"schema_version", 1}, {"command", command_}, {"command_line", line_}};
  json.update(nlohmann::ordered_json::parse(to_json(report)));
  json["timings"]["total"] = total_.lap();
  auto& outputs = json["outputs"] = nlohmann::ordered_json::array();
  for (const Output& output : outputs_) outputs.push_back({{"file", display(output.path)}, {"bytes", output.bytes}});
  if (!result.empty()) json["result"] = nlohmann::ordered_json::parse(result);
  print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  return status;
}

}  // namespace aktina::app
