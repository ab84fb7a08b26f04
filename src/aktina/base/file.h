// Files: read whole within a limit; written whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aktina {

using Path = std::filesystem::path;  // UTF-8

inline constexpr uint64_t kLargestFile = uint64_t(4) << 30;  // bytes; larger files are refused before they are read

/// The whole file. @throws Error io (missing, a folder, unreadable), limit (larger than `limit` bytes)
std::vector<uint8_t> read_file(const Path& path, uint64_t limit = kLargestFile);
std::string read_text_file(const Path& path, uint64_t limit = kLargestFile);

/// Writes beside `path`, then renames: the file appears whole or not at all.
/// @throws Error io (folder missing or read-only, disk full)
void write_file(const Path& path, std::span<const uint8_t> bytes);
void write_file(const Path& path, std::string_view text);

/// The same for writers that want a path of their own: `write` gets a temporary path in the same folder, which is
/// renamed to `path` when it returns and removed when it throws. A symbolic link keeps pointing to what it did; devices
/// and pipes, which cannot be replaced, are written in place.
void write_through(const Path& path, const std::function<void(const Path& temporary)>& write);

/// Removes the temporary files of writes that are under way. For a program that ends in the middle of one: safe in a
/// signal handler.
void remove_partial_files() noexcept;

/// @throws Error io unless a file could be created at `path`: called before long work, not after it.
void check_writable(const Path& path);

/// Path as UTF-8 text for messages.
std::string display(const Path& path);
/// Extension in lower case without the dot: "GLB" -> "glb".
std::string lower_extension(const Path& path);

}  // namespace aktina
