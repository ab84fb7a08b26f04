#include "interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstring>

#include "aktina/base/error.h"
#include "aktina/base/file.h"

namespace aktina::app {
namespace {

std::atomic<Progress*> watched{nullptr};
std::atomic<bool> keeps_result{false};

void say(const char* text) { [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text, std::strlen(text)); }

// Only what POSIX allows in a signal handler: write, unlink, _exit and lock-free atomics.
extern "C" void on_signal(int) {
  if (keeps_result && !watched.load()->cancelled()) {
    watched.load()->cancel();
    say("\naktina: stopping; the best result so far will be written (once more: stop without writing)\n");
    return;
  }
  remove_partial_files();
  say("\naktina: stopped; nothing was written\n");
  ::_exit(info(Code::cancelled).exit_status);
}

}  // namespace

void watch_interrupts(Progress& progress) {
  watched = &progress;
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  sigaddset(&action.sa_mask, SIGINT);
  sigaddset(&action.sa_mask, SIGTERM);
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction old {};
    ::sigaction(signal, nullptr, &old);
    if (old.sa_handler != SIG_IGN) ::sigaction(signal, &action, nullptr);  // as nohup and shells ask
  }
}

void keep_result_when_interrupted() { keeps_result = true; }

}  // namespace aktina::app
