// Studies of a scene: the methods of a family compared.
#include "aktina/render/study/study.h"

#include "aktina/render/study/output.h"
#include "fields.h"
#include "rooms.h"
#include "work.h"

namespace aktina::python {
namespace {

StudyOptions study_options(const py::dict& fields) {
  StudyOptions o;
  FromDict field(fields, "study");
  field("family", o.family), field("methods", o.methods), field("reference", o.reference);
  field("illumination", o.illumination), field("width", o.width), field("height", o.height);
  field("samples", o.samples), field("camera", o.camera), field("rounds", o.rounds), field("growth", o.growth);
  field.expect_all_read();
  return o;
}

/// report.json as text; with a folder that is not empty, the three files too.
std::string study_scene(const Scene& scene, const py::dict& fields, uint32_t seed, const std::string& folder,
                        const py::object& report) {
  StudyOptions options = study_options(fields);
  options.seed = seed;
  if (!folder.empty()) check_study_folder(folder);
  return run(report, [&](Progress& progress) {
    const Study result = study(scene, options, progress);
    progress.throw_if_cancelled();
    if (!folder.empty()) write_study(folder, {&result, 1});
    return study_json({&result, 1});
  });
}

}  // namespace

void bind_study(py::module_& m) { m.def("study", &study_scene); }

}  // namespace aktina::python
