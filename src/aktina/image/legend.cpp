#include "aktina/image/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "aktina/image/metric.h"

namespace aktina {
namespace {

constexpr int kWide = 5, kHigh = 7, kScale = 2;  // of a letter; pixels a dot
constexpr int kStep = (kWide + 1) * kScale, kLine = kHigh * kScale;
constexpr int kMargin = 12, kBar = 20, kLabels = 5;
const Rgb kPaper(1), kInk(0.01f);

struct Glyph {
  char letter;
  std::array<const char*, kHigh> rows;
};
constexpr Glyph kGlyphs[] = {
    {'0', {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### "}},
    {'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    {'2', {" ### ", "#   #", "    #", "   # ", "  #  ", " #   ", "#####"}},
    {'3', {" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### "}},
    {'4', {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "}},
    {'5', {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "}},
    {'6', {"  ## ", " #   ", "#    ", "#### ", "#   #", "#   #", " ### "}},
    {'7', {"#####", "    #", "   # ", "  #  ", "  #  ", "  #  ", "  #  "}},
    {'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "}},
    {'9', {" ### ", "#   #", "#   #", " ####", "    #", "   # ", " ##  "}},
    {'.', {"     ", "     ", "     ", "     ", "     ", " ##  ", " ##  "}},
    {'-', {"     ", "     ", "     ", " ### ", "     ", "     ", "     "}},
    {'+', {"     ", "  #  ", "  #  ", "#####", "  #  ", "  #  ", "     "}},
    {'e', {"     ", "     ", " ### ", "#   #", "#####", "#    ", " ### "}},
    {'l', {" ##  ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    {'x', {"     ", "     ", "#   #", " # # ", "  #  ", " # # ", "#   #"}},
    {'c', {"     ", "     ", " ### ", "#    ", "#    ", "#   #", " ### "}},
    {'d', {"    #", "    #", " ## #", "#  ##", "#   #", "#   #", " ####"}},
    {'m', {"     ", "     ", "## # ", "# # #", "# # #", "#   #", "#   #"}},
    {'/', {"    #", "    #", "   # ", "  #  ", " #   ", "#    ", "#    "}},
};

void write(Image& page, int x, int y, std::string_view text) {
  for (const char letter : text) {
    for (const Glyph& g : kGlyphs)
      if (g.letter == letter)
        for (int dot = 0; dot < kWide * kHigh * kScale * kScale; ++dot) {
          const int dx = dot % (kWide * kScale), dy = dot / (kWide * kScale);
          if (g.rows[size_t(dy / kScale)][dx / kScale] == '#') page.set_rgb(x + dx, y + dy, kInk);
        }
    x += kStep;
  }
}

std::string number(double value) {
  const double size = std::abs(value);
  return size >= 100 && size < 1e6 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

}  // namespace

Image with_legend(const Image& picture, double low, double high, std::string_view unit) {
  std::array<std::string, kLabels> labels;
  size_t longest = 0;
  for (size_t i = 0; i < kLabels; ++i) {
    labels[i] = fmt::format("{} {}", number(low + (high - low) * double(i) / (kLabels - 1)), unit);
    longest = std::max(longest, labels[i].size());
  }
  const int height = std::max(picture.height + 2 * kMargin, kLabels * 2 * kLine + 2 * kMargin);
  const int bar = picture.width + 2 * kMargin, text = bar + kBar + kMargin / 2;
  Image page(text + int(longest) * kStep + kMargin, height, 3);
  for (int y = 0; y < page.height; ++y)
    for (int x = 0; x < page.width; ++x) page.set_rgb(x, y, kPaper);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) page.set_rgb(x + kMargin, y + kMargin, picture.rgb(x, y));

  const int top = kMargin + kLine / 2, bottom = height - kMargin - kLine / 2;
  Image scale(1, bottom - top, 1);
  for (int y = 0; y < scale.height; ++y) *scale.at(0, y) = 1 - float(y) / float(std::max(scale.height - 1, 1));
  scale = false_colour(scale);
  for (int y = 0; y < scale.height; ++y)
    for (int x = 0; x < kBar; ++x) page.set_rgb(bar + x, top + y, scale.rgb(0, y));
  for (int i = 0; i < kLabels; ++i)
    write(page, text, bottom - (bottom - top) * i / (kLabels - 1) - kLine / 2, labels[size_t(i)]);
  return page;
}

}  // namespace aktina
