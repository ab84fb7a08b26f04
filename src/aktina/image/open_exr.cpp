// OpenEXR in: scan lines and tiles (the finest level of several), every compression, half, float and whole numbers, one
// part or several, sub-sampled channels, luminance and chroma. Pixels are placed in the display window; what lies
// outside of the data is 0. Colours with other primaries are converted to Rec. 709. Deep pictures are refused.
//
// openexr.com, "Technical Introduction to OpenEXR" and "Reading and Writing OpenEXR Image Files".
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaYca.h>
#include <ImfStandardAttributes.h>
#include <ImfThreading.h>
#include <ImfTileDescription.h>

#include <algorithm>
#include <map>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/image/exr_header.h"
#include "aktina/image/exr_layers.h"
#include "aktina/image/exr_stream.h"
#include "aktina/image/open_exr.h"

namespace aktina {
namespace {

using Imath::Box2i;

struct Size {
  uint64_t width, height;
};
/// The corners may be any 32-bit numbers.
Size size_of(const Box2i& box) {
  const auto side = [](int low, int high) { return high < low ? 0 : uint64_t(int64_t(high) - low + 1); };
  return {side(box.min.x, box.max.x), side(box.min.y, box.max.y)};
}

std::vector<ExrLayer> layers_of(const Imf::Header& header) {
  std::vector<std::string> names;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) names.emplace_back(c.name());
  return group_exr_channels(names);
}

/// A file whose headers have been read and found sane.
class File {
 public:
  File(Bytes bytes, const std::string& where)
      : stream_((check_exr_header(bytes, where), bytes)), file_(stream_, threads(), false), where_(where) {
    for (int part = 0; part < file_.parts(); ++part) check(file_.header(part), bytes.size());
  }

  int parts() const { return file_.parts(); }
  const Imf::Header& header(int part) const { return file_.header(part); }

  /// The layers of one part that `wanted` names.
  std::vector<Image> read(int part, const std::vector<ExrLayer>& wanted);

 private:
  static int threads() {
    Imf::setGlobalThreadCount(thread_count());
    return thread_count();
  }

  void check(const Imf::Header& header, size_t encoded) const {
    if (header.hasType() && Imf::isDeepData(header.type()))
      throw Error(Code::unsupported, where_, "is a deep picture", "flatten it first");
    uint64_t pixel = 0;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) pixel += sizeof(float);
    if (pixel == 0) throw Error(Code::bad_input, where_, "has no channels");
    for (const Box2i& box : {header.dataWindow(), header.displayWindow()}) {
      const Size size = size_of(box);
      check_image_size(size.width, size.height, pixel, encoded, where_);
    }
    if (header.hasTileDescription()) {
      const Imf::TileDescription& tile = header.tileDescription();
      const Size data = size_of(header.dataWindow());  // a row of tiles is held at once
      check_image_size(std::max<uint64_t>(data.width, tile.xSize), tile.ySize, pixel, encoded, where_);
    }
  }

  ExrInput stream_;
  Imf::MultiPartInputFile file_;
  const std::string& where_;
};

/// A sub-sampled channel, by itself.
struct Plane {
  int width, height, step_x, step_y;
  std::vector<float> values;

  /// Between the four samples around a pixel of the full picture.
  float at(int x, int y) const {
    const float u = float(x) / float(step_x), v = float(y) / float(step_y);
    const int i = std::min(int(u), width - 1), j = std::min(int(v), height - 1);
    const int right = std::min(i + 1, width - 1), below = std::min(j + 1, height - 1);
    const float fx = u - float(i), fy = v - float(j);
    const auto value = [&](int column, int row) { return values[size_t(row) * size_t(width) + size_t(column)]; };
    return (value(i, j) * (1 - fx) + value(right, j) * fx) * (1 - fy) +
           (value(i, below) * (1 - fx) + value(right, below) * fx) * fy;
  }
};

/// Where the library puts the channels of one part.
struct Target {
  Box2i window;
  Imf::FrameBuffer frame;
  std::vector<Image> images;                          // of the data window
  std::map<std::pair<size_t, size_t>, Plane> planes;  // by layer and channel

  Target(const Imf::Header& header, const std::vector<ExrLayer>& layers) : window(header.dataWindow()) {
    const Size size = size_of(window);
    images.reserve(layers.size());
    for (const ExrLayer& layer : layers) {
      images.emplace_back(int(size.width), int(size.height), layer.image_channels());
      for (size_t c = 0; c < layer.channels.size(); ++c)
        insert(layer.channels[c], header.channels()[layer.channels[c].c_str()], c);
    }
  }

  void insert(const std::string& name, const Imf::Channel& channel, size_t c) {
    Image& image = images.back();
    const int xs = channel.xSampling, ys = channel.ySampling;
    float* base = image.pixels.data() + c;
    size_t pixel = sizeof(float) * size_t(image.channels), row = pixel * size_t(image.width);
    if (xs != 1 || ys != 1) {
      Plane& plane = planes[{images.size() - 1, c}];
      plane = {(image.width + xs - 1) / xs, (image.height + ys - 1) / ys, xs, ys, {}};
      plane.values.resize(size_t(plane.width) * size_t(plane.height));
      base = plane.values.data();
      pixel = sizeof(float), row = pixel * size_t(plane.width);
    }
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, base, window, pixel, row, xs, ys));
  }

  void spread_planes() {
    for (const auto& [place, plane] : planes) {
      Image& image = images[place.first];
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) image.at(x, y)[place.second] = plane.at(x, y);
    }
  }
};

