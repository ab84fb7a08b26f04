#include "aktina/radiosity/solver/quality.h"

#include <fmt/core.h>

#include "aktina/base/error.h"

namespace aktina {
namespace {

struct Quality {
  std::string_view id;
  double patches, tolerance, target_error;
  double coarse;  // most patches for indirect light, about: it needs no more, however fine the mesh
};
constexpr Quality kQualities[] = {
    {"draft", 4'000, 1e-2, 0.03, 1'000}, {"normal", 12'000, 1e-3, 0.01, 3'000}, {"fine", 48'000, 1e-4, 0.007, 10'000}};

constexpr double kUsualCoarse = 4;  // patch sizes, where nothing is computed apart

const Quality& quality_of(const std::string& id) {
  for (const Quality& q : kQualities)
    if (q.id == id) return q;
  throw Error(Code::usage, "quality", fmt::format("got {}", id), "one of draft, normal, fine");
}

void check(const char* name, double value, double most) {
  if (!(value >= 0 && value <= most))
    throw Error(Code::bad_param, name, fmt::format("got {:g}", value), fmt::format("accepted 0 .. {:g}", most));
}

}  // namespace

RadiosityOptions resolved(RadiosityOptions options) {
  const Quality& quality = quality_of(options.quality);
  check("tolerance", options.tolerance, 1);
  check("target_error", options.target_error, 1);
  check("indirect_size", options.indirect_size, 64);
  if (options.tolerance == 0) options.tolerance = quality.tolerance;
  if (options.target_error == 0) options.target_error = quality.target_error;
  return options;
}

MeshOptions mesh_options(const RadiosityOptions& options, bool apart) {
  MeshOptions mesh;
  mesh.patch_size = options.patch_size;
  mesh.usual_patches = quality_of(options.quality).patches;
  mesh.coarse = apart ? options.indirect_size : kUsualCoarse;
  if (apart) mesh.most_coarse = quality_of(options.quality).coarse;
  mesh.most_patches = options.most_patches;
  return mesh;
}

}  // namespace aktina
