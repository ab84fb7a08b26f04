#include "aktina/radiosity/viewfactor/large_array.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>

#include "aktina/base/error.h"

namespace aktina {
namespace {

constexpr size_t kHuge = size_t(1) << 21;

/// A file that goes when it is closed.
int nameless_file(const std::filesystem::path& folder, size_t bytes) {
  std::string name = (folder / "aktina-XXXXXX").string();
  const int file = mkstemp(name.data());
  if (file < 0) throw Error(Code::io, folder.string(), "cannot write there", "name a folder that can be written to");
  unlink(name.c_str());
  if (posix_fallocate(file, 0, off_t(bytes)) != 0) {
    close(file);
    throw Error(Code::io, folder.string(), fmt::format("has no room for {:.2g} GB", double(bytes) / 1e9));
  }
  return file;
}

}  // namespace

LargeBlock::LargeBlock(size_t bytes, const std::filesystem::path& folder) : bytes_(bytes) {
  if (bytes == 0) return;
  const int file = folder.empty() ? -1 : nameless_file(folder, bytes);
  const int flags = folder.empty() ? MAP_PRIVATE | MAP_ANONYMOUS : MAP_SHARED;
  data_ = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, flags, file, 0);
  if (file >= 0) close(file);
  if (data_ == MAP_FAILED) {
    data_ = nullptr, bytes_ = 0;
    throw Error(Code::limit, "memory", fmt::format("{:.2g} GB are not to be had", double(bytes) / 1e9));
  }
  if (folder.empty() && bytes >= kHuge) madvise(data_, bytes, MADV_HUGEPAGE);
}

LargeBlock::~LargeBlock() {
  if (data_) munmap(data_, bytes_);
}

}  // namespace aktina
