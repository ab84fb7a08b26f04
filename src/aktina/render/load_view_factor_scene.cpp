#include <fmt/core.h>

#include <algorithm>
#include <unordered_map>

#include "aktina/base/error.h"
#include "aktina/import/import.h"
#include "aktina/import/text.h"
#include "aktina/import/vs3/vs3.h"
#include "aktina/radiosity/formfactor/face.h"
#include "aktina/render/view_factor_job.h"

namespace aktina {
namespace {

/// Convex pieces of a convex polygon without what lies in a convex hole.
std::vector<Contour> without(const std::vector<Contour>& pieces, const Face& hole) {
  std::vector<Contour> left;
  const double margin = 1e3 * rounding(hole);
  for (const Contour& piece : pieces) {
    Contour rest = piece;
    const size_t n = hole.vertices.size();
    for (size_t k = 0; k < n && !rest.empty(); ++k) {
      const Vec3d edge = hole.vertices[(k + 1) % n] - hole.vertices[k];
      const Plane side{hole.vertices[k], normalize(cross(hole.plane.normal, edge))};  // inside is in front
      if (Contour out = clip(rest, {side.point, -side.normal}, margin); !out.empty()) left.push_back(std::move(out));
      rest = clip(rest, side, margin);
    }
  }
  return left;
}

class Vs3Surfaces {
 public:
  Vs3Surfaces(const Vs3& file, const std::string& where) : file_(file), where_(where) {
    for (size_t i = 0; i < file.surfaces.size(); ++i) index_[file.surfaces[i].number] = i;
  }

  ViewFactorScene run() {
    result_.warnings = file_.warnings;
    for (size_t i = 0; i < file_.surfaces.size(); ++i) add(i);
    if (result_.pieces.empty()) throw Error(Code::bad_input, where_, "has obstructions only");
    return std::move(result_);
  }

 private:
  Face face(const Vs3::Surface& s) const {
    return make_face({s.corners}, fmt::format("{}: surface {}", where_, s.number));
  }

  void add(size_t i) {
    const Vs3::Surface& s = file_.surfaces[i];
    if (s.kind == Vs3::Kind::null) return;
    const Face whole = face(s);
    if (whole.convex.size() > 1)
      throw Error(Code::bad_input, fmt::format("{}: surface {}", where_, s.number), "is not convex", "cut it in two");
    if (s.kind == Vs3::Kind::obstruction) {
      result_.occluders.push_back({s.corners});
      return;
    }
    std::vector<Contour> pieces{whole.vertices};
    for (const Vs3::Surface& part : file_.surfaces)
      if (part.base == s.number) pieces = without(pieces, face(part));
    const uint32_t owner = owner_of(s);
    for (Contour& piece : pieces) result_.pieces.push_back({std::move(piece)}), result_.owners.push_back(owner);
  }

  /// Combined surfaces count with the one that they name, or the one that that names.
  uint32_t owner_of(const Vs3::Surface& s) {
    const Vs3::Surface* to = &s;
    for (size_t steps = 0; to->combine != 0; ++steps) {
      if (steps > file_.surfaces.size())
        throw Error(Code::bad_input, where_, fmt::format("surface {} is combined in a circle", s.number));
      to = &file_.surfaces[index_.at(to->combine)];
    }
    const auto [at, fresh] = owners_.try_emplace(to->number, uint32_t(result_.names.size()));
    if (fresh) result_.names.push_back(to->name), result_.emissivities.push_back(to->emissivity);
    return at->second;
  }

  const Vs3& file_;
  const std::string& where_;
  std::unordered_map<int64_t, size_t> index_;
  std::unordered_map<int64_t, uint32_t> owners_;
  ViewFactorScene result_;
};

}  // namespace

ViewFactorScene load_view_factor_scene(const Path& path, SurfacesBy by, Backs backs, Clear clear,
                                       double metres_per_unit) {
  if (lower_extension(path) == "vs3") {
    const std::string where = display(path);
    Vs3 file = read_vs3(decode_text(read_file(path)), where);
    if (metres_per_unit > 0)
      for (Vs3::Surface& s : file.surfaces)
        for (Point3d& p : s.corners) p *= metres_per_unit;
    ViewFactorScene scene = Vs3Surfaces(file, where).run();
    scene.source = display(path.filename());
    return scene;
  }
  const Scene scene =
      load_scene(path, {.metres_per_unit = metres_per_unit, .default_camera = false, .default_light = false});
  ViewFactorScene surfaces = surfaces_of(scene, by, backs, clear);
  surfaces.source = display(path.filename());
  return surfaces;
}

}  // namespace aktina
