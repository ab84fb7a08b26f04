// Where the headers of EGL and libepoxy were missing at build time.
#include "bench/llvmpipe.h"

namespace aktina::bench {

struct Llvmpipe::Context {};

Llvmpipe::Llvmpipe(const Scene&, int, int)
    : missing_("built without EGL and libepoxy (Debian: libepoxy-dev, libegl-dev)") {}
Llvmpipe::~Llvmpipe() = default;
void Llvmpipe::draw(bool) {}
std::vector<float> Llvmpipe::read() const { return {}; }

struct LlvmpipeItems::Context {};
LlvmpipeItems::LlvmpipeItems(const Mesh&, int, int)
    : missing_("built without EGL and libepoxy (Debian: libepoxy-dev, libegl-dev)") {}
LlvmpipeItems::~LlvmpipeItems() = default;
void LlvmpipeItems::draw(const Camera&, int, std::vector<uint32_t>&) {}

}  // namespace aktina::bench
