// The file: "AKTINAC1", a checksum of the rest, whose it is, then each part's name and fields.
#include "aktina/radiosity/checkpoint.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <memory>

#include "aktina/base/hash.h"
#include "aktina/base/version.h"

namespace aktina {
namespace {

constexpr char kMagic[9] = "AKTINAC1";  // the last character is the version
constexpr size_t kHeader = 16;          // magic, checksum
constexpr size_t kBlock = 1 << 20;      // bytes that are written at once, and enter the checksum at once

uint64_t checksum(std::span<const uint8_t> bytes) {
  Hash64 hash;
  for (size_t at = 0; at < bytes.size(); at += kBlock)
    hash.add(std::as_bytes(bytes.subspan(at, std::min(kBlock, bytes.size() - at))));
  return hash.value();
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// A file on its way to the disk.
class Output {
 public:
  explicit Output(const Path& path) : path_(path), file_(std::fopen(path.c_str(), "wbe"), &std::fclose) {
    if (!file_) fail();
    std::setvbuf(file_.get(), nullptr, _IONBF, 0);
    write(std::vector<std::byte>(kHeader));
  }

  void add(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const size_t n = std::min(bytes.size(), kBlock - block_.size());
      block_.insert(block_.end(), bytes.begin(), bytes.begin() + std::ptrdiff_t(n));
      bytes = bytes.subspan(n);
      if (block_.size() == kBlock) flush();
    }
  }

  /// On the disk when this returns, not on its way: the rename that follows must not come to be before it.
  void finish() {
    if (!block_.empty()) flush();
    std::vector<std::byte> header(kHeader);
    const uint64_t sum = hash_.value();
    std::memcpy(header.data(), kMagic, 8);
    std::memcpy(header.data() + 8, &sum, 8);
    if (std::fseek(file_.get(), 0, SEEK_SET) != 0) fail();
    write(header);
    if (::fsync(::fileno(file_.get())) != 0) fail();
  }

 private:
  void flush() {
    hash_.add(std::span<const std::byte>(block_));
    write(block_);
    block_.clear();
  }
  void write(const std::vector<std::byte>& bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail();
  }
  [[noreturn]] void fail() const {
    throw Error(Code::io, display(path_), fmt::format("cannot write: {}", std::strerror(errno)));
  }

  const Path& path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::vector<std::byte> block_;
  Hash64 hash_;
};

}  // namespace

Checkpoint::Checkpoint(const CheckpointOptions& options, std::string scene, std::string settings,
                       const Progress* progress)
    : file_(options.file),
      seconds_(options.seconds),
      written_(now()),
      scene_(std::move(scene)),
      settings_(std::move(settings)),
      progress_(progress) {
  if (!(seconds_ >= 0)) throw Error(Code::bad_param, "every", fmt::format("got {} s", seconds_), "accepted 0 .. inf");
  check_writable(file_);
  if (!std::filesystem::exists(file_)) return;
  bytes_ = read_file(file_);
  if (bytes_.empty() && !options.resume) return;
  if (bytes_.size() < kHeader || std::memcmp(bytes_.data(), kMagic, 7) != 0)
    refuse("is no checkpoint of Aktina, and is not replaced", "another name");
  if (options.resume)
    open();
  else
    bytes_ = {};
}

void Checkpoint::refuse(const std::string& what, const std::string& hint) const {
  throw Error(Code::bad_input, display(file_), what, hint);
}

void Checkpoint::open() {
  const std::string anew = "without --resume the run begins anew";
  if (bytes_[7] != uint8_t(kMagic[7])) refuse("is a checkpoint of another version", anew);
  const auto rest = std::span<const uint8_t>(bytes_).subspan(kHeader);
  uint64_t sum = 0;
  std::memcpy(&sum, bytes_.data() + 8, 8);
  if (sum != checksum(rest)) refuse("the checksum is wrong: the file is damaged", anew);
  reader_.emplace(rest, display(file_));
  std::string made_by, scene, settings;
  (*reader_)(made_by), (*reader_)(scene), (*reader_)(settings);
  if (made_by != version()) refuse(fmt::format("is a checkpoint of Aktina {}; this is {}", made_by, version()), anew);
  if (scene != scene_) refuse("is a checkpoint of another scene", anew);
  if (settings != settings_)
    refuse("is a checkpoint of other settings: " + settings, "with these, or anew without --resume");
}

void Checkpoint::restore(const Entry& part) {
  if (!reader_) return;
  if (reader_->at_end()) {
    reader_.reset();
    bytes_ = {};
    return;
  }
  std::string name;
  (*reader_)(name);
  reader_->expect(name == part.name);
  (*part.fields)(*reader_);
}

void Checkpoint::write() {
  Path fresh = file_;  // always the same name: what a killed run leaves there, the next one replaces
  fresh += ".partial";
  Output file(fresh);
  const auto add = [&](std::span<const std::byte> bytes) { file.add(bytes); };
  ArchiveWriter archive(add);
  std::string made_by(version());
  archive(made_by), archive(scene_), archive(settings_);
  for (Entry& part : parts_) archive(part.name), (*part.fields)(archive);
  file.finish();
  std::filesystem::rename(fresh, file_);
  written_ = now();
}

CheckpointPart::CheckpointPart(Checkpoint* checkpoint, std::string name, std::function<void(Archive&)> fields)
    : checkpoint_(checkpoint), fields_(std::move(fields)) {
  if (!checkpoint) return;
  const Checkpoint::Entry part{std::move(name), &fields_};
  checkpoint->restore(part);
  checkpoint->parts_.push_back(part);
}

CheckpointPart::~CheckpointPart() {
  if (checkpoint_) std::erase_if(checkpoint_->parts_, [&](const auto& part) { return part.fields == &fields_; });
}

void CheckpointPart::save_when_due() const {
  if (!checkpoint_ || now() - checkpoint_->written_ < checkpoint_->seconds_) return;
  if (checkpoint_->progress_ && checkpoint_->progress_->cancelled()) return;
  checkpoint_->write();
}

KeptLoop::KeptLoop(Checkpoint* checkpoint, std::string name, std::function<void(Archive&)> results)
    : part_(checkpoint, std::move(name), [this, results = std::move(results)](Archive& a) { a(done_), results(a); }) {}

void KeptLoop::run(uint64_t count, uint64_t block, Progress* progress, FunctionRef<void(size_t, size_t)> body) {
  if (progress) progress->advance(std::min(done_, count));
  while (done_ < count && !(progress && progress->cancelled())) {
    const uint64_t end = part_.kept() ? std::min(count, done_ + block) : count;
    body(size_t(done_), size_t(end));
    done_ = end;
    part_.save_when_due();
  }
}

}  // namespace aktina
