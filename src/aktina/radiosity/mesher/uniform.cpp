// Uniform subdivision: every edge is cut into equal pieces no longer than the patch size, whatever face it belongs to,
// so that neighbours agree without being asked; vertices that lie on an edge (T-junctions, of other meshes too) cut it
// first. Quadrilaterals stay grids where their edges allow it, else become triangles, halved across their longest edge.
// Cost: linear in the patches. Weakness: as fine in the middle of a wall as at the edge of a shadow.
//
// M. Cohen, D. Greenberg, "The Hemi-Cube: A Radiosity Solution for Complex Environments", SIGGRAPH 1985; bisection:
// M. C. Rivara, "Algorithms for Refining Triangular Grids Suitable for Adaptive and Multigrid Techniques", Int. J.
// Numerical Methods in Engineering 20(4), 1984.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "aktina/base/error.h"
#include "aktina/radiosity/mesher/junctions.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/mesher/patch_builder.h"

namespace aktina {
namespace {

constexpr double kSlack = 1 - 1e-5;              // edges that are equal but for rounding get equally many pieces
constexpr Vec3 kOdd{0.8215f, 0.4321f, 0.3717f};  // no edge of a drawn scene is square to it but by design

using Corners = PatchBuilder::Corners;

uint64_t key(uint32_t a, uint32_t b) { return (uint64_t(std::min(a, b)) << 32) | std::max(a, b); }

/// Cuts the faces of one instance after another into a mesh.
class Subdivision {
 public:
  Subdivision(PatchMesh& mesh, PatchBuilder& builder, double size, double shooter_size, const Junctions& junctions)
      : mesh_(mesh), builder_(builder), size_(size), shooter_size_(shooter_size / kSlack), junctions_(junctions) {}

  void add(uint32_t instance, const SourceFaces& faces) {
    builder_.begin(instance, faces);
    faces_ = &faces;
    middles_.clear(), on_edge_.clear();
    ids_.assign(faces.positions.size(), kNone);
    for (const SourceFace& face : faces.list) add(face);
  }

 private:
  static constexpr uint32_t kNone = 0xffffffff;

  void add(const SourceFace& face) {
    face_ = &face;
    Corners corners;
    for (size_t k = 0; k < 4; ++k) {
      uint32_t& id = ids_[face.corners[k]];
      if (id == kNone) id = add_vertex(faces_->positions[face.corners[k]]);
      corners[k] = id;
    }
    const size_t n = face.is_quad() ? 4 : 3;
    for (size_t k = 0; k < n; ++k) note_junctions(corners[k], corners[(k + 1) % n]);
    in_shooter_ = false;
    cut(corners);
  }

  uint32_t add_vertex(Point3 p) { return builder_.add_vertex(*face_, p); }

  void note_junctions(uint32_t a, uint32_t b) {
    if (on_edge_.count(key(a, b))) return;
    if (a > b) std::swap(a, b);
    junctions_.on_edge(mesh_.positions[a], mesh_.positions[b], found_);
    if (!found_.empty()) on_edge_[key(a, b)] = found_;
  }

  const std::vector<Point3>* junctions(uint32_t a, uint32_t b) const {
    const auto at = on_edge_.find(key(a, b));
    return at == on_edge_.end() ? nullptr : &at->second;
  }

  double edge_length(uint32_t a, uint32_t b) const {
    return length(Vec3d(mesh_.positions[a]) - Vec3d(mesh_.positions[b]));
  }
  /// Equal pieces of an edge: a function of its ends alone. Pieces of pieces come out the same.
  int pieces(uint32_t a, uint32_t b, double size) const {
    return int(std::max(1.0, std::ceil(edge_length(a, b) / size * kSlack)));
  }
  bool to_be_cut(uint32_t a, uint32_t b) const { return junctions(a, b) || pieces(a, b, size_) > 1; }

