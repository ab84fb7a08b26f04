// Radiance pictures (.hdr, .pic): a mantissa for each of three channels and a common exponent. Read flat, with the old
// and the new run lengths, in all eight orientations, as RGB or XYZ, with or without a FORMAT line; the EXPOSURE and
// COLORCORR that a file says were applied are divided out. Written top to bottom with the new run lengths.
//
// A mantissa m stands for m / 256, as most programs have it; Radiance itself adds half a step.
//
// G. Ward, "Real Pixels", Graphics Gems II, 1991; "Radiance File Formats", radsite.lbl.gov/radiance/refer/filefmts.pdf.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/image/codec.h"

namespace aktina {
namespace {

using Rgbe = std::array<uint8_t, 4>;

/// Reads lines and bytes; the end of the file is an error.
struct Reader {
  Bytes bytes;
  const std::string& where;
  size_t position = 0;

  std::string_view line() {
    const size_t begin = position;
    while (next() != '\n') continue;
    return {reinterpret_cast<const char*>(bytes.data()) + begin, position - 1 - begin};
  }
  uint8_t next() {
    if (position >= bytes.size()) throw Error(Code::bad_input, where, "the Radiance picture is truncated");
    return bytes[position++];
  }
  Rgbe pixel() {
    Rgbe p;
    for (uint8_t& value : p) value = next();
    return p;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(Code::bad_input, where, "broken Radiance picture: " + what);
  }
};

struct Layout {
  int width = 0, height = 0;  // of the picture as it is seen
  bool columns = false;       // stored column by column
  bool flip_x = false, flip_y = false;
  bool xyz = false;
  Rgb scale{1};  // what values were multiplied with
};

/// Positive finite numbers of a header line; what is none is left out, as Radiance does.
std::vector<float> factors(std::string_view text) {
  std::vector<float> values;
  while (!text.empty()) {
    float value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && std::isnormal(value) && value > 0) values.push_back(value);
    text.remove_prefix(error == std::errc() ? size_t(end - text.data()) : 1);
  }
  return values;
}

void read_variables(Reader& in, Layout& layout) {
  for (std::string_view line = in.line(); !line.empty() && line != "\r"; line = in.line()) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    const size_t equals = line.find('=');
    if (equals == line.npos) continue;
    const std::string_view name = line.substr(0, equals), value = line.substr(equals + 1);
    if (name == "FORMAT") {
      layout.xyz = value.find("32-bit_rle_xyze") != value.npos;
      if (!layout.xyz && value.find("32-bit_rle_rgbe") == value.npos)
        throw Error(Code::unsupported, in.where, fmt::format("Radiance format '{}'", value.substr(0, 40)),
                    "32-bit_rle_rgbe or 32-bit_rle_xyze");
    } else if (name == "EXPOSURE" || name == "COLORCORR") {
      const std::vector<float> f = factors(value);
      if (f.size() == 1) layout.scale *= f[0];
      if (f.size() == 3) layout.scale *= Rgb{f[0], f[1], f[2]};
    }
  }
}

/// "-Y height +X width": the slow axis first; rows from bottom to top are +Y.
void read_resolution(Reader& in, Layout& layout) {
  std::string_view line = in.line();
  const auto axis = [&](char& sign, char& name) {
    if (line.size() < 4) in.fail("no resolution");
    sign = line[0], name = line[1];
    line.remove_prefix(2);
    while (line.starts_with(' ')) line.remove_prefix(1);
    uint32_t size = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), size);
    if (error != std::errc() || (sign != '-' && sign != '+')) in.fail("no resolution");
    line.remove_prefix(size_t(end - line.data()));
    while (line.starts_with(' ')) line.remove_prefix(1);
    return size;
  };
  char sign[2], name[2];
  const uint32_t slow = axis(sign[0], name[0]), fast = axis(sign[1], name[1]);
  layout.columns = name[0] == 'X';
  if (name[0] == name[1] || (name[0] != 'X' && name[0] != 'Y') || (name[1] != 'X' && name[1] != 'Y'))
    in.fail("no resolution");
  const int x = layout.columns ? 0 : 1;
  layout.flip_x = sign[x] == '-', layout.flip_y = sign[1 - x] == '+';
  check_image_size(slow, fast, 12, in.bytes.size(), in.where);
  layout.width = int(layout.columns ? slow : fast), layout.height = int(layout.columns ? fast : slow);
}

