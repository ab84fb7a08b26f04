#include "aktina/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif
#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>

namespace aktina {
namespace {

std::mutex arena_mutex;
std::unique_ptr<tbb::global_control> allowed;  // else TBB complains where more threads than cores are asked for
std::shared_ptr<tbb::task_arena> arena;
std::atomic<int> threads{0};

std::shared_ptr<tbb::task_arena> current_arena() {
  const std::lock_guard lock(arena_mutex);
  if (!arena) {
    const int count = std::max(thread_count(), tbb::info::default_concurrency());
    allowed = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, size_t(count));
    arena = std::make_shared<tbb::task_arena>(thread_count());
  }
  return arena;
}

/// Tells ThreadSanitizer what it cannot see, since Debian's TBB is not instrumented: that the loop's bodies come after
/// its beginning and before its end, also where they throw. Races between bodies are still found.
class Handover {
 public:
#if defined(__SANITIZE_THREAD__)
  Handover() { __tsan_release(&begun_); }
  ~Handover() { __tsan_acquire(&done_); }
  void body_begins() { __tsan_acquire(&begun_); }
  void body_ends() { __tsan_release(&done_); }

 private:
  char begun_ = 0, done_ = 0;
#else
  void body_begins() {}
  void body_ends() {}
#endif
};

struct Loop {
  FunctionRef<void(size_t, size_t)> body;
  Handover handover{};

  void run(size_t begin, size_t end) {
    const FlushDenormals flush;
    struct Body {
      Handover& handover;
      explicit Body(Handover& h) : handover(h) { handover.body_begins(); }
      ~Body() { handover.body_ends(); }
    } const within(handover);
    body(begin, end);
  }
};

/// What TBB copies into its tasks. ThreadSanitizer does not see them handed over, nor that they are read here.
struct LoopPart {
  Loop* loop;
  [[gnu::no_sanitize("thread")]] void operator()(const tbb::blocked_range<size_t>& range) const {
    loop->run(range.begin(), range.end());
  }
};

}  // namespace

void set_thread_count(int count) {
  const std::lock_guard lock(arena_mutex);
  threads = count < 0 ? 0 : count;
  arena.reset();
}

int thread_count() { return threads > 0 ? threads.load() : tbb::info::default_concurrency(); }

void parallel_for(size_t n, size_t grain, FunctionRef<void(size_t, size_t)> body) {
  if (n == 0) return;
  if (grain == 0) grain = 1;
  if (thread_count() == 1 || n <= grain) {
    const FlushDenormals flush;
    body(0, n);
    return;
  }
  Loop loop{body};
  current_arena()->execute(
      [&] { tbb::parallel_for(tbb::blocked_range<size_t>(0, n, grain), LoopPart{&loop}, tbb::simple_partitioner()); });
}

void within_thread_limit(FunctionRef<void()> work) {
  current_arena()->execute([&] { work(); });
}

#if defined(__SSE__)
constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
FlushDenormals::FlushDenormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | kFlushToZero | kDenormalsAreZero); }
FlushDenormals::~FlushDenormals() { _mm_setcsr(saved_); }
#else
FlushDenormals::FlushDenormals() : saved_(0) {}
FlushDenormals::~FlushDenormals() = default;
#endif

}  // namespace aktina
