// The program as a whole: from its start to its exit, and the memory it takes at most.
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "bench/report.h"
#include "tests/raster/scenes.h"

namespace {

using namespace aktina;

/// Runs the program without its words. @returns its largest memory, bytes
double run(const std::vector<std::string>& arguments) {
  std::vector<char*> argv = {const_cast<char*>(AKTINA_PROGRAM)};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  for (const int out : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&quiet, out, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failed = posix_spawn(&child, AKTINA_PROGRAM, &quiet, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&quiet);
  int status = 0;
  rusage use{};
  if (failed != 0 || wait4(child, &status, 0, &use) != child || status != 0)
    throw std::runtime_error(AKTINA_PROGRAM " does not run");
  return 1024.0 * double(use.ru_maxrss);
}

/// A PLY file of positions, normals and indices. @returns their bytes
double write_ply(const std::filesystem::path& path, const Mesh& mesh) {
  static_assert(std::endian::native == std::endian::little);
  std::ofstream file(path, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.positions.size();
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) file << "\nproperty float " << name;
  file << "\nelement face " << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  const auto write = [&](const auto& value) { file.write(reinterpret_cast<const char*>(&value), sizeof value); };
  for (size_t v = 0; v < mesh.positions.size(); ++v) write(mesh.positions[v]), write(mesh.normals[v]);
  for (const auto& triangle : mesh.triangles) file.put(3), write(triangle);
  return 12.0 * double(2 * mesh.positions.size() + mesh.triangles.size());
}

/// What a large scene takes beyond a small one, over its own data.
void memory(const std::string& large, const std::string& small, double data) {
  const auto peak = [&](const std::string& scene, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin() + 1, scene);
    return run(arguments);
  };
  const auto row = [&](const char* id, const char* what, const std::vector<std::string>& arguments) {
    const double beyond = peak(large, arguments) - peak(small, arguments);
    bench::report(fmt::format("program.{}.memory", id),
                  fmt::format("{}: memory that a million triangles take over their own data", what), beyond / data, "x",
                  bench::Goal{2, false});
  };
  const std::string picture = (std::filesystem::path(large).parent_path() / "picture.png").string();
  row("info", "aktina info", {"info"});
  for (const char* shading : {"phong", "gouraud"})
    row(shading, fmt::format("aktina render, {} shading, 64 x 64", shading).c_str(),
        {"render", "--method", "raster", "--shading", shading, "--size", "64x64", "-o", picture});
  row("whitted", "aktina render, ray traced, 64 x 64",
      {"render", "--method", "whitted", "--size", "64x64", "-o", picture});
}

}  // namespace

int main() {
  const std::string small = AKTINA_SOURCE_DIR "/scenes/cornell.glb";
  const double least = bench::race(20, {[&] { run({"info", small}); }})[0];
  bench::report("program.info.time", "aktina info of a small scene, from start to exit", 1e3 * least, "ms",
                bench::Goal{30, false});

  std::string folder = (std::filesystem::temp_directory_path() / "aktina-bench-XXXXXX").string();
  if (!mkdtemp(folder.data())) throw std::runtime_error("no temporary folder");
  const std::string large = folder + "/large.ply";
  const double data = write_ply(large, test::bumpy_sphere(700, 700));
  memory(large, small, data);
  std::filesystem::remove_all(folder);
}