Layout read_layout(Reader& in) {
  Layout layout;
  read_variables(in, layout);
  read_resolution(in, layout);
  return layout;
}

/// The run lengths of 1991: a pixel (1, 1, 1, n) repeats the one before n times; directly following ones give the
/// higher bytes of n.
void read_old_scanline(Reader& in, std::span<Rgbe> line) {
  size_t i = 0;
  unsigned shift = 0;
  while (i < line.size()) {
    const Rgbe p = in.pixel();
    if (p[0] != 1 || p[1] != 1 || p[2] != 1) {
      line[i++] = p;
      shift = 0;
      continue;
    }
    const size_t count = shift < 32 ? size_t(p[3]) << shift : line.size();
    if (i == 0 || count > line.size() - i) in.fail("a run is longer than its line");
    std::fill_n(line.begin() + std::ptrdiff_t(i), count, line[i - 1]);
    i += count;
    shift += 8;
  }
}

/// Four channels one after the other, each of runs (128 + length, value) and stretches (length, values).
void read_new_scanline(Reader& in, std::span<Rgbe> line) {
  for (size_t channel = 0; channel < 4; ++channel) {
    for (size_t i = 0; i < line.size();) {
      const uint8_t code = in.next();
      const bool run = code > 128;
      const size_t count = run ? code - 128u : code;
      if (count == 0 || count > line.size() - i) in.fail("a run is longer than its line");
      const uint8_t value = run ? in.next() : uint8_t(0);
      for (size_t k = 0; k < count; ++k) line[i++][channel] = run ? value : in.next();
    }
  }
}

void read_scanline(Reader& in, std::span<Rgbe> line) {
  if (line.size() >= 8 && line.size() < 32768 && in.position + 4 <= in.bytes.size()) {
    const uint8_t* const p = in.bytes.data() + in.position;
    if (p[0] == 2 && p[1] == 2 && p[2] < 128) {
      if (size_t(p[2] << 8 | p[3]) != line.size()) in.fail("a line has another length than the picture");
      in.position += 4;
      return read_new_scanline(in, line);
    }
  }
  read_old_scanline(in, line);
}

Rgb linear(const Rgbe& p) {
  if (p[3] == 0) return {};
  const float unit = std::ldexp(1.0f, p[3] - (128 + 8));
  return {float(p[0]) * unit, float(p[1]) * unit, float(p[2]) * unit};
}

/// CIE XYZ to Rec. 709 primaries with equal energy as white, as Radiance has it: the usual matrix for D65, each row
/// divided by its sum.
Rgb rec709(Rgb xyz) {
  const auto row = [&](float x, float y, float z) { return (x * xyz.r + y * xyz.g + z * xyz.b) / (x + y + z); };
  return {row(3.2404542f, -1.5371385f, -0.4985314f), row(-0.9692660f, 1.8760108f, 0.0415560f),
          row(0.0556434f, -0.2040259f, 1.0572252f)};
}

ImageHeader header(Bytes bytes, const std::string& where) {
  Reader in{bytes, where};
  const Layout layout = read_layout(in);
  return {ImageFormat::hdr, layout.width, layout.height, 3, 8, {}};
}

