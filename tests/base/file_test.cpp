#include "aktina/base/file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "aktina/base/error.h"
#include "test_files.h"

namespace aktina {
namespace {

Code code_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return Code::usage;
}

TEST(File, RoundTripsWithUnicodeNames) {
  const test::TemporaryFolder folder;
  const Path path = folder / "φως 光.bin";
  write_file(path, std::string_view("light\0and shade", 15));
  EXPECT_EQ(read_text_file(path), std::string("light\0and shade", 15));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "nothing is left beside it";
}

TEST(File, RefusesWhatIsNotAFile) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(code_of([&] { read_file(folder / "absent"); }), Code::io);
  EXPECT_EQ(code_of([&] { read_file(folder.path()); }), Code::io);
  EXPECT_EQ(code_of([&] { read_file("/dev/zero"); }), Code::io);
  write_file(folder / "large", std::string(1000, 'x'));
  EXPECT_EQ(code_of([&] { read_file(folder / "large", 999); }), Code::limit);
}

TEST(File, FailedWriteLeavesTheOldFile) {
  const test::TemporaryFolder folder;
  write_file(folder / "kept", std::string_view("old"));
  EXPECT_THROW(write_through(folder / "kept",
                             [](const Path& temporary) {
                               std::ofstream(temporary) << "half";
                               throw Error(Code::io, "", "disk full");
                             }),
               Error);
  EXPECT_EQ(read_text_file(folder / "kept"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(File, AWriteThatIsCutOffLeavesNothing) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(write_through(folder / "picture",
                             [&](const Path& temporary) {
                               write_file(folder / "other", std::string_view("whole"));
                               std::ofstream(temporary) << "half";
                               remove_partial_files();
                               EXPECT_FALSE(std::filesystem::exists(temporary));
                             }),
               Error);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "only the whole file";
}

TEST(File, LinksAndDevicesStayWhatTheyAre) {
  const test::TemporaryFolder folder;
  write_file(folder / "target", std::string_view("old"));
  std::filesystem::create_symlink("target", folder / "link");
  write_file(folder / "link", std::string_view("new"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(read_text_file(folder / "target"), "new");
  write_file("/dev/null", std::string_view("x"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_EQ(code_of([] { write_file("/dev/full", std::string_view("x")); }), Code::io);
}

TEST(File, UnwritableFolderIsKnownBeforehand) {
  EXPECT_EQ(code_of([] { check_writable("/proc/aktina.png"); }), Code::io);
  EXPECT_EQ(code_of([] { check_writable("/absent/folder/x.png"); }), Code::io);
  EXPECT_EQ(code_of([] { write_file("/dev/full/x", std::string_view("x")); }), Code::io);
}

TEST(File, LowerExtension) {
  EXPECT_EQ(lower_extension("a/B.GLB"), "glb");
  EXPECT_EQ(lower_extension("noext"), "");
}

}  // namespace
}  // namespace aktina
