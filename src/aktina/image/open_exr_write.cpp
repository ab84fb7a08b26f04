// OpenEXR out: 32-bit floats, which illuminances and positions need, losslessly packed (ZIP); one part with named
// layers.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/image/exr_layers.h"
#include "aktina/image/exr_stream.h"
#include "aktina/image/open_exr.h"

namespace aktina {
namespace {

void add_metadata(Imf::Header& header, const ImageWriteOptions& options) {
  for (const auto& [key, value] : options.metadata) {
    if (key.empty() || key.size() > 200) throw Error(Code::usage, key, "no name for an OpenEXR attribute");
    const bool taken = header.find(key) != header.end();  // "compression" and the like
    header.insert(taken ? "metadata." + key : key, Imf::StringAttribute(value));
  }
}

std::vector<uint8_t> encode(const LayeredImage& picture, const ImageWriteOptions& options) {
  const Image& first = picture.layers[0].image;
  Imf::Header header(first.width, first.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // Rec. 709
  add_metadata(header, options);
  Imf::FrameBuffer frame;
  for (const auto& [name, image] : picture.layers) {
    const std::vector<std::string> channels = exr_channel_names(name, image.channels);
    for (size_t c = 0; c < channels.size(); ++c) {
      if (header.channels().findChannel(channels[c])) throw Error(Code::usage, name, "two layers have the same name");
      header.channels().insert(channels[c], Imf::Channel(Imf::FLOAT));
      const size_t pixel = sizeof(float) * size_t(image.channels);
      auto* const base = reinterpret_cast<char*>(const_cast<float*>(image.pixels.data() + c));  // only read
      frame.insert(channels[c], Imf::Slice(Imf::FLOAT, base, pixel, pixel * size_t(image.width)));
    }
  }
  Imf::setGlobalThreadCount(thread_count());
  ExrOutput out;
  {
    Imf::OutputFile file(out, header);
    file.setFrameBuffer(frame);
    file.writePixels(first.height);
  }  // writes the table of offsets
  return out.take();
}

}  // namespace

std::vector<uint8_t> encode_exr(const LayeredImage& picture, const ImageWriteOptions& options) {
  try {
    return encode(picture, options);
  } catch (const Iex::BaseExc& error) {
    throw Error(Code::usage, "OpenEXR", error.what());
  }
}

}  // namespace aktina