Image decode(Bytes bytes, const std::string& where) {
  Reader in{bytes, where};
  const Layout layout = read_layout(in);
  Image image(layout.width, layout.height, 3);
  const int lines = layout.columns ? layout.width : layout.height;
  std::vector<Rgbe> line(size_t(layout.columns ? layout.height : layout.width));
  const Rgb scale{1 / layout.scale.r, 1 / layout.scale.g, 1 / layout.scale.b};
  for (int slow = 0; slow < lines; ++slow) {
    read_scanline(in, line);
    for (int fast = 0; fast < int(line.size()); ++fast) {
      const int x = layout.columns ? slow : fast, y = layout.columns ? fast : slow;
      const Rgb value = linear(line[size_t(fast)]) * scale;
      image.set_rgb(layout.flip_x ? layout.width - 1 - x : x, layout.flip_y ? layout.height - 1 - y : y,
                    layout.xyz ? rec709(value) : value);
    }
  }
  return image;
}

/// Rounded to the nearest mantissa; what is negative or no number becomes 0.
Rgbe encoded(Rgb c) {
  for (int i = 0; i < 3; ++i) c[i] = c[i] > 0 ? std::min(c[i], 1e38f) : 0;
  const float top = max_channel(c);
  if (top < 1e-37f) return {};
  int exponent = 0;
  if (std::frexp(top, &exponent) > 255.5f / 256) ++exponent;  // would round up to 256
  const float scale = std::ldexp(1.0f, 8 - exponent);
  const auto mantissa = [&](float v) { return uint8_t(std::lround(v * scale)); };
  return {mantissa(c.r), mantissa(c.g), mantissa(c.b), uint8_t(exponent + 128)};
}

/// One channel of a line as runs of at least four and stretches of at most 128.
void write_runs(const std::vector<Rgbe>& line, size_t channel, std::vector<uint8_t>& out) {
  const auto run_at = [&](size_t i) {
    size_t n = 1;
    while (n < 127 && i + n < line.size() && line[i + n][channel] == line[i][channel]) ++n;
    return n;
  };
  for (size_t i = 0; i < line.size();) {
    size_t run = run_at(i), begin = i;
    while (run < 4 && i < line.size() && i - begin < 128) {
      ++i;
      run = i < line.size() ? run_at(i) : 0;
    }
    if (i > begin) out.push_back(uint8_t(i - begin));
    for (; begin < i; ++begin) out.push_back(line[begin][channel]);
    if (run < 4) continue;
    out.push_back(uint8_t(128 + run));
    out.push_back(line[i][channel]);
    i += run;
  }
}

std::vector<uint8_t> encode(const LayeredImage& picture, const ImageWriteOptions& options) {
  const Image& image = picture.layers[0].image;
  std::string text = "#?RADIANCE\n";
  for (const auto& [key, value] : options.metadata) text += one_line(fmt::format("# {}: {}", key, value)) + "\n";
  text += fmt::format("FORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height, image.width);
  std::vector<uint8_t> out(text.begin(), text.end());
  const bool runs = image.width >= 8 && image.width < 32768;
  std::vector<Rgbe> line(size_t(image.width));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) line[size_t(x)] = encoded(image.rgb(x, y));
    if (runs) {
      out.insert(out.end(), {2, 2, uint8_t(image.width >> 8), uint8_t(image.width & 255)});
      for (size_t channel = 0; channel < 4; ++channel) write_runs(line, channel, out);
    } else {
      for (const Rgbe& p : line) out.insert(out.end(), p.begin(), p.end());
    }
  }
  return out;
}

/// Old pictures begin with any text.
bool recognizes(Bytes bytes) {
  const std::string_view head(reinterpret_cast<const char*>(bytes.data()), std::min<size_t>(bytes.size(), 1024));
  return head.starts_with("#?") || head.find("\nFORMAT=32-bit_rle_") != head.npos;
}

}  // namespace

extern constinit const ImageCodec radiance_hdr_codec = {ImageFormat::hdr, "hdr",   recognizes, header,
                                                        decode,           nullptr, nullptr,    encode};

}  // namespace aktina
