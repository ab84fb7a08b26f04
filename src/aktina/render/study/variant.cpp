#include "aktina/render/study/variant.h"

#include <fmt/format.h>

#include "aktina/base/error.h"
#include "aktina/illumination/normals/normals.h"
#include "aktina/render/catalogue.h"
#include "aktina/render/study/within.h"

namespace aktina {
namespace {

constexpr float kCrease = 1.05f;  // rad: edges sharper than this stay edges when normals are made anew

void choose_shading(RenderOptions& o, const std::string& m) { o.method = "raster", o.shading = m; }
void choose_illumination(RenderOptions& o, const std::string& m) { o.method = "raster", o.illumination = m; }
void choose_normals(RenderOptions& o, const std::string&) { o.method = "raster"; }
void choose_method(RenderOptions& o, const std::string& m) { o.method = m; }

constexpr StudyFamily kFamilies[] = {
    {"shading", "phong", true, choose_shading},     {"illumination", "phong", true, choose_illumination},
    {"normals", kOwnNormals, true, choose_normals}, {"integrator", "path", false, choose_method},
    {"specular", "path", false, choose_method},
};

}  // namespace

const StudyFamily& find_study_family(std::string_view id) {
  for (const StudyFamily& family : kFamilies)
    if (family.id == id) return family;
  throw Error(Code::usage, "family", fmt::format("'{}' is no family whose methods pictures can compare", id),
              fmt::format("there are: {}", fmt::join(kStudyFamilies, ", ")));
}

RenderOptions options_of(const StudyFamily& family, const std::string& method, const StudyOptions& study) {
  RenderOptions options;
  options.method = "raster", options.shading = "phong", options.illumination = study.illumination;
  options.seed = options.radiosity.seed = study.seed;
  if (method == kOwnNormals) return options;
  const std::string id = parse_method(method).id;
  for (const MethodInfo* integrator : find_family("integrator").methods)
    if (integrator->id == id) {
      options.method = method;
      return options;
    }
  find_method(find_family(family.id), id);
  family.choose(options, method);
  return options;
}

Scene with_normals(const Scene& scene, const std::string& method) {
  Scene out = scene;
  const FacetWeighting weighting = make_method(normals(), "normals", method);
  for (Mesh& mesh : out.meshes) {
    mesh.normals.clear(), mesh.tangents.clear();
    generate_normals(mesh, kCrease, weighting);
  }
  return out;
}

Variant::Variant(const Scene& scene, const StudyFamily& family, const std::string& method, const StudyOptions& study)
    : scene_(scene), options_(options_of(family, method, study)), rasterized_(options_.method == "raster") {
  if (family.id == "normals" && rasterized_ && method != kOwnNormals) own_ = with_normals(scene, method);
  options_.samples = study.samples;
}

Image Variant::draw(const Camera& camera, int width, int height, int samples, Progress& outer) const {
  RenderOptions options = options_;
  options.view = &camera, options.width = width, options.height = height, options.samples = samples;
  return within(outer,
                [&](Progress& inner) { return std::move(render(scene(), options, inner).picture.layers[0].image); });
}

Variant::Frames::Frames(const Variant& variant, const Camera& camera, int width, int height)
    : variant_(variant), camera_(camera), width_(width), height_(height) {
  if (!variant.rasterized_) return;
  rasterizer_.emplace(variant.scene(), RasterOptions{.shading = variant.options_.shading,
                                                     .illumination = variant.options_.illumination});
}

void Variant::Frames::draw(Progress& outer) {
  if (rasterizer_) {
    outer.throw_if_cancelled();
    rasterizer_->draw(camera_, width_, height_, out_);
    cost_ = rasterizer_->last_frame();
    return;
  }
  RenderOptions options = variant_.options_;
  options.view = &camera_, options.width = width_, options.height = height_;
  const Report report = within(outer, [&](Progress& inner) { return render(variant_.scene(), options, inner).report; });
  cost_ = {};
  for (size_t i = 0; i + 1 < report.timings.size(); ++i) cost_.setup_seconds += report.timings[i].seconds;
  if (!report.timings.empty()) cost_.pixel_seconds = report.timings.back().seconds;
}

}  // namespace aktina
