#include "aktina/import/assimp/apart.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

#include "aktina/base/error.h"

namespace aktina::assimp {
namespace {

constexpr size_t kBuffer = size_t(1) << 16;
constexpr uint8_t kDone = 0, kFailed = 1;  // the first byte that the child sends
constexpr unsigned kWallFactor = 20;       // of computing time, until a child that waits for nothing is ended

struct Ended {};  // the child sent less than was asked for

/// The writing end of the pipe, in the child.
class Output {
 public:
  explicit Output(int fd) : fd_(fd) { buffer_.reserve(kBuffer); }
  void put(std::span<const uint8_t> bytes) {
    if (buffer_.size() + bytes.size() > kBuffer) flush();
    if (bytes.size() >= kBuffer) return send(bytes);
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  }
  void flush() { send(buffer_), buffer_.clear(); }

 private:
  void send(std::span<const uint8_t> bytes) const {
    while (!bytes.empty()) {
      const ssize_t sent = ::write(fd_, bytes.data(), bytes.size());
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) ::_exit(1);  // nobody listens any more
      bytes = bytes.subspan(size_t(sent));
    }
  }
  int fd_;
  std::vector<uint8_t> buffer_;
};

/// The reading end, here.
class Input {
 public:
  explicit Input(int fd) : fd_(fd), buffer_(kBuffer) {}
  void get(std::span<uint8_t> bytes) {
    while (!bytes.empty()) {
      if (at_ == end_) fill();
      const size_t count = std::min(bytes.size(), end_ - at_);
      std::copy_n(buffer_.begin() + long(at_), count, bytes.begin());
      at_ += count;
      bytes = bytes.subspan(count);
    }
  }

 private:
  void fill() {
    ssize_t got = 0;
    do got = ::read(fd_, buffer_.data(), buffer_.size());
    while (got < 0 && errno == EINTR);
    if (got <= 0) throw Ended();
    at_ = 0, end_ = size_t(got);
  }
  int fd_;
  std::vector<uint8_t> buffer_;
  size_t at_ = 0, end_ = 0;
};

void limit(__rlimit_resource resource, uint64_t value) {
  const rlimit both = {value, value};
  ::setrlimit(resource, &both);
}

/// Address space in use, bytes.
uint64_t address_space() {
  uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * uint64_t(::sysconf(_SC_PAGESIZE));
}

void confine(const Limits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);  // handlers of the host program
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int fd : {0, 1, 2}) ::dup2(nowhere, fd);
  limit(RLIMIT_CORE, 0);
  const rlimit seconds = {limits.seconds, limits.seconds + 1};
  ::setrlimit(RLIMIT_CPU, &seconds);
  ::alarm(limits.seconds * kWallFactor);
  limit(RLIMIT_AS, address_space() + limits.most_bytes);
}

void send_error(Output& output, Code code, const std::string& what, const std::string& hint) {
  const auto text = [&](const std::string& s) {
    const uint64_t size = s.size();
    output.put({reinterpret_cast<const uint8_t*>(&size), sizeof size});
    output.put({reinterpret_cast<const uint8_t*>(s.data()), s.size()});
  };
  const uint8_t head[] = {kFailed, uint8_t(code)};
  output.put(head), text(what), text(hint);
  output.flush();
}

[[noreturn]] void child(int fd, const Limits& limits, const std::function<void(const Sink&)>& work) {
  confine(limits);
  Output output(fd);
  try {
    bool begun = false;
    work([&](std::span<const uint8_t> bytes) {
      if (!begun) output.put({&kDone, 1});
      begun = true;
      output.put(bytes);
    });
    output.flush();
  } catch (const Error& error) {
    send_error(output, error.code(), error.message(), error.hint());
  } catch (const std::bad_alloc&) {
    send_error(output, Code::limit, "needs more memory than is allowed", "simplify the scene");
  } catch (const std::exception& error) {
    send_error(output, Code::bad_input, error.what(), "the file is damaged");
  }
  ::_exit(0);
}

/// What the child says about its failure.
Error received(Input& input, const std::string& where) {
  constexpr uint64_t kLongest = 4096;
  const auto text = [&] {
    uint64_t size = 0;
    input.get({reinterpret_cast<uint8_t*>(&size), sizeof size});
    std::string s(std::min(size, kLongest), ' ');
    input.get({reinterpret_cast<uint8_t*>(s.data()), s.size()});
    return s;
  };
  uint8_t code = 0;
  input.get({&code, 1});
  std::string what = text();
  return {code <= uint8_t(Code::cancelled) ? Code(code) : Code::bad_input, where, what, text()};
}

/// Waits for the child's end. @return its status, as wait() gives it
int reap(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0)
    if (errno != EINTR) return -1;  // somebody else has waited for it
  return status;
}

Error ended(int status, const Limits& limits, const std::string& where) {
  const int signal = status >= 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGINT || signal == SIGTERM) return {Code::cancelled, where, "reading it was interrupted"};
  if (signal == SIGXCPU || signal == SIGALRM)
    return {Code::limit, where, fmt::format("takes longer than {} s to read", limits.seconds), "simplify the scene"};
  if (signal == SIGKILL) return {Code::limit, where, "needs more memory or time than there is", "simplify the scene"};
  return {Code::bad_input, where, "makes its reader fail: it is damaged or nested too deep",
          "write it again, or convert it to glTF"};
}

}  // namespace

void run_apart(const Limits& limits, const std::string& where, const std::function<void(const Sink&)>& work,
               const std::function<void(const Source&)>& take) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw Error(Code::io, where, fmt::format("no pipe: {}", std::strerror(errno)));
  const pid_t pid = ::fork();
  if (pid == 0) child(ends[1], limits, work);
  const int why = errno;
  ::close(ends[1]);
  if (pid < 0) {
    ::close(ends[0]);
    throw Error(Code::io, where, fmt::format("no process of its own to read it: {}", std::strerror(why)));
  }
  const auto end = [&] { return ::close(ends[0]), ::kill(pid, SIGKILL), reap(pid); };
  try {
    Input input(ends[0]);
    uint8_t outcome = kFailed;
    input.get({&outcome, 1});
    if (outcome != kDone) throw received(input, where);
    take([&](std::span<uint8_t> bytes) { input.get(bytes); });
  } catch (const Ended&) {
    ::close(ends[0]);
    throw ended(reap(pid), limits, where);
  } catch (...) {
    end();
    throw;
  }
  end();
}

}  // namespace aktina::assimp
