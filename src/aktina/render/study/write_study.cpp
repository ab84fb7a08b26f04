// The folder of a study, whole or not at all: written beside its place, then put there.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "aktina/base/error.h"
#include "aktina/render/study/output.h"

namespace aktina {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFiles[] = {"report.html", "report.json", "report.csv"};

Path without_slash(const Path& folder) { return folder.filename().empty() ? folder.parent_path() : folder; }

[[noreturn]] void fail(const Path& path, const std::string& reason) {
  throw Error(Code::io, display(path), "cannot write: " + reason, "does the folder exist, and may you write there?");
}

/// A folder beside `folder`, removed where it is not moved away.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const Path& folder) : path_(fmt::format("{}.partial-{}", display(folder), ::getpid())) {
    std::error_code error;
    if (!fs::create_directory(path_, error)) fail(folder, error ? error.message() : "there is a " + display(path_));
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const Path& path() const { return path_; }

 private:
  Path path_;
};

/// Puts `fresh` where `folder` is; an old folder ends up where the fresh one was, in one step where the system can.
void put(const Path& fresh, const Path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) {
    fs::rename(fresh, folder, error);
    if (error) fail(folder, error.message());
    return;
  }
#if defined(RENAME_EXCHANGE)
  if (::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0) return;
#endif
  for (const std::string_view name : kFiles) {
    fs::rename(fresh / name, folder / name, error);
    if (error) fail(folder / name, error.message());
  }
}

}  // namespace

void check_study_folder(const Path& given) {
  const Path folder = without_slash(given);
  std::error_code error;
  if (folder.empty()) throw Error(Code::usage, display(given), "is no name of a folder");
  if (fs::exists(folder, error)) {
    if (!fs::is_directory(folder, error)) throw Error(Code::io, display(folder), "is not a folder");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
      if (std::find(std::begin(kFiles), std::end(kFiles), entry.path().filename().string()) == std::end(kFiles))
        throw Error(Code::usage, display(folder),
                    fmt::format("holds '{}', which no study wrote", display(entry.path().filename())),
                    "a new or empty folder, or that of an earlier study");
  }
  const TemporaryFolder probe(folder);
}

std::vector<Path> write_study(const Path& given, std::span<const Study> studies) {
  check_study_folder(given);
  const Path folder = without_slash(given);
  const TemporaryFolder fresh(folder);
  write_file(fresh.path() / kFiles[0], study_html(studies));
  write_file(fresh.path() / kFiles[1], study_json(studies));
  write_file(fresh.path() / kFiles[2], study_csv(studies));
  put(fresh.path(), folder);
  std::vector<Path> files;
  for (const std::string_view name : kFiles) files.push_back(folder / name);
  return files;
}

}  // namespace aktina
