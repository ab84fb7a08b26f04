#include "aktina/radiosity/viewfactor/scene_surfaces.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "aktina/base/error.h"
#include "aktina/radiosity/formfactor/face.h"
#include "aktina/radiosity/viewfactor/outline.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

constexpr double kParallelogram = 1e-4;  // relative: triangles of no stated polygon join to parallelograms only

std::string object_name(const Scene& scene, size_t index) {
  const Instance& instance = scene.instances[index];
  for (int node = instance.node; node >= 0; node = scene.nodes[size_t(node)].parent)
    if (!scene.nodes[size_t(node)].name.empty()) return scene.nodes[size_t(node)].name;
  const std::string& mesh = scene.meshes[size_t(instance.mesh)].name;
  return mesh.empty() ? fmt::format("object {}", index) : mesh;
}

/// Adds the polygons of one instance after another.
class Collector {
 public:
  Collector(const Scene& scene, SurfacesBy by, Backs backs, Clear clear)
      : scene_(scene), by_(by), backs_(backs), clear_(clear) {}

  ViewFactorScene run() {
    for (size_t i = 0; i < scene_.instances.size(); ++i)
      if (scene_.instances[i].mesh >= 0) add_instance(i);
    for (size_t i = 0; i < numbers_.size(); ++i)  // an object of one polygon gives it its name
      result_.names[i] += (faces_of_[numbers_[i].object] > 1 ? fmt::format(":{}", numbers_[i].number) : "") +
                          (numbers_[i].back ? "/back" : "");
    if (std::all_of(result_.transmittances.begin(), result_.transmittances.end(), [](double t) { return t == 0; }))
      result_.transmittances.clear();
    result_.warnings.add("polygons without area were left out", empty_);
    result_.warnings.add("polygons where there is one already were left out", doubled_);
    result_.warnings.add("polygons that are not planar or have holes were taken as several triangles", cut_);
    if (result_.pieces.empty()) throw Error(Code::bad_input, scene_.source, "has no surface with an area");
    return std::move(result_);
  }

 private:
  using Triangle = std::array<uint32_t, 3>;
  struct Number {
    int64_t object;
    size_t number;
    bool back;
  };

  void add_instance(size_t index) {
    const Instance& instance = scene_.instances[index];
    const Mesh& mesh = scene_.meshes[size_t(instance.mesh)];
    const Mat4d to_world(instance.to_world);
    points_.clear();
    for (const Point3& p : mesh.positions) points_.emplace_back(to_world * glm::dvec4(Vec3d(p), 1));
    const bool mirrored = glm::determinant(to_world) < 0;
    const int64_t object = instance.node >= 0 ? instance.node : -2 - int64_t(index);
    const std::string name = object_name(scene_, index);
    transmittance_ = clear_ == Clear::pass ? transmittance(scene_.material_of(instance)) : 0;
    const bool both_sides = backs_ == Backs::see && scene_.material_of(instance).double_sided;
    std::vector<std::vector<Triangle>> faces = faces_of(mesh, mirrored);
    for (const std::vector<Triangle>& face : faces) {
      pieces_.clear();
      cut(face);
      const size_t number = faces_of_[object]++;
      if (pieces_.empty() || is_there_already()) continue;
      add_pieces(surface(instance, mesh, object, name, {object, number, false}));
      if (!both_sides) continue;
      for (Polygon& piece : pieces_) std::reverse(piece.vertices.begin(), piece.vertices.end());
      add_pieces(surface(instance, mesh, object, name, {object, number, true}));
    }
  }