/// R = (RY + 1) Y, B = (BY + 1) Y, and G what is left of Y.
void decode_luminance_chroma(Image& image, const Imf::Chromaticities& primaries) {
  const Imath::V3f weight = Imf::RgbaYca::computeYw(primaries);
  for (size_t i = 0; i < image.pixels.size(); i += size_t(image.channels)) {
    float* const p = &image.pixels[i];
    const float y = p[0], red = (p[1] + 1) * y, blue = (p[2] + 1) * y;
    p[0] = red, p[1] = (y - red * weight.x - blue * weight.z) / weight.y, p[2] = blue;
  }
}

/// To Rec. 709, white kept where it is.
void convert_primaries(Image& image, const Imf::Chromaticities& primaries) {
  if (primaries == Imf::Chromaticities()) return;
  const Imath::M44f matrix = Imf::RGBtoXYZ(primaries, 1) * Imf::XYZtoRGB(Imf::Chromaticities(), 1);
  for (size_t i = 0; i < image.pixels.size(); i += size_t(image.channels)) {
    float* const p = &image.pixels[i];
    const Imath::V3f c = Imath::V3f(p[0], p[1], p[2]) * matrix;
    p[0] = c.x, p[1] = c.y, p[2] = c.z;
  }
}

/// The part of the data that lies in the display window.
Image placed(Image&& data, const Box2i& window, const Box2i& display) {
  if (window == display) return std::move(data);
  const Size size = size_of(display);
  Image image(int(size.width), int(size.height), data.channels);
  const int left = std::max(window.min.x, display.min.x), right = std::min(window.max.x, display.max.x);
  const int top = std::max(window.min.y, display.min.y), bottom = std::min(window.max.y, display.max.y);
  for (int y = top; y <= bottom && left <= right; ++y) {
    const float* const from = data.at(left - window.min.x, y - window.min.y);
    std::copy_n(from, size_t(right - left + 1) * size_t(data.channels),
                image.at(left - display.min.x, y - display.min.y));
  }
  return image;
}

std::vector<Image> File::read(int part, const std::vector<ExrLayer>& wanted) {
  const Imf::Header& header = file_.header(part);
  Imf::InputPart input(file_, part);
  Target target(header, wanted);
  input.setFrameBuffer(target.frame);
  input.readPixels(target.window.min.y, target.window.max.y);
  target.spread_planes();
  const Imf::Chromaticities primaries =
      Imf::hasChromaticities(header) ? Imf::chromaticities(header) : Imf::Chromaticities();
  for (size_t i = 0; i < wanted.size(); ++i) {
    Image& image = target.images[i];
    if (wanted[i].luminance_chroma) decode_luminance_chroma(image, primaries);
    if (wanted[i].luminance_chroma || wanted[i].colour) convert_primaries(image, primaries);
    image = placed(std::move(image), target.window, header.displayWindow());
  }
  return std::move(target.images);
}

/// What the library throws at broken files becomes our error.
template <class Read>
auto guarded(const std::string& where, Read read) {
  try {
    return read();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(Code::limit, where, "not enough memory for the OpenEXR picture");
  } catch (const std::exception& error) {
    std::string what = error.what();
    constexpr std::string_view kFileName = "image file \"\". ";  // the stream has no name, and `where` says it already
    if (const size_t at = what.find(kFileName); at != what.npos) what.erase(0, at + kFileName.size());
    throw Error(Code::bad_input, where, "broken OpenEXR: " + what);
  }
}

/// Layers of the second and later parts go by the part's name.
std::string layer_name(const File& file, int part, const ExrLayer& layer) {
  if (part == 0 || !file.header(part).hasName()) return layer.name;
  const std::string& name = file.header(part).name();
  if (layer.name.empty()) return name;
  return layer.name.starts_with(name) ? layer.name : name + "." + layer.name;
}

ImageHeader header(Bytes bytes, const std::string& where) {
  return guarded(where, [&] {
    const File file(bytes, where);
    const Size size = size_of(file.header(0).displayWindow());
    const std::vector<ExrLayer> layers = layers_of(file.header(0));
    const Imf::Channel& channel = file.header(0).channels()[layers[0].channels[0].c_str()];
    ImageHeader found{ImageFormat::exr,
                      int(size.width),
                      int(size.height),
                      layers[0].image_channels(),
                      channel.type == Imf::HALF ? 16 : 32,
                      {}};
    for (int part = 0; part < file.parts(); ++part)
      for (const ExrLayer& layer : layers_of(file.header(part))) found.layers.push_back(layer_name(file, part, layer));
    return found;
  });
}

Image decode(Bytes bytes, const std::string& where) {
  return guarded(where, [&] {
    File file(bytes, where);
    return std::move(file.read(0, {layers_of(file.header(0))[0]})[0]);
  });
}

LayeredImage layers(Bytes bytes, const std::string& where) {
  return guarded(where, [&] {
    File file(bytes, where);
    LayeredImage picture;
    for (int part = 0; part < file.parts(); ++part) {
      const std::vector<ExrLayer> wanted = layers_of(file.header(part));
      std::vector<Image> images = file.read(part, wanted);
      for (size_t i = 0; i < wanted.size(); ++i)
        picture.layers.push_back({layer_name(file, part, wanted[i]), std::move(images[i])});
    }
    return picture;
  });
}

bool recognizes(Bytes bytes) { return starts_with(bytes, "\x76\x2f\x31\x01"); }

}  // namespace

extern constinit const ImageCodec open_exr_codec = {ImageFormat::exr, "exr",  recognizes, header,
                                                    decode,           layers, nullptr,    encode_exr};

}  // namespace aktina
