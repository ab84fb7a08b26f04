// Pictures in files, and how far two are apart.
#include <pybind11/stl.h>

#include "aktina/image/file_format.h"
#include "aktina/image/metric.h"
#include "arrays.h"
#include "rooms.h"
#include "work.h"

namespace aktina::python {
namespace {

Array read_picture(const std::string& path) {
  Image image = run(py::none(), [&](Progress&) { return read_image(path); });
  return array(std::move(image.pixels), {image.height, image.width, image.channels});
}

/// (H, W, C) float32, contiguous: the Python side has seen to it.
Image picture_of(const py::buffer& buffer, const char* name) {
  const py::buffer_info shape = buffer.request();
  if (shape.ndim != 3) throw Error(Code::usage, name, "the array does not fit", "(height, width, channels)");
  const Rows<const float> rows(buffer, shape.shape[2], name);
  Image image;
  image.height = int(shape.shape[0]), image.width = int(shape.shape[1]), image.channels = int(shape.shape[2]);
  image.pixels.assign(rows.data(), rows.data() + rows.values().size());
  return image;
}

ToneCurve curve_of(const std::string& name) {
  if (name == "none") return ToneCurve::none;
  if (name == "reinhard") return ToneCurve::reinhard;
  if (name == "filmic") return ToneCurve::filmic;
  throw Error(Code::usage, "curve", "'" + name + "' is no tone curve", "none, reinhard or filmic");
}

DynamicRange range_of(const std::string& name) {
  if (name == "auto") return DynamicRange::automatic;
  if (name == "low") return DynamicRange::low;
  if (name == "high") return DynamicRange::high;
  throw Error(Code::usage, "range", "'" + name + "' is no range", "auto, low or high");
}

void write_picture(const std::string& path, const py::buffer& pixels, float exposure, const std::string& curve,
                   int bits, const std::vector<std::pair<std::string, std::string>>& metadata) {
  const Image image = picture_of(pixels, "image");
  const ImageWriteOptions options{{exposure, curve_of(curve)}, bits, metadata};
  run(py::none(), [&](Progress&) { return write_image(path, image, options), true; });
}

py::dict compare_pictures(const py::buffer& a, const py::buffer& b, const std::string& range) {
  const Image picture = picture_of(a, "a"), reference = picture_of(b, "b");
  const DynamicRange chosen = range_of(range);
  const ImageComparison c = run(py::none(), [&](Progress&) { return compare(picture, reference, chosen); });
  py::dict result;
  result["flip"] = c.flip, result["rmse"] = c.rmse, result["psnr"] = c.psnr, result["max_error"] = c.max_error;
  result["relative_mse"] = c.relative_mse, result["ssim"] = c.ssim, result["range"] = c.flip_hdr ? "high" : "low";
  result["non_finite_a"] = c.non_finite_a, result["non_finite_b"] = c.non_finite_b;
  return result;
}

}  // namespace

void bind_images(py::module_& m) {
  m.def("read_image", &read_picture);
  m.def("write_image", &write_picture);
  m.def("compare", &compare_pictures);
}

}  // namespace aktina::python
