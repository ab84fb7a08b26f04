#include "aktina/base/file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>

#include "aktina/base/error.h"

namespace aktina {
namespace {

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  int release() {
    const int fd = fd_;
    fd_ = -1;
    return fd;
  }

 private:
  int fd_;
};

[[noreturn]] void fail(const Path& path, std::string_view what, std::string_view hint = {}) {
  throw Error(Code::io, display(path), fmt::format("{}: {}", what, std::strerror(errno)), std::string(hint));
}

/// Pipes and devices: they cannot be replaced.
bool written_in_place(const Path& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  return std::filesystem::is_other(status);
}

Path link_target(const Path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_symlink(path, ignored)) return path;
  const Path target = std::filesystem::weakly_canonical(path, ignored);
  if (ignored) throw Error(Code::io, display(path), "is a link that leads nowhere");
  return target;
}

/// Names of the temporary files of writes under way, where a signal handler can read them. A slot is free, being
/// filled, or holds a name.
constexpr int kFree = 0, kFilling = 1, kHeld = 2;
struct PartialName {
  std::atomic<int> state{kFree};
  char path[PATH_MAX];
};
std::array<PartialName, 8> partial_names;

/// A path beside `path`, removed again unless it was renamed; known to remove_partial_files() while it lives.
class Temporary {
 public:
  explicit Temporary(const Path& path) : path_(path) {
    static std::atomic<unsigned> counter{0};
    path_ += fmt::format(".partial-{}-{}", ::getpid(), counter++);
    if (path_.native().size() >= PATH_MAX) return;
    for (PartialName& name : partial_names) {
      int free = kFree;
      if (!name.state.compare_exchange_strong(free, kFilling)) continue;
      std::memcpy(name.path, path_.c_str(), path_.native().size() + 1);
      name.state = kHeld;
      name_ = &name;
      return;
    }
  }
  ~Temporary() {
    ::unlink(path_.c_str());
    if (name_) name_->state = kFree;
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  const Path& path() const { return path_; }

 private:
  Path path_;
  PartialName* name_ = nullptr;
};

/// Size of a regular file; other things (pipes, devices) are refused: their length is not known beforehand.
uint64_t checked_size(const Path& path, int fd, uint64_t limit) {
  struct stat status {};
  if (::fstat(fd, &status) != 0) fail(path, "cannot read");
  if (S_ISDIR(status.st_mode)) throw Error(Code::io, display(path), "is a folder, not a file");
  if (!S_ISREG(status.st_mode)) throw Error(Code::io, display(path), "is not a regular file");
  const auto size = uint64_t(status.st_size);
  if (size > limit)
    throw Error(Code::limit, display(path), fmt::format("holds {} bytes", size),
                fmt::format("at most {} are read", limit));
  return size;
}

template <class Buffer>
Buffer read_whole(const Path& path, uint64_t limit) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) fail(path, "cannot open");
  Buffer buffer;
  buffer.resize(checked_size(path, file.get(), limit));
  size_t done = 0;
  while (done < buffer.size()) {
    const ssize_t got = ::read(file.get(), buffer.data() + done, buffer.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path, "cannot read");
    if (got == 0) break;
    done += size_t(got);
  }
  buffer.resize(done);
  return buffer;
}

}  // namespace

std::vector<uint8_t> read_file(const Path& path, uint64_t limit) {
  return read_whole<std::vector<uint8_t>>(path, limit);
}
std::string read_text_file(const Path& path, uint64_t limit) { return read_whole<std::string>(path, limit); }

void write_file(const Path& path, std::span<const uint8_t> bytes) {
  write_through(path, [&](const Path& temporary) {
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.get() < 0) fail(path, "cannot write");
    size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t wrote = ::write(file.get(), bytes.data() + done, bytes.size() - done);
      if (wrote < 0 && errno == EINTR) continue;
      if (wrote <= 0) fail(path, "cannot write");
      done += size_t(wrote);
    }
    if (::close(file.release()) != 0) fail(path, "cannot write");
  });
}

void write_file(const Path& path, std::string_view text) {
  write_file(path, std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
}

void write_through(const Path& path, const std::function<void(const Path&)>& write) {
  const auto named = [&](const Path& file) {  // libraries that write do not say where
    try {
      write(file);
    } catch (const Error& error) {
      if (!error.where().empty()) throw;
      throw Error(error.code(), display(path), error.message(), error.hint());
    }
  };
  if (written_in_place(path)) return named(path);
  const Path target = link_target(path);
  const Temporary temporary(target);
  named(temporary.path());
  if (::rename(temporary.path().c_str(), target.c_str()) != 0) fail(path, "cannot write");
}

void remove_partial_files() noexcept {
  for (PartialName& name : partial_names)
    if (name.state == kHeld) ::unlink(name.path);
}

void check_writable(const Path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw Error(Code::io, display(path), "is a folder, not a file");
  if (written_in_place(path)) return;
  const Temporary temporary(link_target(path));
  const Descriptor file(::open(temporary.path().c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
  if (file.get() < 0) fail(path, "cannot write", "does the folder exist, and may you write there?");
}

std::string display(const Path& path) { return path.string(); }

std::string lower_extension(const Path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return extension;
}

}  // namespace aktina