  /// A polygon with the same corners in the same order, wherever it begins: light would arrive at both.
  bool is_there_already() {
    std::vector<std::array<double, 3>> key;
    for (const Polygon& piece : pieces_) {
      const std::vector<Point3d>& v = piece.vertices;
      const auto less = [](Point3d a, Point3d b) { return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z}; };
      const auto begin = size_t(std::min_element(v.begin(), v.end(), less) - v.begin());
      for (size_t k = 0; k < v.size(); ++k) {
        const Point3d& p = v[(begin + k) % v.size()];
        key.push_back({p.x, p.y, p.z});
      }
    }
    const bool known = !there_.insert(std::move(key)).second;
    doubled_ += known;
    return known;
  }

  void add_pieces(uint32_t owner) {
    result_.pieces.insert(result_.pieces.end(), pieces_.begin(), pieces_.end());
    result_.owners.resize(result_.pieces.size(), owner);
    result_.transmittances.resize(result_.pieces.size(), transmittance_);
  }

  double transmittance(const Material& material) const {
    const Vec2 uv[2] = {Vec2(0), Vec2(0)};
    Material plain = material;
    plain.base_texture = plain.transmission_texture = {};
    const MaterialPoint point = evaluate(scene_, plain, uv, Vec4(1));
    const double passing = double(luminance(point.surface.kt * point.alpha + Rgb(1 - point.alpha)));
    return std::clamp(passing, 0.0, 1.0);
  }

  /// The triangles of each polygon, in the file's order.
  std::vector<std::vector<Triangle>> faces_of(const Mesh& mesh, bool mirrored) const {
    std::vector<std::vector<Triangle>> faces(mesh.triangle_face.empty() ? 0 : mesh.face_count);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      Triangle corners = mesh.triangles[t];
      if (mirrored) std::swap(corners[1], corners[2]);
      if (!mesh.triangle_face.empty())
        faces[mesh.triangle_face[t]].push_back(corners);
      else if (!faces.empty() && faces.back().size() == 1 && parallelogram(faces.back()[0], corners))
        faces.back().push_back(corners);
      else
        faces.push_back({corners});
    }
    return faces;
  }

  bool parallelogram(const Triangle& a, const Triangle& b) const {
    for (size_t i = 0; i < 3; ++i)
      for (size_t k = 0; k < 3; ++k) {
        const Point3d &a0 = points_[a[i]], &a1 = points_[a[(i + 1) % 3]], &apex = points_[a[(i + 2) % 3]];
        const Point3d &b0 = points_[b[k]], &b1 = points_[b[(k + 1) % 3]], &other = points_[b[(k + 2) % 3]];
        if (a0 != b1 || a1 != b0) continue;
        return length(apex + other - a0 - a1) <= kParallelogram * length(apex - other);
      }
    return false;
  }

  bool add_piece(Polygon polygon) {
    try {
      make_face(polygon, "");
    } catch (const Error&) {
      return false;
    }
    pieces_.push_back(std::move(polygon));
    return true;
  }

  void cut(const std::vector<Triangle>& face) {
    if (face.empty()) return;
    Polygon whole;
    if (face.size() == 1)
      for (const uint32_t v : face[0]) whole.vertices.push_back(points_[v]);
    else
      whole.vertices = outline(face);
    if (!whole.vertices.empty() && add_piece(std::move(whole))) return;
    for (const Triangle& t : face)
      if (face.size() > 1) add_piece({{points_[t[0]], points_[t[1]], points_[t[2]]}});
    ++(pieces_.empty() ? empty_ : cut_);
  }

  /// By position: the two triangles of a parallelogram need not share vertices.
  std::vector<Point3d> outline(std::vector<Triangle> face) const {
    std::map<std::array<double, 3>, uint32_t> known;
    for (Triangle& t : face)
      for (uint32_t& v : t) v = known.try_emplace({points_[v].x, points_[v].y, points_[v].z}, v).first->second;
    std::vector<Point3d> corners;
    for (const uint32_t v : outline_of(face)) corners.push_back(points_[v]);
    return corners;
  }

  uint32_t surface(const Instance& instance, const Mesh& mesh, int64_t object, const std::string& name, Number number) {
    if (by_ == SurfacesBy::face) {
      numbers_.push_back(number);
      return add_surface(name);
    }
    if (by_ == SurfacesBy::object) return known(object, name);
    const int material = instance.material >= 0 ? instance.material : mesh.material;
    const std::string& given = material >= 0 ? scene_.materials[size_t(material)].name : "";
    return known(material, !given.empty() ? given
                           : material < 0 ? "no material"
                                          : fmt::format("material {}", material));
  }

  uint32_t known(int64_t key, const std::string& name) {
    const auto [at, fresh] = groups_.try_emplace(key, 0);
    if (fresh) at->second = add_surface(name);
    return at->second;
  }

  uint32_t add_surface(std::string name) {
    result_.names.push_back(std::move(name));
    return uint32_t(result_.names.size() - 1);
  }

  const Scene& scene_;
  SurfacesBy by_;
  Backs backs_;
  Clear clear_;
  double transmittance_ = 0;  // of the instance at work
  ViewFactorScene result_;
  std::vector<Point3d> points_;
  std::vector<Polygon> pieces_;
  std::map<int64_t, uint32_t> groups_;
  std::map<int64_t, size_t> faces_of_;  // of each object
  std::vector<Number> numbers_;         // of each surface, by face
  std::set<std::vector<std::array<double, 3>>> there_;
  uint64_t empty_ = 0, cut_ = 0, doubled_ = 0;
};

}  // namespace

ViewFactorScene surfaces_of(const Scene& scene, SurfacesBy by, Backs backs, Clear clear) {
  const TessellatedScene tessellated(scene);
  return Collector(*tessellated, by, backs, clear).run();
}

}  // namespace aktina