  /// The vertex where an edge is cut: its middle junction, else the end of its middle piece.
  uint32_t middle(uint32_t a, uint32_t b) {
    if (const auto at = middles_.find(key(a, b)); at != middles_.end()) return at->second;
    const std::vector<Point3>* on = junctions(a, b);
    const uint32_t vertex = on ? cut_at_junction(a, b, *on) : add_vertex(end_of_middle_piece(a, b));
    return middles_[key(a, b)] = vertex;
  }

  Point3 end_of_middle_piece(uint32_t a, uint32_t b) const {
    Vec3d p(mesh_.positions[a]), q(mesh_.positions[b]);
    const Vec3 along = mesh_.positions[b] - mesh_.positions[a];
    const float side = dot(along, kOdd);
    if (side != 0 ? side < 0 : along.x < 0) std::swap(p, q);  // parallel edges count from the same end
    const int n = pieces(a, b, size_);
    return Point3(p + (q - p) * (double(n / 2) / n));
  }

  uint32_t cut_at_junction(uint32_t a, uint32_t b, std::vector<Point3> on) {
    if (a > b) std::swap(a, b);
    const size_t half = on.size() / 2;
    const uint32_t vertex = add_vertex(on[half]);
    const auto keep = [&](uint32_t from, uint32_t to, std::vector<Point3> part) {
      if (part.empty()) return;
      if (from > to) std::reverse(part.begin(), part.end());
      on_edge_[key(from, to)] = std::move(part);
    };
    keep(a, vertex, {on.begin(), on.begin() + std::ptrdiff_t(half)});
    keep(vertex, b, {on.begin() + std::ptrdiff_t(half) + 1, on.end()});
    return vertex;
  }

  void cut(const Corners& c) {
    const bool opens = !in_shooter_ && small_enough_to_shoot(c);
    if (opens) open_shooter(c);
    if (c[2] == c[3])
      cut_triangle(c[0], c[1], c[2]);
    else
      cut_quad(c);
    if (opens) in_shooter_ = false;
  }

  bool small_enough_to_shoot(const Corners& c) const {
    for (size_t k = 0; k < 4; ++k)
      if (edge_length(c[k], c[(k + 1) % 4]) > shooter_size_ * (1 + 1e-6)) return false;
    return true;
  }
  void open_shooter(const Corners& c) {
    in_shooter_ = true;
    mesh_.shooters.push_back({uint32_t(mesh_.size()), 0, c});
  }

  void cut_triangle(uint32_t a, uint32_t b, uint32_t c) {
    const std::array<uint32_t, 3> v = {a, b, c};
    size_t longest = 3;
    for (size_t k = 0; k < 3; ++k) {
      if (!to_be_cut(v[k], v[(k + 1) % 3])) continue;
      if (longest == 3 ||
          edge_length(v[k], v[(k + 1) % 3]) > edge_length(v[longest], v[(longest + 1) % 3]) * (1 + 1e-6))
        longest = k;
    }
    if (longest == 3) return add_patch({a, b, c, c});
    const uint32_t from = v[longest], to = v[(longest + 1) % 3], apex = v[(longest + 2) % 3];
    const uint32_t m = middle(from, to);
    cut({from, m, apex, apex});
    cut({m, to, apex, apex});
  }

