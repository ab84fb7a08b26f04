// B. Alpert, "A Class of Bases in L2 for the Sparse Representation of Integral Operators", SIAM J. Math. Anal. 24,
// 1993; flatlets: S. Gortler, P. Schroeder, M. Cohen, P. Hanrahan, "Wavelet Radiosity", SIGGRAPH '93. Rules for
// triangles: D. Dunavant, "High Degree Efficient Symmetrical Gaussian Quadrature Rules for the Triangle", Int. J.
// Numerical Methods in Engineering 21, 1985.
#include "aktina/radiosity/solver/hierarchy/basis.h"

#include <cmath>

#include "aktina/radiosity/formfactor/quadrature.h"

namespace aktina {
namespace {

constexpr double kInset = 0.1;  // of test points from the corners

std::vector<BasisPoint> gauss_square(int n) {
  std::vector<BasisPoint> points;
  for (const GaussPoint& y : gauss_legendre(n))
    for (const GaussPoint& x : gauss_legendre(n)) points.push_back({x.x, y.x, x.weight * y.weight});
  return points;
}

/// Exact to degree 2 n - 2: the square drawn together at a corner.
std::vector<BasisPoint> gauss_triangle(int n) {
  std::vector<BasisPoint> points;
  for (const GaussPoint& s : gauss_legendre(n))
    for (const GaussPoint& t : gauss_legendre(n))
      points.push_back({s.x, (1 - s.x) * t.x, 2 * (1 - s.x) * s.weight * t.weight});
  return points;
}

std::vector<BasisPoint> fine_points(bool triangle) { return triangle ? gauss_triangle(4) : gauss_square(4); }

void add_orbit(std::vector<BasisPoint>& points, double a, double weight) {
  points.push_back({a, a, weight}), points.push_back({1 - 2 * a, a, weight}), points.push_back({a, 1 - 2 * a, weight});
}

/// As many points as functions, or more; on triangles exact to degree 2 (Strang, Fix) and 4 (Dunavant).
std::vector<BasisPoint> sample_points(bool triangle, int order) {
  if (!triangle) return gauss_square(std::max(order, 2));
  std::vector<BasisPoint> points;
  if (order < 3) {
    add_orbit(points, 1.0 / 6, 1.0 / 3);
  } else {
    add_orbit(points, 0.445948490915965, 0.223381589678011);
    add_orbit(points, 0.091576213509771, 0.109951743655322);
  }
  return points;
}

std::vector<BasisPoint> test_points(bool triangle) {
  const double c = triangle ? 1.0 / 3 : 0.5, low = kInset, high = triangle ? 1 - 2 * low : 1 - low;
  std::vector<BasisPoint> points = {{c, c, 0}, {low, low, 0}, {high, low, 0}, {low, high, 0}};
  if (!triangle) points.push_back({high, high, 0});
  return points;
}

/// Mean of x^a y^b.
double moment(bool triangle, int a, int b) {
  if (!triangle) return 1.0 / ((a + 1) * (b + 1));
  return 2 * std::tgamma(a + 1) * std::tgamma(b + 1) / std::tgamma(a + b + 3);
}

double mean_of_product(bool triangle, const double* p, const double* q) {
  double sum = 0;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j)
      if (p[i] != 0 && q[j] != 0) sum += p[i] * q[j] * moment(triangle, i / 3 + j / 3, i % 3 + j % 3);
  return sum;
}

/// Gram and Schmidt's way from the powers of x and y.
std::vector<double> orthonormal(bool triangle, int order) {
  std::vector<double> all;
  const auto add = [&](int a, int b) {
    std::array<double, 9> p{};
    p[size_t(3 * a + b)] = 1;
    for (int round = 0; round < 2; ++round)  // once more for rounding
      for (size_t i = 0; i < all.size(); i += 9) {
        const double part = mean_of_product(triangle, p.data(), &all[i]);
        for (size_t k = 0; k < 9; ++k) p[k] -= part * all[i + k];
      }
    const double norm = std::sqrt(mean_of_product(triangle, p.data(), p.data()));
    for (const double each : p) all.push_back(each / norm);
  };
  for (int a = 0; a < order; ++a)
    for (int b = 0; b < (triangle ? order - a : order); ++b) add(a, b);
  return all;
}

void sample(ShapeBasis& shape) {
  for (const BasisPoint& p : shape.points)
    for (size_t i = 0; i < shape.count; ++i) shape.values.push_back(shape.value(i, {p.x, p.y}));
  shape.tests = test_points(shape.triangle);
  for (const BasisPoint& t : shape.tests)
    for (size_t a = 0; a < shape.points.size(); ++a) {
      double sum = 0;
      for (size_t i = 0; i < shape.count; ++i)
        sum += shape.value(i, {t.x, t.y}) * shape.values[a * shape.count + i] * shape.points[a].weight;
      shape.received.push_back(sum);
    }
  shape.sent = shape.received;
}

ShapeBasis polynomial_shape(bool triangle, int order) {
  ShapeBasis shape{triangle, size_t(triangle ? order * (order + 1) / 2 : order * order), {}, {}, {}, {}, {}, {}, {},
                   {}};
  shape.powers = orthonormal(triangle, order);
  shape.points = sample_points(triangle, order);
  sample(shape);
  for (int c = 0; c < 4; ++c)
    for (size_t i = 0; i < shape.count; ++i)
      for (size_t j = 0; j < shape.count; ++j) {
        double sum = 0;
        for (const BasisPoint& p : fine_points(triangle))
          sum += p.weight * shape.value(i, in_parent(triangle, c, {p.x, p.y})) * shape.value(j, {p.x, p.y});
        shape.push[size_t(c)].push_back(sum), shape.pull[size_t(c)].push_back(sum / 4);
      }
  return shape;
}

Vec2d quarter_middle(bool triangle, int c) { return in_parent(triangle, c, Vec2d(triangle ? 1.0 / 3 : 0.5)); }

/// What the middles of quarters tell about places in between: the plane, on squares the bilinear surface, through them.
class ThroughMiddles {
 public:
  explicit ThroughMiddles(bool triangle) : triangle_(triangle) {
    for (int c = 0; c < 4; ++c) {
      const Vec2d d = from_centre(quarter_middle(triangle, c));
      xx_ += d.x * d.x / 4, xy_ += d.x * d.y / 4, yy_ += d.y * d.y / 4;
    }
  }
  Vec2d from_centre(Vec2d p) const { return p - Vec2d(triangle_ ? 1.0 / 3 : 0.5); }
  /// d . (mean of d_i d_i^T)^-1 e
  double product(Vec2d d, Vec2d e) const {
    const double det = xx_ * yy_ - xy_ * xy_;
    return (d.x * (yy_ * e.x - xy_ * e.y) + d.y * (xx_ * e.y - xy_ * e.x)) / det;
  }
  double weight(int c, Vec2d at) const {
    const Vec2d d = from_centre(quarter_middle(triangle_, c)), e = from_centre(at);
    const double twisted = triangle_ ? 0 : e.x * d.x * e.y * d.y / (xx_ * yy_);
    return (1 + product(d, e) + twisted) / 4;
  }

