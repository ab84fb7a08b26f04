#include "aktina/radiosity/mesher/subdivision.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"

namespace aktina {
namespace {

constexpr double kSlack = 1 - 1e-5;   // edges that are equal but for rounding get equally many pieces
constexpr double kMatch = 1e-4;       // of a side: vertices of opposite sides that make a grid
constexpr double kLittleSkew = 0.25;  // of a patch: cuts that are taken first
constexpr double kMostSkew = 0.75;    // of a patch: cuts that are taken at all

constexpr uint32_t kNone = 0xffffffff;

uint64_t key(uint32_t a, uint32_t b) { return (uint64_t(std::min(a, b)) << 32) | std::max(a, b); }

/// The same from both sides of an edge, and for edges of other instances between the same places.
bool in_order(Point3 a, Point3 b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

/// A patch is at most a square of the patch size, and every face is at least one.
void check_count(const SceneFaces& faces, double total, double size, uint64_t most) {
  double least = 0;
  for (const SourceFaces& each : faces.faces) least += double(each.list.size());
  least = std::max(least, total / (size * size));
  if (least > double(most))
    throw Error(Code::limit, "most_patches",
                fmt::format("the scene needs {:.0f} patches or more, {} are allowed", least, most),
                fmt::format("a patch size above {:.3g} m, or a higher limit", std::sqrt(total / double(most))));
}

}  // namespace

PatchMesh subdivide(const Scene& scene, const SceneFaces& faces, PatchSizes sizes, uint64_t most, Warnings& warnings) {
  check_count(faces, faces.area(), sizes.patch, most);
  PatchMesh mesh;
  PatchBuilder builder(mesh, scene, most);
  builder.reserve(size_t(std::min(double(most), 1.1 * faces.area() / (sizes.patch * sizes.patch))));
  const Junctions junctions(faces.points());
  Subdivision subdivision(mesh, builder, sizes, junctions);
  for (size_t i = 0; i < faces.faces.size(); ++i) subdivision.add(faces.instances[i], faces.faces[i]);
  warn_of_repairs(faces, builder, warnings);
  return mesh;
}

Subdivision::Region Subdivision::Region::turned(size_t by) const {
  return {{sides[by % 4], sides[(by + 1) % 4], sides[(by + 2) % 4], sides[(by + 3) % 4]}, count};
}

Subdivision::Subdivision(PatchMesh& mesh, PatchBuilder& builder, PatchSizes sizes, const Junctions& junctions)
    : mesh_(mesh), builder_(builder), sizes_{sizes.patch, sizes.shooter / kSlack}, junctions_(junctions) {}

void Subdivision::add(uint32_t instance, const SourceFaces& faces) {
  builder_.begin(instance, faces);
  faces_ = &faces;
  edges_.clear();
  ids_.assign(faces.positions.size(), kNone);
  for (const SourceFace& face : faces.list) add(face);
}

void Subdivision::add(const SourceFace& face) {
  face_ = &face;
  pool_.clear();
  Region r{{}, face.is_quad() ? 4U : 3U};
  for (size_t k = 0; k < r.count; ++k)
    r.sides[k] = edge(corner(face.corners[k]), corner(face.corners[(k + 1) % r.count]));
  in_shooter_ = false;
  cut(r);
}

uint32_t Subdivision::corner(uint32_t of_faces) {
  uint32_t& id = ids_[of_faces];
  if (id == kNone) id = add_vertex(faces_->positions[of_faces]);
  return id;
}

void Subdivision::open_shooter(const Corners& outline) {
  mesh_.shooters.push_back({uint32_t(mesh_.size()), 0, outline});
}

void Subdivision::close_shooter() {
  if (mesh_.shooters.back().count == 0) mesh_.shooters.pop_back();
  in_shooter_ = false;
}

void Subdivision::add_patch(const Corners& c) {
  if (!builder_.has_area(c)) return;
  builder_.add_patch(*face_, c);
  ++mesh_.shooters.back().count;
}

double Subdivision::length_of(Side s) const { return distance(vertex(s, 0), vertex(s, s.pieces())); }

/// Where vertex k of a side lies: 0 at its start, 1 at its end.
double Subdivision::along(Side s, size_t k) const { return distance(vertex(s, 0), vertex(s, k)) / length_of(s); }

/// Longest over shortest piece.
double Subdivision::unevenness(Side s) const {
  double least = 1e300, most = 0;
  for (size_t k = 0; k < s.pieces(); ++k) {
    const double piece = distance(vertex(s, k), vertex(s, k + 1));
    least = std::min(least, piece), most = std::max(most, piece);
  }
  return most / least;
}

Subdivision::Corners Subdivision::corners(const Region& r) const {
  Corners c;
  for (size_t k = 0; k < 4; ++k) c[k] = vertex(r.sides[std::min(k, r.count - 1)], 0);
  return c;
}

bool Subdivision::fits(const Corners& c, double size) const {
  for (size_t k = 0; k < 4; ++k)
    if (distance(c[k], c[(k + 1) % 4]) > size * (1 + 1e-6)) return false;
  return true;
}

/// Adds to `run`, which ends with a, equal pieces up to b.
void Subdivision::divide(uint32_t a, uint32_t b, std::vector<uint32_t>& run) {
  const Vec3d p(mesh_.positions[a]), q(mesh_.positions[b]);
  const auto n = int(std::max(1.0, std::ceil(length(q - p) / sizes_.patch * kSlack)));
  for (int k = 1; k < n; ++k) run.push_back(add_vertex(Point3(p + (q - p) * (double(k) / n))));
  run.push_back(b);
}

/// An edge of the face: cut at others' vertices, then into equal pieces.
Subdivision::Side Subdivision::edge(uint32_t a, uint32_t b) {
  const bool turn = !in_order(mesh_.positions[a], mesh_.positions[b]);
  const uint32_t from = turn ? b : a, to = turn ? a : b;
  const auto known = edges_.find(key(a, b));
  if (known != edges_.end()) {
    run_ = known->second;
  } else {
    junctions_.on_edge(mesh_.positions[from], mesh_.positions[to], found_);
    run_.assign(1, from);
    for (const Point3 p : found_) divide(run_.back(), add_vertex(p), run_);
    divide(run_.back(), to, run_);
    if (run_.size() > 2) edges_[key(a, b)] = run_;
  }
  const auto first = int(pool_.size());
  pool_.insert(pool_.end(), run_.begin(), run_.end());
  const Side side{first, int(pool_.size()) - 1};
  return turn ? side.reversed() : side;
}

/// A new side through the face, in equal pieces.
Subdivision::Side Subdivision::straight(uint32_t a, uint32_t b) {
  const auto first = int(pool_.size());
  pool_.push_back(a);
  divide(a, b, pool_);
  return {first, int(pool_.size()) - 1};
}

void Subdivision::cut(const Region& r) {
  const bool opens = !in_shooter_ && fits(corners(r), sizes_.shooter);
  if (opens) open_shooter(corners(r)), in_shooter_ = true;
  if (r.count == 3)
    cut_triangle(r);
  else
    cut_quad(r);
  if (opens) close_shooter();
}

/// Across the longest side that has vertices, at the one nearest its middle.
void Subdivision::cut_triangle(const Region& r) {
  size_t longest = 3;
  for (size_t k = 0; k < 3; ++k)
    if (r.pieces(k) > 1 && (longest == 3 || length_of(r.sides[k]) > length_of(r.sides[longest]) * (1 + 1e-6)))
      longest = k;
  if (longest == 3) {
    const bool opens = !in_shooter_;
    if (opens) open_shooter(corners(r)), in_shooter_ = true;
    add_patch(corners(r));
    if (opens) close_shooter();
    return;
  }
  const Side base = r.sides[longest], up = r.sides[(longest + 1) % 3], down = r.sides[(longest + 2) % 3];
  size_t middle = 1;
  for (size_t k = 2; k < base.pieces(); ++k)
    if (std::abs(along(base, k) - 0.5) < std::abs(along(base, middle) - 0.5)) middle = k;
  const Side across = straight(vertex(base, middle), vertex(down, 0));
  cut({{base.part(0, middle), across, down}, 3});
  cut({{base.part(middle, base.pieces()), up, across.reversed()}, 3});
}

void Subdivision::cut_quad(const Region& r) {
  if (is_grid(r)) return add_grid(r);
  const bool wide = length_of(r.sides[0]) + length_of(r.sides[2]) >= length_of(r.sides[1]) + length_of(r.sides[3]);
  const Region first = r.turned(wide ? 0 : 1), second = r.turned(wide ? 1 : 0);
  const Cut a = best_cut(first), b = best_cut(second);
  const auto good = [&](const Cut& c, double most) { return c.skew >= 0 && c.skew <= most * sizes_.patch; };
  if (peel(first) || peel(second)) return;
  if (good(a, kLittleSkew)) return cut_across(first, a.from, a.to);
  if (good(b, kLittleSkew)) return cut_across(second, b.from, b.to);
  if (good(a, kMostSkew)) return cut_across(first, a.from, a.to);
  if (good(b, kMostSkew)) return cut_across(second, b.from, b.to);
  cut_diagonally(r);
}

/// From side 0 to side 2: near the middle if hardly skew, else as little skew as there is.
Subdivision::Cut Subdivision::best_cut(const Region& r) const {
  const Side a = r.sides[0], c = r.sides[2];
  Cut best{0, 0, -1};
  if (a.pieces() < 2 || c.pieces() < 2) return best;
  const double size = std::max(length_of(a), length_of(c));
  double least = 1e300;
  size_t j = c.pieces() - 1;
  for (size_t i = 1; i < a.pieces(); ++i) {
    const double t = along(a, i);
    const auto off = [&](size_t k) { return std::abs(1 - along(c, k) - t); };
    while (j > 1 && off(j - 1) <= off(j)) --j;
    const double skew = off(j) * size;
    const double cost = skew <= kLittleSkew * sizes_.patch ? std::abs(t - 0.5) : 1 + skew / sizes_.patch;
    if (cost < least) least = cost, best = {i, j, skew};
  }
  return best;
}

/// Where sides 0 and 2 do not fit each other, a row of patches along the less even one takes up the difference.
bool Subdivision::peel(const Region& r) {
  const size_t right = r.pieces(1), left = r.pieces(3);
  if (right < 2 || left < 2 || match(r.sides[0], r.sides[2])) return false;
  const Region from = unevenness(r.sides[0]) >= unevenness(r.sides[2]) ? r : r.turned(2);
  const Side up = from.sides[1], down = from.sides[3];
  const size_t end = down.pieces() - 1;
  const double thick = distance(vertex(up, 0), vertex(up, 1));
  if (std::abs(thick - distance(vertex(down, end), vertex(down, end + 1))) > kMostSkew * sizes_.patch) return false;
  cut_across(from.turned(1), 1, end);
  return true;
}

void Subdivision::cut_across(const Region& r, size_t from, size_t to) {
  const auto& [a, b, c, d] = r.sides;
  const Side across = straight(vertex(a, from), vertex(c, to));
  const Region right{{a.part(from, a.pieces()), b, c.part(0, to), across.reversed()}, 4};
  cut({{a.part(0, from), across, c.part(to, c.pieces()), d}, 4});
  cut(right);
}

void Subdivision::cut_diagonally(const Region& r) {
  const Corners c = corners(r);
  const Region t = distance(c[0], c[2]) <= distance(c[1], c[3]) ? r : r.turned(1);
  const Side across = straight(vertex(t.sides[2], 0), vertex(t.sides[0], 0));
  cut({{t.sides[0], t.sides[1], across}, 3});
  cut({{across.reversed(), t.sides[2], t.sides[3]}, 3});
}

bool Subdivision::match(Side a, Side opposite) const {
  const size_t n = a.pieces();
  if (opposite.pieces() != n) return false;
  for (size_t k = 1; k < n; ++k)
    if (std::abs(along(a, k) + along(opposite, n - k) - 1) > kMatch) return false;
  return true;
}

bool Subdivision::is_grid(const Region& r) const {
  return match(r.sides[0], r.sides[2]) && match(r.sides[1], r.sides[3]);
}

/// Straight lines between vertices of opposite sides: of a planar quadrilateral, a bilinear map of the square.
void Subdivision::add_grid(const Region& r) {
  const auto& [a, b, c, d] = r.sides;
  const size_t columns = a.pieces(), rows = b.pieces();
  grid_columns_ = columns + 1;
  grid_.resize(grid_columns_ * (rows + 1));
  const Vec3d p(mesh_.positions[vertex(a, 0)]), q(mesh_.positions[vertex(b, 0)]), s(mesh_.positions[vertex(c, 0)]),
      o(mesh_.positions[vertex(d, 0)]);
  for (size_t y = 0; y <= rows; ++y)
    for (size_t x = 0; x <= columns; ++x) {
      uint32_t& at = grid_[y * grid_columns_ + x];
      if (y == 0 || y == rows) {
        at = y == 0 ? vertex(a, x) : vertex(c, columns - x);
      } else if (x == 0 || x == columns) {
        at = x == 0 ? vertex(d, rows - y) : vertex(b, y);
      } else {
        const double u = 0.5 * (along(a, x) + 1 - along(c, columns - x)),
                     v = 0.5 * (along(b, y) + 1 - along(d, rows - y));
        at = add_vertex(Point3((p * (1 - u) + q * u) * (1 - v) + (o * (1 - u) + s * u) * v));
      }
    }
  add_block(0, columns, 0, rows);
}

Subdivision::Corners Subdivision::block(size_t column, size_t columns, size_t row, size_t rows) const {
  const auto at = [&](size_t x, size_t y) { return grid_[(row + y) * grid_columns_ + column + x]; };
  return {at(0, 0), at(columns, 0), at(columns, rows), at(0, rows)};
}

/// Halved down to patches, so that neighbours come soon after each other; what shoots as one is opened on the way.
void Subdivision::add_block(size_t column, size_t columns, size_t row, size_t rows) {
  const Corners outline = block(column, columns, row, rows);
  const bool single = columns == 1 && rows == 1, opens = !in_shooter_ && (single || fits(outline, sizes_.shooter));
  if (opens) open_shooter(outline), in_shooter_ = true;
  const double wide = distance(outline[0], outline[1]) + distance(outline[2], outline[3]);
  const double high = distance(outline[1], outline[2]) + distance(outline[3], outline[0]);
  if (single) {
    add_patch(outline);
  } else if (rows == 1 || (columns > 1 && wide >= high)) {
    add_block(column, columns / 2, row, rows);
    add_block(column + columns / 2, columns - columns / 2, row, rows);
  } else {
    add_block(column, columns, row, rows / 2);
    add_block(column, columns, row + rows / 2, rows - rows / 2);
  }
  if (opens) close_shooter();
}

}  // namespace aktina
