// Radiosity: how many shots a second, what a second thread is worth, and what a furnished room takes.
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
  return 0;
}
