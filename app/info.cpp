// aktina info: the pre-flight check of a file.
#include "aktina/render/info.h"

#include "scene_options.h"

namespace aktina::app {
namespace {

int run(const Arguments& arguments, Session& session) {
  const FileInfo found = file_info(arguments.text("file"), {.metres_per_unit = arguments.number("units")});
  session.show_warnings(found.warnings);
  Report report;
  report.warnings = found.warnings;
  return session.finish(report, found.text, found.json);
}

constexpr Option kInputs[] = {
    {.name = "file",
     .help = "a scene, an image (PNG, JPEG, WebP, HDR, EXR, PFM) or a luminaire (IES, EULUMDAT)",
     .kind = Kind::file,
     .value = "FILE",
     .required = true},
};
constexpr Option kOptions[] = {kUnits};
constexpr Example kExamples[] = {
    {"is this model ready to be lit?", "aktina info room.glb"},
    {"what a luminaire emits", "aktina info downlight.ies"},
    {"for a program to read", "aktina info room.glb --json"},
};

}  // namespace

extern constinit const Command info_command = {
    "info",
    "check a file before work: what it holds, what is odd, what each job will take",
    "Takes any file that Aktina reads. Of a scene: counts, size and suspicious units, lights with their luminous flux, "
    "open or faulty geometry, unused materials, memory and time foreseen for each job. Of a luminaire: flux, "
    "intensity, "
    "beam and field angle. What was repaired while reading is said as warnings.",
    kInputs,
    kOptions,
    false,
    kExamples,
    run};

}  // namespace aktina::app