  void cut_quad(const Corners& c) {
    const bool junction =
        junctions(c[0], c[1]) || junctions(c[1], c[2]) || junctions(c[2], c[3]) || junctions(c[3], c[0]);
    const bool first = to_be_cut(c[0], c[1]) && to_be_cut(c[2], c[3]);
    const bool second = to_be_cut(c[1], c[2]) && to_be_cut(c[3], c[0]);
    const bool any =
        junction || to_be_cut(c[0], c[1]) || to_be_cut(c[1], c[2]) || to_be_cut(c[2], c[3]) || to_be_cut(c[3], c[0]);
    if (!any) return add_patch(c);
    if (junction || !(first || second)) return cut_diagonally(c);
    const double across = edge_length(c[0], c[1]) + edge_length(c[2], c[3]);
    const double along = edge_length(c[1], c[2]) + edge_length(c[3], c[0]);
    if (first && (!second || across >= along)) {
      const uint32_t m = middle(c[0], c[1]), n = middle(c[2], c[3]);
      cut({c[0], m, n, c[3]});
      cut({m, c[1], c[2], n});
    } else {
      const uint32_t m = middle(c[1], c[2]), n = middle(c[3], c[0]);
      cut({c[0], c[1], m, n});
      cut({n, m, c[2], c[3]});
    }
  }
  void cut_diagonally(const Corners& c) {
    if (edge_length(c[0], c[2]) <= edge_length(c[1], c[3])) {
      cut({c[0], c[1], c[2], c[2]});
      cut({c[0], c[2], c[3], c[3]});
    } else {
      cut({c[1], c[2], c[3], c[3]});
      cut({c[1], c[3], c[0], c[0]});
    }
  }

  void add_patch(const Corners& c) {
    builder_.add_patch(*face_, c);
    ++mesh_.shooters.back().count;
  }

  PatchMesh& mesh_;
  PatchBuilder& builder_;
  double size_, shooter_size_;
  const Junctions& junctions_;
  const SourceFaces* faces_ = nullptr;
  const SourceFace* face_ = nullptr;
  bool in_shooter_ = false;
  std::vector<uint32_t> ids_;  // vertex of the mesh for each of the faces' corners
  std::unordered_map<uint64_t, uint32_t> middles_;
  std::unordered_map<uint64_t, std::vector<Point3>> on_edge_;  // from the lower vertex to the higher one
  std::vector<Point3> found_;
};

class UniformMesher final : public Mesher {
 public:
  explicit UniformMesher(double shooter) : shooter_(shooter) {}

  PatchMesh mesh(const Scene& scene, const MeshOptions& options, Warnings& warnings) const override {
    const SceneFaces faces(scene);
    const double total = faces.area();
    if (!(total > 0)) throw Error(Code::bad_input, scene.source, "no surface to compute light on");
    const double size = options.size(total), shooter = shooter_ > 0 ? shooter_ * size : options.coarse_size(total);
    check_count(faces, total, size, options.most_patches);

    PatchMesh mesh;
    PatchBuilder builder(mesh, scene, options.most_patches);
    const Junctions junctions(faces.points());
    Subdivision subdivision(mesh, builder, size, shooter, junctions);
    for (size_t i = 0; i < faces.faces.size(); ++i) subdivision.add(faces.instances[i], faces.faces[i]);
    warn_of_repairs(faces, builder, warnings);
    return mesh;
  }

 private:
  /// A patch is at most a square of the patch size, and every face is at least one.
  static void check_count(const SceneFaces& faces, double total, double size, uint64_t most) {
    double least = 0;
    for (const SourceFaces& each : faces.faces) least += double(each.list.size());
    least = std::max(least, total / (size * size));
    if (least > double(most))
      throw Error(Code::limit, "most_patches",
                  fmt::format("the scene needs {:.0f} patches or more, {} are allowed", least, most),
                  fmt::format("a patch size above {:.3g} m, or a higher limit", std::sqrt(total / double(most))));
  }

  double shooter_;
};

constexpr Param kParams[] = {{"shooter", "1",
                              "longest edge of what shoots light as one, in patch sizes; 0: as indirect light needs it",
                              0, 0, 64}};

}  // namespace

extern constinit const Method<std::unique_ptr<Mesher>> uniform_mesher = {
    {"uniform", "Uniform subdivision", "cohen1985",
     "Patches of one size; neighbours share their edges; simple, finer than needed where nothing happens.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<Mesher> { return std::make_unique<UniformMesher>(p["shooter"]); }};

}  // namespace aktina
