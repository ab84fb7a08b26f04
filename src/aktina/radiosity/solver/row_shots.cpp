// Shots by any form-factor method, and the choice between them and rays.
#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/radiosity/solver/shots.h"

namespace aktina {
namespace {

constexpr double kUsualSamples = 4;

Polygon polygon_of(const PatchMesh& mesh, size_t patch) {
  Polygon polygon;
  for (size_t k = 0; k < (mesh.is_quad(patch) ? 4U : 3U); ++k)
    polygon.vertices.emplace_back(mesh.positions[mesh.patches[patch][k]]);
  return polygon;
}

}  // namespace

RowShots::RowShots(const Sides& sides, std::unique_ptr<FormFactorMethod> method)
    : sides_(sides), method_(std::move(method)) {
  const PatchMesh& mesh = sides.mesh();
  FormFactorScene scene;
  for (size_t i = 0; i < mesh.size(); ++i) {
    if (mesh.two_sided[i] || !is_black(mesh.transmittances[i]))
      throw Error(Code::unsupported, "formfactor", "this method takes opaque, one-sided surfaces only",
                  "formfactor=ray_cast");
    scene.surfaces.push_back(polygon_of(mesh, i));
  }
  method_->build(scene);
}

/// Rows of the shooter's patches, by area: what they see differs where something stands close before some of them.
void RowShots::column(size_t shooter, std::span<double> factors) const {
  const auto [first, count] = sides_.shooters()[shooter].range;
  const std::vector<float>& areas = sides_.mesh().areas;
  std::fill(factors.begin(), factors.end(), 0.0);
  for (size_t i = first; i < first + count; ++i) {
    const FormFactorRow row = method_->row(i);
    for (size_t s = 0; s < factors.size(); ++s) factors[s] += row.factors[s] * double(areas[i]) / double(areas[s]);
  }
  for (size_t s = 0; s < factors.size(); ++s)
    factors[s] = s >= first && s < first + count ? 0 : std::clamp(factors[s], 0.0, 1.0);
}

bool is_ray_cast(std::string_view formfactor) { return parse_method(formfactor).id == "ray_cast"; }

int ray_cast_samples(std::string_view formfactor) {
  const MethodChoice choice = parse_method(formfactor);
  double samples = kUsualSamples;
  for (const auto& [name, value] : choice.values) {
    if (name != "samples")
      throw Error(Code::usage, "ray_cast." + name, "shots of radiosity do not know this parameter",
                  "there is: samples");
    samples = value;
  }
  if (!(samples >= 1 && samples <= RayCastShots::kMostSamples) || samples != double(int(samples)))
    throw Error(Code::bad_param, "ray_cast.samples", fmt::format("got {:g}", samples),
                fmt::format("accepted 1 .. {}, whole", RayCastShots::kMostSamples));
  return int(samples);
}

}  // namespace aktina
