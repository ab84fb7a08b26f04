// Discontinuity meshing: faces are cut exactly along the shadow boundaries of the brightest lights, umbra and penumbra
// of polygons that shine, then into patches as the uniform mesher does it. Volumes of shadow are bounded by extremal
// planes through edges and corners of light and occluder; each face they fall on is cut by a binary space partition of
// its plane. Campbell and Fussell keep the volumes in one tree of space instead: there shadows within shadows vanish on
// the way, here what lies within another shadow is taken out face by face.
// Cost: faces squared for each light. Weakness: many small occluders; umbrae that several faces cast together are taken
// for penumbra.
//
// A. T. Campbell III, D. S. Fussell, "Adaptive Mesh Generation for Global Diffuse Illumination", SIGGRAPH 1990.
#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/radiosity/mesher/shadow_lines.h"
#include "aktina/radiosity/mesher/subdivision.h"

namespace aktina {
namespace {

constexpr double kMostPairs = 2e6;      // faces with faces, for one light
constexpr double kLinesPerPatch = 2;    // lights whose boundaries would make more are left out
constexpr double kShortest = 1.0 / 16;  // of a patch

void add_lamps(const Scene& scene, std::vector<ShadowLight>& lights) {
  for (const PlacedLight& placed : scene.lights) {
    Point3d at(0);
    double power = 0;
    if (const auto* point = std::get_if<PointLight>(&placed.light))
      at = Point3d(point->position), power = double(luminance(point->intensity.v)) * 4 * kPi;
    else if (const auto* spot = std::get_if<SpotLight>(&placed.light))
      at = Point3d(spot->position), power = double(luminance(spot->intensity.v)) * 4 * kPi;
    if (power > 0) lights.push_back({{at}, {}, ShadowLight::kNoFace, power});
  }
}

void add_emitters(const Scene& scene, const SceneFaces& faces, const std::vector<FlatFace>& flat,
                  std::vector<ShadowLight>& lights) {
  for (uint32_t i = 0; i < flat.size(); ++i) {
    const Material& material = scene.material_of(scene.instances[faces.instances[flat[i].instance]]);
    if (!material.emits()) continue;
    const auto& c = flat[i].corners;
    const double area = 0.5 * length(c.size() == 4 ? cross(c[2] - c[0], c[3] - c[1]) : cross(c[1] - c[0], c[2] - c[0]));
    lights.push_back({c, flat[i].normal, i, area * kPi * double(luminance(material.emission.v))});
  }
}

/// Brightest first.
std::vector<ShadowLight> lights_of(const Scene& scene, const SceneFaces& faces, const std::vector<FlatFace>& flat) {
  std::vector<ShadowLight> lights;
  add_lamps(scene, lights);
  add_emitters(scene, faces, flat, lights);
  std::stable_sort(lights.begin(), lights.end(), [](const auto& a, const auto& b) { return a.power > b.power; });
  return lights;
}

class DiscontinuityMesher final : public Mesher {
 public:
  explicit DiscontinuityMesher(size_t lights) : lights_(lights) {}

  PatchMesh mesh(const Scene& scene, const MeshOptions& options, Warnings& warnings) const override {
    SceneFaces faces(scene);
    const double area = faces.area();
    if (!(area > 0)) throw Error(Code::bad_input, scene.source, "no surface to compute light on");
    const double size = options.size(area);
    cut_at_shadows(scene, faces, size, size_t(kLinesPerPatch * area / (size * size)) + 1000, warnings);
    cut_at_contacts(faces, size, warnings);
    return subdivide(scene, faces, {size, options.coarse_size(area)}, options.most_patches, warnings);
  }

 private:
  void cut_at_shadows(const Scene& scene, SceneFaces& faces, double size, size_t most, Warnings& warnings) const {
    const std::vector<FlatFace> flat = flat_faces(faces);
    std::vector<ShadowLight> lights = lights_of(scene, faces, flat);
    lights.resize(std::min(lights.size(), lights_));
    const double tolerance = double(kJunctionTolerance * bounds(faces).diagonal());
    const bool few = double(flat.size()) * double(flat.size()) <= kMostPairs;
    std::vector<Contact> lines;
    uint64_t left_out = few ? 0 : lights.size();
    for (size_t i = 0; few && i < lights.size(); ++i) {
      const std::vector<Contact> more = shadow_lines(flat, lights[i], kShortest * size, tolerance);
      if (lines.size() + more.size() > most)
        ++left_out;
      else
        lines.insert(lines.end(), more.begin(), more.end());
    }
    if (left_out) warnings.add("lights whose shadow boundaries are left out of the mesh: there are too many", left_out);
    std::stable_sort(lines.begin(), lines.end(), [](const Contact& a, const Contact& b) { return a.face < b.face; });
    cut_along(faces, flat, lines);
  }

  size_t lights_;
};

constexpr Param kParams[] = {{"lights", "1", "whose shadows are meshed, the brightest first", 4, 1, 64, true}};

}  // namespace

extern constinit const Method<std::unique_ptr<Mesher>> discontinuity_mesher = {
    {"discontinuity", "Discontinuity meshing", "campbell1990",
     "Cut exactly where shadows, umbrae and penumbrae of the brightest lights end; for scenes of up to 1,400 faces.",
     kParams},
    [](const ParamSet& p) -> std::unique_ptr<Mesher> {
      return std::make_unique<DiscontinuityMesher>(size_t(p["lights"]));
    }};

}  // namespace aktina
