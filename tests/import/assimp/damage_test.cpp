// Damaged files, and readers that crash, hang or eat memory, end in one Error.
#include <gtest/gtest.h>

#include <csignal>
#include <vector>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "aktina/import/assimp/apart.h"
#include "aktina/import/import.h"
#include "import/assimp/binary_fbx.h"
#include "import/assimp/sample_files.h"
#include "import/reading.h"

namespace aktina {
namespace {

using assimp::Sink;
using assimp::Source;
using test::bytes_of;

/// A scene or an Error of one line; anything else ends the test.
template <class Read>
void attempt(Read read) {
  try {
    read();
  } catch (const Error& error) {
    EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
    EXPECT_FALSE(error.message().empty());
  }
}

using Reader = Scene (*)(std::span<const uint8_t>, const Path&, const std::string&, const ImportOptions&);
struct Sample {
  Reader read;
  std::string text;
};
std::vector<Sample> samples() {
  return {{read_fbx, test::kFbx},
          {read_fbx, test::binary_fbx_file()},
          {read_collada, test::kCollada},
          {read_3ds, test::max3ds_file()}};
}

TEST(AssimpDamage, FilesCutOff) {
  for (const Sample& sample : samples())
    for (size_t i = 0; i < 24; ++i) {
      const std::string cut = sample.text.substr(0, sample.text.size() * i / 24);
      attempt([&] { sample.read(bytes_of(cut), "/nowhere", "cut", {}); });
    }
}

TEST(AssimpDamage, BitsFlipped) {
  for (const Sample& sample : samples())
    for (uint32_t seed = 0; seed < 48; ++seed) {
      std::string flipped = sample.text;
      for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t at = hash_combine(hash32(seed), k);
        flipped[at % flipped.size()] = char(flipped[at % flipped.size()] ^ (1 << (at >> 29)));
      }
      attempt([&] { sample.read(bytes_of(flipped), "/nowhere", "flipped", {}); });
    }
}

TEST(AssimpDamage, NothingToDrawIsAnError) {
  for (const Reader read : {read_fbx, read_collada, read_3ds}) {
    EXPECT_THROW(read({}, "/nowhere", "empty", {}), Error);
    EXPECT_THROW(read(bytes_of("MM"), "/nowhere", "short", {}), Error);
  }
}

TEST(AssimpDamage, OneFormatIsNotReadAsAnother) {
  // Assimp would look for any reader that knows the bytes.
  EXPECT_THROW(read_3ds(bytes_of(test::kCollada), "/nowhere", "a.3ds", {}), Error);
  EXPECT_THROW(read_fbx(bytes_of("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                 "endloop\nendfacet\nendsolid\n"),
                        "/nowhere", "a.fbx", {}),
               Error);
}

TEST(AssimpDamage, NodesNestedTenThousandDeep) {
  std::string text = test::kCollada, open, close;
  for (int i = 0; i < 10'000; ++i) open += "<node>", close += "</node>";
  const size_t at = text.find("<node id=\"n1\"");
  text.insert(at, open + close);
  attempt([&] { read_collada(bytes_of(text), "/nowhere", "deep.dae", {}); });
}

/// Code of the Error in which work ends.
Code end_of(const std::function<void(const Sink&)>& work, assimp::Limits limits = {uint64_t(64) << 20, 20}) {
  try {
    assimp::run_apart(limits, "file", work, [](const Source& source) {
      uint8_t bytes[8];
      source(bytes);
    });
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "file");
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return Code::usage;
}

TEST(RunApart, GivesWhatIsWritten) {
  std::vector<uint8_t> sent(300'000), got(300'000);
  for (size_t i = 0; i < sent.size(); ++i) sent[i] = uint8_t(i * 7);
  assimp::run_apart(
      {uint64_t(64) << 20, 20}, "file", [&](const Sink& sink) { sink(sent); },
      [&](const Source& source) { source(got); });
  EXPECT_EQ(sent, got);
}

TEST(RunApart, EveryWayToFailIsAnError) {
  const uint8_t three[] = {1, 2, 3};
  EXPECT_EQ(end_of([](const Sink&) { ::raise(SIGSEGV); }), Code::bad_input);
  EXPECT_EQ(end_of([&](const Sink& sink) { sink(three), ::raise(SIGABRT); }), Code::bad_input);
  EXPECT_EQ(end_of([&](const Sink& sink) { sink(three); }), Code::bad_input) << "less than was asked for";
  EXPECT_EQ(end_of([](const Sink&) {}), Code::bad_input);
  EXPECT_EQ(end_of([](const Sink&) { throw std::runtime_error("odd"); }), Code::bad_input);
  EXPECT_EQ(end_of([](const Sink&) { throw Error(Code::unsupported, "", "other"); }), Code::unsupported);
  EXPECT_EQ(end_of([](const Sink&) { throw std::bad_alloc(); }), Code::limit);
}

TEST(RunApart, WorkWithoutEndIsEnded) {
  const auto forever = [](const Sink&) {
    for (volatile bool never = false; !never;) {
    }
  };
  EXPECT_EQ(end_of(forever, {uint64_t(64) << 20, 1}), Code::limit);
}

TEST(RunApart, MemoryIsLimited) {
  const auto greedy = [](const Sink& sink) {
    std::vector<std::vector<uint8_t>> all;
    while (all.size() < 16) all.emplace_back(size_t(1) << 26, 'x');
    sink(all[0]);  // never comes: sanitizers end the process where others throw bad_alloc
  };
  const Code code = end_of(greedy, {uint64_t(256) << 20, 20});
  EXPECT_TRUE(code == Code::limit || code == Code::bad_input);
}

}  // namespace
}  // namespace aktina
