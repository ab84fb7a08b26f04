// IES LM-63: ANSI/IES LM-63-19, and what its forerunners of 1986, 1991, 1995 and 2002 had otherwise.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/import/beside.h"
#include "aktina/import/luminaire/luminaire.h"
#include "aktina/import/luminaire/planes.h"
#include "aktina/import/text.h"

namespace aktina {
namespace {

constexpr float kFoot = 0.3048f;  // m
constexpr uint64_t kMostAngles = 100'000, kMostValues = 10'000'000;
constexpr uint64_t kLargestTilt = 1 << 20;  // bytes of a file of tilt factors

/// The numbers of type A and B: horizontal and vertical angles about a horizontal axis of the luminaire.
struct Grid {
  std::vector<float> vertical, horizontal, candela;  // [horizontal][vertical]
};

class IesReader {
 public:
  IesReader(std::span<const uint8_t> bytes, const Path& folder, const std::string& where)
      : text_(utf8_or_latin1(decode_text(bytes))), lines_(text_), folder_(folder), where_(where) {}

  Luminaire run() {
    header();
    numbers();
    try {
      finish();
    } catch (const Error& error) {
      if (error.where().starts_with(where_)) throw;
      fail(error.message());
    }
    return std::move(out_);
  }

 private:
  /// Up to TILT=, which some files have at the end of a label's line.
  void header() {
    std::string_view line;
    out_.format = "IES LM-63-1986";
    while (lines_.next(line)) {
      const std::string_view text = trimmed(line);
      if (lines_.number() == 1) version(text);
      const size_t tilt = text.find("TILT=");
      label(text.substr(0, tilt));
      if (tilt != text.npos) return this->tilt(std::string(trimmed(text.substr(tilt + 5))));
      if (lines_.number() > 10000) break;
    }
    fail("has no TILT= line, as every IES file has");
  }
  void version(std::string_view text) {
    if (text.starts_with("IESNA91")) out_.format = "IES LM-63-1991";
    for (const std::string_view prefix : {"IESNA:LM-63-", "IES:LM-63-"})
      if (text.starts_with(prefix)) out_.format = fmt::format("IES LM-63-{}", text.substr(prefix.size(), 4));
  }
  void label(std::string_view text) {
    const auto take = [&](std::string_view key, std::string& to) {
      if (text.starts_with(key) && to.empty()) to = trimmed(text.substr(key.size()));
    };
    take("[LUMINAIRE]", out_.name), take("[MANUFAC]", out_.manufacturer), take("[LAMP]", out_.lamp);
  }
  void tilt(const std::string& how) {
    if (how == "NONE") return;
    if (how == "INCLUDE") return tilt_table();
    tilt_file(how);
  }
  /// A file of its own with what TILT=INCLUDE has.
  void tilt_file(const std::string& name) {
    Beside beside(folder_, {.most_bytes = kLargestTilt});
    const auto path = beside.find(name);
    if (!path) return out_.warnings.add(fmt::format("the tilt file '{}' is missing: its factors are taken as 1", name));
    const std::vector<uint8_t> bytes = beside.read(*path);
    const std::string where = display(*path);
    IesReader reader(bytes, folder_, where);
    reader.tilt_table();
    out_.tilt = std::move(reader.out_.tilt);
    out_.warnings.add(reader.out_.warnings);
  }
  /// How the lamp lies (which the angles take account of already), then angles, then factors.
  void tilt_table() {
    number("lamp orientation");
    const uint64_t count = this->count("tilt angles", kMostAngles);
    LampTilt& tilt = out_.tilt;
    for (uint64_t i = 0; i < count; ++i) tilt.angles.push_back(float(number("tilt angle")));
    for (uint64_t i = 0; i < count; ++i) tilt.factors.push_back(float(number("tilt factor")));
    const bool rising = std::is_sorted(tilt.angles.begin(), tilt.angles.end());
    if (rising && std::none_of(tilt.factors.begin(), tilt.factors.end(), [](float f) { return f < 0; })) return;
    out_.warnings.add("tilt factors with angles that fall, or below 0, were taken as 1");
    tilt = {};
  }

