// How much of a scene is set up at a time.
//
// A triangle that is set up takes some 150 bytes, several times its part of the scene. Large scenes are therefore drawn
// in passes of a few chunks: each is set up, drawn into all bands and shaded before the next one takes its place. Bands
// of all rows are then in memory at once, and pixels that a later pass hides are shaded in vain; the picture is the
// same, since each pixel is shaded by itself and passes come in the order of the triangles.
#pragma once

#include "aktina/raster/raster_frame.h"

namespace aktina {

/// Chunks of a pass, of `chunks` in all: all of them where passes save less than bands of a whole picture take,
/// and where triangles are needed together: blended ones are sorted, spans end where others hide them.
uint32_t chunks_per_pass(uint32_t chunks, const Pipelines& pipelines, const View& view);

}  // namespace aktina
