// Where tests find files: the repository's own, third-party scenes beside it, and a fresh folder to write into.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace aktina::test {

inline std::filesystem::path repository() { return AKTINA_SOURCE_DIR; }

/// Real third-party files, where they are (../shared/scenes). Tests that read them skip where the folder is absent.
inline std::filesystem::path third_party_scenes() { return repository().parent_path() / "shared" / "scenes"; }

#define AKTINA_NEEDS_THIRD_PARTY_SCENES()                           \
  if (!std::filesystem::exists(aktina::test::third_party_scenes())) \
  GTEST_SKIP() << "third-party scenes are absent: " << aktina::test::third_party_scenes()

/// A folder that is empty at first and removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "aktina-test-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace aktina::test