  void numbers() {
    lamps_ = number("number of lamps");
    lumens_ = number("lumens per lamp");
    multiplier_ = number("candela multiplier");
    const uint64_t vertical = count("vertical angles", kMostAngles),
                   horizontal = count("horizontal angles", kMostAngles);
    if (vertical == 0 || horizontal == 0) fail("has no angles");
    if (vertical * horizontal > kMostValues || vertical * horizontal > text_.size())
      fail(fmt::format("{} x {} intensities are claimed in {} bytes", vertical, horizontal, text_.size()));
    type_ = int(number("photometric type"));
    if (type_ < 1 || type_ > 3) fail(fmt::format("photometric type {} is none of 1 (C), 2 (B), 3 (A)", type_));
    const double units = number("units");
    if (units != 1 && units != 2) fail(fmt::format("units {} are neither 1 (feet) nor 2 (metres)", units));
    const float unit = units == 1 ? kFoot : 1;
    const float width = float(number("width")) * unit, length = float(number("length")) * unit;
    opening(width, length, float(number("height")) * unit);
    const double ballast = number("ballast factor"), photometric = number("ballast-lamp photometric factor");
    out_.watts = number("input watts");
    const double factor = multiplier_ * ballast * photometric;
    for (uint64_t i = 0; i < vertical; ++i) grid_.vertical.push_back(float(number("vertical angle")));
    for (uint64_t i = 0; i < horizontal; ++i) grid_.horizontal.push_back(float(number("horizontal angle")));
    uint64_t negative = 0;
    for (uint64_t i = 0; i < vertical * horizontal; ++i) {
      const double candela = number("candela") * factor;
      negative += candela < 0;
      grid_.candela.push_back(float(std::max(candela, 0.0)));
    }
    out_.warnings.add("negative intensities were taken as 0", negative);
    if (lumens_ > 0) out_.lamp_flux = lumens_ * std::max(lamps_, 1.0);
  }

  /// The signs of LM-63: negative lengths are round.
  void opening(float width, float length, float height) {
    LuminousOpening& o = out_.opening;
    using Shape = LuminousOpening::Shape;
    o.width = std::abs(width), o.length = std::abs(length), o.height = std::abs(height);
    if (o.width == 0 && o.length == 0 && o.height == 0) return;
    const bool round = width < 0 || length < 0;
    if (round && o.length == 0) o.length = o.width;
    if (round && o.width == 0) o.width = o.length;
    o.shape = round && height < 0 ? Shape::sphere
              : round             ? Shape::ellipse
              : height < 0        ? Shape::cylinder
                                  : Shape::rectangle;
  }

  void finish() {
    auto table = std::make_shared<PhotometricTable>();
    if (type_ == 1) {
      *table = {grid_.horizontal, grid_.vertical, grid_.candela};
      out_.symmetry = complete_planes(*table);
    } else {
      *table = resampled();
      out_.symmetry = "none";
    }
    check(*table);
    out_.table = std::move(table);
  }

  /// Type B: the poles are on the width axis (y, C90), the vertical angle turns about it and the horizontal one leads
  /// to the pole. Type A: the poles are on the length axis (x, C0), the horizontal angle turns about it and the
  /// vertical one leads to the pole. (0, 0) is gamma = 0 in both; only half of a symmetric distribution is stored.
  PhotometricTable resampled() {
    mirror_half(grid_.horizontal, true), mirror_half(grid_.vertical, false);
    PhotometricTable table;
    const float step = std::min(finest(grid_.horizontal), finest(grid_.vertical));
    const int steps = step < 0.9f ? 720 : step < 2.4f ? 360 : 144;  // 0.5, 1 or 2.5 degrees
    for (int i = 0; i <= steps; ++i) table.c.push_back(360.0f * float(i) / float(steps));
    for (int i = 0; i <= steps / 2; ++i) table.gamma.push_back(360.0f * float(i) / float(steps));
    for (const float c : table.c)
      for (const float gamma : table.gamma) {
        const double g = double(gamma) * kPi / 180, a = double(c) * kPi / 180;
        const double x = std::sin(g) * std::cos(a), y = std::sin(g) * std::sin(a), z = std::cos(g);
        const double pole = type_ == 2 ? y : x, side = type_ == 2 ? x : y;
        const double vertical = type_ == 2 ? std::atan2(side, z) : std::asin(std::clamp(pole, -1.0, 1.0));
        const double horizontal = type_ == 2 ? std::asin(std::clamp(pole, -1.0, 1.0)) : std::atan2(side, z);
        table.candela.push_back(at(float(horizontal * 180 / kPi), float(vertical * 180 / kPi)));
      }
    return table;
  }

