#include "terminal.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "aktina/base/error.h"

namespace aktina::app {
namespace {

std::atomic<bool> bar_shown{false};

/// 0, or the reason as errno has it.
int write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t wrote = ::write(file, text.data(), text.size());
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return errno;
    text.remove_prefix(size_t(wrote));
  }
  return 0;
}

size_t terminal_width() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

bool colours_wanted() {
  const char* const no_colour = std::getenv("NO_COLOR");
  const char* const term = std::getenv("TERM");
  return !(no_colour && *no_colour) && term && std::strcmp(term, "dumb") != 0;
}

/// "1.23 M", "45.6 k", "7.89"
std::string shortened(double value) {
  constexpr std::string_view kPrefixes[] = {"", " k", " M", " G", " T"};
  size_t prefix = 0;
  while (value >= 1000 && prefix + 1 < std::size(kPrefixes)) value /= 1000, ++prefix;
  return fmt::format("{:.3g}{}", value, kPrefixes[prefix]);
}

std::string clock(double seconds) {
  const int64_t s = std::llround(seconds);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

struct Estimate {
  double share = 0;         // done, in [0, 1]
  double rate = 0;          // units a second
  double seconds_left = 0;  // negative: not known
};

Estimate estimate(const ProgressState& state) {
  Estimate e;
  if (state.seconds > 0) e.rate = double(state.done) / state.seconds;
  if (state.total > 0) e.share = std::min(1.0, double(state.done) / double(state.total));
  e.seconds_left =
      state.total > 0 && e.rate > 0 ? double(state.total - std::min(state.done, state.total)) / e.rate : -1;
  return e;
}

std::string one_line_of(const ProgressState& state) {
  const Estimate e = estimate(state);
  std::string text = state.stage;
  if (state.total > 0) text += fmt::format(" {:3.0f}%", std::floor(e.share * 100));
  if (e.rate > 0) text += fmt::format("  {} {}/s", shortened(e.rate), state.unit);
  if (e.seconds_left >= 0 && state.done < state.total) text += fmt::format("  {} left", clock(e.seconds_left));
  return text;
}

void show_bar(const ProgressState& state, bool colours) {
  constexpr size_t kBar = 30;
  const std::string text = one_line_of(state);
  std::string bar;
  if (state.total > 0 && text.size() + kBar + 3 < terminal_width()) {
    const auto filled = size_t(estimate(state).share * kBar);
    bar = fmt::format("{}{:━<{}}{}{:─<{}}{} ", colours ? "\033[33m" : "", "", filled, colours ? "\033[2m" : "", "",
                      kBar - filled, colours ? "\033[0m" : "");
  }
  bar_shown = true;
  write_all(STDERR_FILENO, fmt::format("\r\033[K{}{}", bar, text.substr(0, terminal_width() - 1)));
}

void show_json(const ProgressState& state) {
  const Estimate e = estimate(state);
  write_all(STDERR_FILENO,
            fmt::format("{{\"schema_version\": 1, \"stage\": \"{}\", \"unit\": \"{}\", \"done\": {}, \"total\": {}, "
                        "\"seconds\": {:.3f}, \"rate\": {:.6g}, \"seconds_left\": {}}}\n",
                        state.stage, state.unit, state.done, state.total, state.seconds, e.rate,
                        e.seconds_left >= 0 ? fmt::format("{:.3f}", e.seconds_left) : "null"));
}

}  // namespace

void prepare_streams() {
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(file, F_GETFD) < 0 && errno == EBADF) ::open("/dev/null", O_RDONLY);  // takes the lowest free number
  ::signal(SIGPIPE, SIG_IGN);
}

void print(std::string_view text) {
  const int reason = write_all(STDOUT_FILENO, text);
  if (reason != 0 && reason != EPIPE) throw Error(Code::io, "standard output", std::strerror(reason));
}

void print_error_line(std::string_view line) {
  const char* const clear = bar_shown.exchange(false) ? "\r\033[K" : "";
  write_all(STDERR_FILENO, fmt::format("{}{}\n", clear, line));
}

bool error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

Progress::Watcher progress_watcher(ProgressStyle style) {
  switch (style) {
    case ProgressStyle::none:
      return {};
    case ProgressStyle::bar:
      return [colours = colours_wanted()](const ProgressState& state) { show_bar(state, colours); };
    case ProgressStyle::lines:
      return [](const ProgressState& state) { print_error_line(one_line_of(state)); };
    case ProgressStyle::json:
      return show_json;
  }
  return {};
}

}  // namespace aktina::app
