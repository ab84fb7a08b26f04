// aktina compare: how far two pictures are apart.
#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "aktina/base/error.h"
#include "aktina/image/file_format.h"
#include "aktina/image/metric.h"
#include "session.h"

namespace aktina::app {
namespace {

struct Picture {
  Image image;
  bool low = false;  // a format that ends at white
};

Picture read(const std::string& name) {
  const std::vector<uint8_t> bytes = read_file(name);
  const ImageFormat format = detect_image_format(bytes);
  const bool low = format == ImageFormat::png || format == ImageFormat::jpeg || format == ImageFormat::webp;
  return {decode_image(bytes, name), low};
}

/// A format that clips can be compared with another picture only where both are clipped.
DynamicRange range_of(const std::string& chosen, const Picture& a, const Picture& b) {
  if (chosen == "low") return DynamicRange::low;
  if (chosen == "high") return DynamicRange::high;
  return a.low || b.low ? DynamicRange::low : DynamicRange::automatic;
}

struct Row {
  std::string_view name, unit;
  double value;
};

std::vector<Row> rows(const ImageComparison& c) {
  return {{"flip", "1", c.flip},
          {"rmse", "1", c.rmse},
          {"psnr", "dB", c.psnr},
          {"max_error", "1", c.max_error},
          {"relative_mse", "1", c.relative_mse},
          {"ssim", "1", c.ssim},
          {"non_finite_a", "1", double(c.non_finite_a)},
          {"non_finite_b", "1", double(c.non_finite_b)}};
}

std::string table(const ImageComparison& c) {
  std::string text = fmt::format("range         {}\n", c.flip_hdr ? "high" : "low");
  for (const Row& row : rows(c))
    text += fmt::format("{:<13} {:.6g}{}\n", row.name, row.value, row.unit == "dB" ? " dB" : "");
  return text;
}

/// Infinity, which JSON has not, is null.
std::string json(const ImageComparison& c) {
  nlohmann::ordered_json result = {{"range", c.flip_hdr ? "high" : "low"}};
  for (const Row& row : rows(c)) {
    if (!std::isfinite(row.value))
      result[row.name] = nullptr;
    else
      result[row.name] = row.value;
  }
  return result.dump();
}

void write_map(const Path& path, const Picture& a, const Picture& b, bool hdr, Session& session) {
  const Image map = hdr ? flip_map_hdr(a.image, b.image) : flip_map(a.image, b.image);
  ImageWriteOptions options;
  options.tone_mapping.exposure = 1;
  options.metadata = {{"Software", "aktina"}, {"Settings", session.settings()}};
  write_image(path, false_colour(map), options);
  session.wrote(path);
}

/// @throws Error check_failed
void check(const Arguments& arguments, const ImageComparison& c) {
  if (!arguments.given("max-error")) return;
  const std::string& metric = arguments.text("metric");
  const double limit = arguments.number("max-error");
  for (const Row& row : rows(c))
    if (row.name == metric && !(row.value <= limit))
      throw Error(Code::check_failed, metric, fmt::format("{:.6g} exceeds {:g}", row.value, limit));
  if (c.non_finite_a != c.non_finite_b)
    throw Error(Code::check_failed, "non-finite values",
                fmt::format("the first picture has {}, the second {}", c.non_finite_a, c.non_finite_b));
}

int run(const Arguments& arguments, Session& session) {
  const std::string& output = arguments.text("output");
  if (!output.empty()) session.will_write(output);
  const Picture a = read(arguments.text("picture")), b = read(arguments.text("reference"));
  const ImageComparison result = compare(a.image, b.image, range_of(arguments.text("range"), a, b));
  if (!output.empty()) write_map(output, a, b, result.flip_hdr, session);
  session.finish({}, table(result), json(result));
  check(arguments, result);
  return 0;
}

constexpr Option kInputs[] = {
    {.name = "picture", .help = "PNG, JPEG, WebP, HDR, EXR or PFM", .kind = Kind::file, .value = "A", .required = true},
    {.name = "reference", .help = "what it should be", .kind = Kind::file, .value = "B", .required = true},
};
constexpr std::string_view kMetrics[] = {"flip", "rmse", "max_error", "relative_mse"};
constexpr std::string_view kRanges[] = {"auto", "low", "high"};
constexpr Option kOptions[] = {
    {.name = "output",
     .help = "write a map of the FLIP error in false colours, black for equal to pale yellow (.png, .exr, .hdr, .pfm)",
     .kind = Kind::file,
     .value = "FILE",
     .letter = 'o'},
    {.name = "max-error",
     .help = "end with status 5 if the metric is larger, or if only one picture has NaN or infinity",
     .kind = Kind::number,
     .value = "X",
     .min = 0},
    {.name = "metric",
     .help = "what --max-error bounds",
     .kind = Kind::choice,
     .value = "NAME",
     .fallback = "flip",
     .choices = kMetrics},
    {.name = "range",
     .help =
         "low: clip to what a screen shows; high: compare all of it; auto: low if a picture is PNG, JPEG or WebP or "
         "no value is above 1",
     .kind = Kind::choice,
     .value = "RANGE",
     .fallback = "auto",
     .choices = kRanges},
};
constexpr Example kExamples[] = {
    {"the metrics, and where the pictures differ", "aktina compare picture.png reference.png -o difference.png"},
    {"a test that fails where a viewer would see a difference", "aktina compare new.exr old.exr --max-error 0.02"},
    {"a bound on every single value", "aktina compare new.exr old.exr --metric max_error --max-error 1e-3 --json"},
};

}  // namespace

extern constinit const Command compare_command = {
    "compare",
    "compare two pictures: FLIP, RMSE, PSNR, SSIM and more",
    "Compares picture A with the reference B, of the same size, in linear light; alpha is left out. FLIP is the mean "
    "difference that a viewer sees, 0 to 1; it is what --max-error bounds unless --metric names another. Values that "
    "are NaN or infinite are counted and taken as 0.",
    kInputs,
    kOptions,
    false,
    kExamples,
    run};

}  // namespace aktina::app
