#include "aktina/radiosity/lightmap/pack.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <vector>

#include "aktina/base/random.h"

namespace aktina {
namespace {

/// Every texel belongs to one box at most, and all lie on their page.
bool apart(const std::vector<PackedBox>& boxes, int size, int pages) {
  std::vector<uint8_t> taken(size_t(size) * size_t(size) * size_t(pages), 0);
  for (const PackedBox& b : boxes) {
    if (b.page < 0 || b.page >= pages || b.x < 0 || b.y < 0 || b.x + b.width > size || b.y + b.height > size)
      return false;
    for (int y = b.y; y < b.y + b.height; ++y)
      for (int x = b.x; x < b.x + b.width; ++x)
        if (taken[(size_t(b.page) * size_t(size) + size_t(y)) * size_t(size) + size_t(x)]++) return false;
  }
  return true;
}

RC_GTEST_PROP(Pack, BoxesLieApart, ()) {
  std::vector<PackedBox> boxes;
  const auto count = *rc::gen::inRange(0, 60);
  for (int i = 0; i < count; ++i) {
    PackedBox box;
    box.width = *rc::gen::inRange(1, 33), box.height = *rc::gen::inRange(1, 33);
    boxes.push_back(box);
  }
  const int pages = pack(boxes, 32, 100);
  RC_ASSERT(count == 0 || pages > 0);
  RC_ASSERT(apart(boxes, 32, pages));
}

TEST(Pack, EqualBoxesFillThePage) {
  std::vector<PackedBox> boxes(64);
  for (PackedBox& b : boxes) b.width = 8, b.height = 8;
  EXPECT_EQ(pack(boxes, 64, 1), 1);
  EXPECT_TRUE(apart(boxes, 64, 1));
  boxes.emplace_back().width = 1, boxes.back().height = 1;
  EXPECT_EQ(pack(boxes, 64, 1), 0) << "no page is left";
  EXPECT_EQ(pack(boxes, 64, 2), 2);
}

TEST(Pack, WastesLittle) {
  std::vector<PackedBox> boxes;
  Pcg32 random(1);
  double area = 0;
  while (area < 0.85 * 1024 * 1024) {
    PackedBox& box = boxes.emplace_back();
    box.width = 4 + int(random.next() % 60), box.height = 4 + int(random.next() % 60);
    area += double(box.width) * double(box.height);
  }
  EXPECT_EQ(pack(boxes, 1024, 1), 1) << "85 % of a page fit on it";
  EXPECT_TRUE(apart(boxes, 1024, 1));
}

TEST(Pack, TheSameEveryTime) {
  std::vector<PackedBox> a(100), b;
  for (size_t i = 0; i < a.size(); ++i) a[i].width = int(i % 7) + 1, a[i].height = int(i % 5) + 1;
  b = a;
  pack(a, 32, 9), pack(b, 32, 9);
  for (size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(a[i].x == b[i].x && a[i].y == b[i].y && a[i].page == b[i].page);
}

}  // namespace
}  // namespace aktina
