// What a long run has so far, in a file: a run that was killed goes on from there, and ends as if it had never been
// interrupted.
//
// A run is a nest of scopes; each keeps something while it lasts: direct light, form factors, a solver's iterate. Each
// of them is a part. The file holds the parts that lived when it was written; the next run makes the same parts in the
// same order, and finds them filled.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "aktina/base/archive.h"
#include "aktina/base/file.h"
#include "aktina/base/progress.h"

namespace aktina {

struct CheckpointOptions {
  Path file{};          // empty: none
  double seconds = 60;  // between two writes
  bool resume = false;  // goes on from `file` where it exists
};

class Checkpoint {
 public:
  /// @param scene, settings  of the run: the file of another one is refused
  /// @param progress         once it is cancelled nothing is written any more: things may be half done. May be null
  /// @throws Error io; bad_input (damaged, of another version, of another scene or other settings); usage (the file is
  /// there and no checkpoint, and would be replaced)
  Checkpoint(const CheckpointOptions& options, std::string scene, std::string settings, const Progress* progress);

 private:
  friend class CheckpointPart;
  using Fields = std::function<void(Archive&)>;
  struct Entry {
    std::string name;
    const Fields* fields;
  };
  void open();
  [[noreturn]] void refuse(const std::string& what, const std::string& hint) const;
  void restore(const Entry& part);
  void write();

  Path file_;
  double seconds_, written_;
  std::string scene_, settings_;
  const Progress* progress_;
  std::vector<Entry> parts_;
  std::vector<uint8_t> bytes_;           // of the file that is resumed
  std::optional<ArchiveReader> reader_;  // of its parts that are not made yet
};

/// A part lives from its construction to its destruction.
class CheckpointPart {
 public:
  /// Fills the fields where the file holds them. They must be as long as they should be, and outlive this.
  /// @param checkpoint  null: nothing is kept
  /// @throws Error bad_input (the file does not fit)
  CheckpointPart(Checkpoint* checkpoint, std::string name, std::function<void(Archive&)> fields);
  ~CheckpointPart();
  CheckpointPart(const CheckpointPart&) = delete;
  CheckpointPart& operator=(const CheckpointPart&) = delete;

  /// To be called between steps, when all parts are whole: writes the file when its time has come. @throws Error io
  void save_when_due() const;
  bool kept() const { return checkpoint_ != nullptr; }

 private:
  Checkpoint* checkpoint_;
  std::function<void(Archive&)> fields_;
};

/// A loop over items, in blocks between which the file may be written.
class KeptLoop {
 public:
  /// @param results  what the loop fills
  KeptLoop(Checkpoint* checkpoint, std::string name, std::function<void(Archive&)> results);
  uint64_t done() const { return done_; }
  /// body(begin, end) for blocks of the items that are not done yet, in order, until `progress` is cancelled.
  void run(uint64_t count, uint64_t block, Progress* progress, FunctionRef<void(size_t, size_t)> body);

 private:
  uint64_t done_ = 0;
  CheckpointPart part_;
};

/// A list that such a loop fills.
template <class T>
struct KeptList {
  KeptList(Checkpoint* checkpoint, std::string name, size_t size)
      : values(size), loop(checkpoint, std::move(name), [this](Archive& a) { a(values); }) {}
  std::vector<T> values;
  KeptLoop loop;
};

}  // namespace aktina
