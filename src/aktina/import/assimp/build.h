// Document -> Scene. What it says is clamped and repaired as other readers do it: its writer is not trusted.
#pragma once

#include "aktina/import/assimp/document.h"
#include "aktina/import/beside.h"

namespace aktina::assimp {

/// Everything but default camera and light; pictures are looked for by `beside`.
void build(Document document, Beside& beside, const ImportOptions& options, Scene& scene);

/// The parts of it. @param units  metres in one of the file's units
void build_materials(const Document& document, Beside& beside, Scene& scene);
void build_meshes(Document& document, const ImportOptions& options, Scene& scene);
void build_lights(const Document& document, double units, Scene& scene);
void build_cameras(const Document& document, double units, Scene& scene);

}  // namespace aktina::assimp
