#include "aktina/render/bake_job.h"

#include <fmt/format.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/export/lightmap_files.h"

namespace aktina {

std::vector<std::string_view> bake_forms() { return {"vertex", "emissive", "lightmap"}; }

Baking::Baking(const Scene& scene, Radiosities& radiosities, std::string form, float exposure, LightmapOptions options)
    : scene_(scene), radiosities_(radiosities), form_(std::move(form)), exposure_(exposure), options_(options) {
  const auto forms = bake_forms();
  if (std::find(forms.begin(), forms.end(), form_) == forms.end())
    throw Error(Code::usage, "form", fmt::format("got '{}'", form_), fmt::format("one of {}", fmt::join(forms, ", ")));
  if (exposure_ == 0) exposure_ = lit_exposure(radiosities.solution);
  radiosities.report.count("exposure", double(exposure_), "1/(cd/m^2)");
}

std::vector<Path> Baking::write(const Path& path, Progress& progress) {
  const Metadata metadata = provenance(radiosities_.report);
  if (lower_extension(path) == "exr") return write_lightmap_pictures(path, lightmap(progress), metadata);
  const LitGltfOptions lit{.exposure = exposure_, .metadata = metadata};
  if (form_ == "vertex") {
    write_lit_gltf(path, scene_, radiosities_.solution, lit);
    return {path};
  }
  const bool emissive = form_ == "emissive";
  write_lightmapped_gltf(path, scene_, radiosities_.solution, lightmap(progress),
                         emissive ? LightmapForm::emissive : LightmapForm::lightmap, lit);
  std::vector<Path> files = {path};
  if (const Path map = beside(path, form_); !map.empty())
    for (Path& file : write_lightmap_pictures(map, lightmap(progress), metadata)) files.push_back(std::move(file));
  return files;
}

Path Baking::beside(const Path& model, std::string_view form) {
  return form == "lightmap" && lower_extension(model) != "exr" ? Path(model).replace_extension("exr") : Path();
}

const Lightmap& Baking::lightmap(Progress& progress) {
  if (!lightmap_) make_lightmap(progress);
  return *lightmap_;
}

void Baking::make_lightmap(Progress& progress) {
  Report& report = radiosities_.report;
  Stopwatch watch;
  try {
    progress.throw_if_cancelled();
    lightmap_ = aktina::make_lightmap(scene_, radiosities_.solution, options_, &progress);
  } catch (const Error& e) {
    if (e.code() != Code::cancelled) throw;
    options_.direct_samples = options_.gather_samples = 0;
    lightmap_ = aktina::make_lightmap(scene_, radiosities_.solution, options_);
    report.complete = false;
  }
  report.time("lightmap", watch.lap());
  report.warnings.add(lightmap_->layout.warnings);
  report.count("texel size", lightmap_->layout.texel_size, "m");
  report.count("texels", double(lightmap_->texels.size()));
  report.count("charts", double(lightmap_->layout.charts.size()));
  report.count("pages", double(lightmap_->layout.pages.size()));
  report.count("surfaces with coordinates of their own", double(lightmap_->layout.kept));
  report.count("seam difference before", lightmap_->seams.before);
  report.count("seam difference after", lightmap_->seams.after);
}

}  // namespace aktina
