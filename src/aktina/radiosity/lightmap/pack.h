// Rectangles -> pages, without overlap.
#pragma once

#include <span>

namespace aktina {

struct PackedBox {
  int width = 0, height = 0;    // texels
  int page = -1, x = 0, y = 0;  // filled by pack()
};

/// Places boxes on square pages, the highest first, each as low as it goes (the skyline method). Cost: boxes times what
/// fits side by side. @return pages in use; 0: `most_pages` are not enough. No box may be larger than a page.
/// J. Jylanki, "A Thousand Ways to Pack the Bin: a Practical Approach to Two-Dimensional Rectangle Bin Packing", 2010.
int pack(std::span<PackedBox> boxes, int page_size, int most_pages);

}  // namespace aktina