  /// Least distance of neighbours, degrees; 90 where there is one angle only.
  static float finest(const std::vector<float>& angles) {
    float least = 90;
    for (size_t i = 1; i < angles.size(); ++i) least = std::min(least, std::abs(angles[i] - angles[i - 1]));
    return least;
  }

  /// 0 .. 90 stands for -90 .. 90 as well.
  void mirror_half(std::vector<float>& angles, bool horizontal) {
    if (angles.front() != 0 || angles.size() < 2) return;
    std::vector<float> all(angles.rbegin(), angles.rend() - 1);
    for (float& angle : all) angle = -angle;
    all.insert(all.end(), angles.begin(), angles.end());
    const size_t n = angles.size(), other = grid_.candela.size() / n;
    std::vector<float> candela;
    for (size_t i = 0; i < (horizontal ? all.size() : other); ++i)
      for (size_t k = 0; k < (horizontal ? other : all.size()); ++k) {
        const auto back = [&](size_t m) { return m < n - 1 ? n - 1 - m : m - (n - 1); };
        candela.push_back(grid_.candela[horizontal ? back(i) * other + k : i * n + back(k)]);
      }
    angles = std::move(all), grid_.candela = std::move(candela);
  }

  float at(float horizontal, float vertical) const {
    const auto find = [](const std::vector<float>& angles, float value, float& t) {
      const auto above = std::upper_bound(angles.begin(), angles.end(), value);
      if (above == angles.begin() || (above == angles.end() && value > angles.back())) return angles.size();
      const size_t i = above == angles.end() ? angles.size() - 1 : size_t(above - angles.begin()) - 1;
      t = i + 1 < angles.size() ? (value - angles[i]) / (angles[i + 1] - angles[i]) : 0;
      return i;
    };
    const size_t n = grid_.vertical.size();
    float s = 0, t = 0;
    const size_t h = find(grid_.horizontal, horizontal, s), v = find(grid_.vertical, vertical, t);
    if (h == grid_.horizontal.size() || v == n) return 0;
    const size_t h1 = std::min(h + 1, grid_.horizontal.size() - 1), v1 = std::min(v + 1, n - 1);
    const auto value = [&](size_t i, size_t k) { return grid_.candela[i * n + k]; };
    const float low = value(h, v) + (value(h, v1) - value(h, v)) * t;
    return low + (value(h1, v) + (value(h1, v1) - value(h1, v)) * t - low) * s;
  }

  double number(const char* what) {
    std::string_view word = next();
    if (word.empty()) fail(fmt::format("ends where the {} is expected", what));
    double value = 0;
    if (!parse_number(word, value) || !std::isfinite(value))
      fail(fmt::format("{} is '{}', not a number", what, word.substr(0, 40)));
    return value;
  }
  uint64_t count(const char* what, uint64_t most) {
    const double value = number(what);
    if (!(value >= 0 && value <= double(most) && value == std::floor(value)))
      fail(fmt::format("number of {} is {}, accepted 0 .. {}", what, value, most));
    return uint64_t(value);
  }
  /// Words are separated by blanks or commas.
  std::string_view next() {
    while (true) {
      const size_t begin = line_.find_first_not_of(" \t,");
      if (begin != line_.npos) {
        const size_t end = std::min(line_.find_first_of(" \t,", begin), line_.size());
        const std::string_view word = line_.substr(begin, end - begin);
        line_.remove_prefix(end);
        return word;
      }
      if (!lines_.next(line_)) return {};
    }
  }
  [[noreturn]] void fail(std::string what) const {
    throw Error(Code::bad_input, place(where_, std::max<size_t>(lines_.number(), 1)), std::move(what));
  }

  std::string text_;
  Lines lines_;
  std::string_view line_;
  Path folder_;
  const std::string& where_;
  Luminaire out_;
  Grid grid_;
  int type_ = 1;
  double lamps_ = 1, lumens_ = -1, multiplier_ = 1;
};

}  // namespace

Luminaire read_ies(std::span<const uint8_t> bytes, const Path& folder, const std::string& where) {
  return IesReader(bytes, folder, where).run();
}

}  // namespace aktina
