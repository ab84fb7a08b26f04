// Radiosity: how many shots a second, what a second thread is worth, and what a furnished room takes.
#include <cmath>
#include <string>

#include "aktina/base/parallel.h"
#include "aktina/import/import.h"
#include "aktina/radiosity/solve.h"
#include "bench/report.h"

namespace {

using namespace aktina;

/// Shots a second are measured as the difference of two runs, so that meshing and tracing structures do not count.
double seconds_of(const Scene& scene, int threads, uint64_t steps) {
  set_thread_count(threads);
  RadiosityOptions options;
  options.solver = "progressive", options.indirect_size = 0, options.most_steps = steps;
  return bench::seconds([&] { solve_radiosity(scene, options); });
}

/// The Cornell box in so many patches; its slope of time against their number.
double default_solve(const Scene& scene, double patches) {
  RadiosityOptions options;
  options.patch_size = std::sqrt(2.0 / patches);  // m; it has 2 m^2
  return bench::seconds([&] { solve_radiosity(scene, options); });
}

}  // namespace

int main() {
  const Scene cornell = load_scene(std::string(AKTINA_SOURCE_DIR) + "/scenes/cornell.glb");
  const Scene room = load_scene(std::string(AKTINA_SOURCE_DIR) + "/scenes/room.glb");
  constexpr uint64_t kFew = 10, kMany = 810;
  double one = 1e30, two = 1e30;
  for (int round = 0; round < 3; ++round) {  // in turn, the least of each
    one = std::min(one, seconds_of(cornell, 1, kMany) - seconds_of(cornell, 1, kFew));
    two = std::min(two, seconds_of(cornell, 2, kMany) - seconds_of(cornell, 2, kFew));
  }
  set_thread_count(0);
  bench::report("radiosity.shots", "shots by rays to 12,000 patches, Cornell box, one thread", (kMany - kFew) / one,
                "1/s");
  bench::report("radiosity.threads", "shots by rays on two threads against one", one / two, "x", bench::Goal{1.85});
  bench::report("radiosity.room", "room.glb, default quality, all threads",
                bench::seconds([&] { solve_radiosity(room, {}); }), "s");
  set_thread_count(1);
  const double few = default_solve(cornell, 1e4), many = default_solve(cornell, 1e6);
  set_thread_count(0);
  bench::report("radiosity.default", "default solve of the Cornell box, 10,000 patches, one thread", few, "s",
                bench::Goal{1.5, false});
  bench::report("radiosity.million", "default solve of the Cornell box, 10^6 patches, one thread", many, "s",
                bench::Goal{5, false});
  bench::report("radiosity.slope", "log time over log patches, 10^4 to 10^6", std::log(many / few) / std::log(100.0),
                "1", bench::Goal{1.15, false});
  return 0;
}