 private:
  bool triangle_;
  double xx_ = 0, xy_ = 0, yy_ = 0;
};

/// A node's box is the mean of the four boxes in its place, corrected by the plane (and twist) that keeps the moments
/// of all sixteen.
void pull_boxes(ShapeBasis& shape) {
  const ThroughMiddles through(shape.triangle);
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const Vec2d own = quarter_middle(shape.triangle, c);
        const Vec2d fine = in_parent(shape.triangle, c, quarter_middle(shape.triangle, j));
        const double moved = (through.weight(i, fine) - through.weight(i, own)) / 4;
        shape.pull[size_t(c)].push_back((i == c ? 0.25 : 0) + moved);
        shape.push[size_t(c)].push_back(i == c ? 1 : 0);
      }
}

ShapeBasis flatlet_shape(bool triangle) {
  ShapeBasis shape{triangle, 4, {}, {}, {}, {}, {}, {}, {}, {}};
  for (int c = 0; c < 4; ++c) {
    const Vec2d p = quarter_middle(triangle, c);
    shape.points.push_back({p.x, p.y, 0.25});
  }
  sample(shape);
  const ThroughMiddles through(triangle);
  for (size_t t = 0; t < shape.tests.size(); ++t)
    for (int c = 0; c < 4; ++c) shape.sent[t * 4 + size_t(c)] = through.weight(c, {shape.tests[t].x, shape.tests[t].y});
  pull_boxes(shape);
  return shape;
}

}  // namespace

double ShapeBasis::value(size_t function, Vec2d at) const {
  if (powers.empty()) {
    const Vec2d p = in_child(triangle, int(function), at);
    const bool within = p.x >= 0 && p.y >= 0 && (triangle ? p.x + p.y <= 1 : p.x < 1 && p.y < 1);
    return within ? 2 : 0;
  }
  const double* p = &powers[9 * function];
  const auto in_y = [&](size_t a) { return p[3 * a] + at.y * (p[3 * a + 1] + at.y * p[3 * a + 2]); };
  return in_y(0) + at.x * (in_y(1) + at.x * in_y(2));
}

std::vector<double> ShapeBasis::moments(const FlatPolygon& part) const {
  const double whole = triangle ? 0.5 : 1;
  std::vector<double> sums(count, 0);
  if (powers.empty()) {
    for (size_t c = 0; c < count; ++c) {
      FlatPolygon quarter;
      for (const Vec2d& p : part) quarter.push_back(in_child(triangle, int(c), p));
      cut_by_reference(quarter, triangle);
      sums[c] = 2 * area_of(quarter) / (4 * whole);
    }
    return sums;
  }
  static const std::vector<BasisPoint> rule = gauss_triangle(3);
  for (size_t k = 2; k < part.size(); ++k) {
    const Vec2d a = part[k - 1] - part[0], b = part[k] - part[0];
    const double share = std::abs(a.x * b.y - a.y * b.x) / (2 * whole);
    for (const BasisPoint& p : rule)
      for (size_t i = 0; i < count; ++i) sums[i] += share * p.weight * value(i, part[0] + p.x * a + p.y * b);
  }
  return sums;
}

Basis Basis::polynomials(int order) {
  Basis basis;
  basis.shapes_ = {polynomial_shape(false, order), polynomial_shape(true, order)};
  return basis;
}

Basis Basis::flatlets() {
  Basis basis;
  basis.shapes_ = {flatlet_shape(false), flatlet_shape(true)};
  return basis;
}

}  // namespace aktina
