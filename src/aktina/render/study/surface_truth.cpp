#include "aktina/render/study/surface_truth.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/random.h"
#include "aktina/radiosity/display/patch_scene.h"
#include "aktina/render/study/within.h"
#include "aktina/trace/illuminance.h"
#include "aktina/trace/offset.h"
#include "aktina/trace/ray_scene.h"

namespace aktina {
namespace {

constexpr size_t kEven = 400, kContacts = 200;  // places
constexpr size_t kCandidates = 40;              // for each place near a contact
constexpr float kNear = 0.01f;                  // of the scene's size: nearer than this to another surface is a contact
constexpr int kDirections = 12;                 // in which other surfaces are looked for
constexpr double kTraceError = 0.003;           // wanted, of the light's mean
constexpr int kMostSamples = 1 << 14;
constexpr double kDark = 0.01;   // of the mean: where there is less light relative errors mean nothing
constexpr double kWorst = 0.05;  // share of the places that the root mean square leaves out

struct Facet {
  Point3 a, b, c;
  Vec3 normal;
};

/// All triangles with an area, and their areas up to and with each.
std::vector<Facet> facets(const Scene& scene, std::vector<double>& upto) {
  std::vector<Facet> all;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[size_t(instance.mesh)];
    const auto at = [&](uint32_t v) { return Point3(instance.to_world * Vec4(mesh.positions[v], 1)); };
    const float side = glm::determinant(Mat3(instance.to_world)) < 0 ? -1.0f : 1.0f;
    for (const auto& t : mesh.triangles) {
      const Facet f{at(t[0]), at(t[1]), at(t[2]), {}};
      const Vec3 twice = cross(f.b - f.a, f.c - f.a);
      if (!(length(twice) > 0)) continue;
      all.push_back({f.a, f.b, f.c, side * normalize(twice)});
      upto.push_back((upto.empty() ? 0 : upto.back()) + 0.5 * double(length(twice)));
    }
  }
  return all;
}

double median(std::vector<double> values) {
  if (values.empty()) return kNotMeasured;
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  return values[values.size() / 2];
}

}  // namespace

Scene matt_scene(const Scene& scene) {
  Scene out = scene;
  for (Material& m : out.materials) {
    m.metallic = 0, m.roughness = 1, m.specular_weight = 0, m.transmission = 0;
    m.metallic_roughness_texture = m.transmission_texture = m.specular_texture = m.normal_texture = {};
    m.classic.reset();
  }
  return out;
}

SurfaceTruth::SurfaceTruth(const Scene& scene, uint32_t seed, Progress& progress)
    : scene_(scene), size_(length(bounds(scene).high - bounds(scene).low)) {
  choose_places(seed);
  std::vector<Point3> points;
  std::vector<Vec3> normals;
  for (const Place& p : places_) points.push_back(offset_point(p.position, p.normal)), normals.push_back(p.normal);
  const MeasureOptions options{.target_error = kTraceError, .most_samples = kMostSamples, .seed = seed};
  const Measurement truth =
      within(progress, [&](Progress& inner) { return measure_illuminance(scene, points, normals, options, &inner); });
  for (size_t i = 0; i < places_.size(); ++i) places_[i].lux = truth.lux[i];
  noise_ = truth.error;
  std::erase_if(places_, [](const Place& p) { return !std::isfinite(p.lux); });  // inside of bodies
  double count = 0;
  for (const Place& p : places_)
    if (p.any) mean_ += p.lux, ++count;
  mean_ /= std::max(count, 1.0);
  std::erase_if(places_, [&](const Place& p) { return p.lux < kDark * mean_; });
}

void SurfaceTruth::choose_places(uint32_t seed) {
  std::vector<double> upto;
  const std::vector<Facet> all = facets(scene_, upto);
  if (all.empty()) return;
  std::vector<Place> candidates;
  for (uint32_t k = 0; k < kEven + kContacts * kCandidates; ++k) {
    const Vec2 u = sobol_owen(k, hash32(seed)), w = sobol_owen(k, hash32(seed + 1));
    const auto at = std::upper_bound(upto.begin(), upto.end(), double(u.x) * upto.back());
    const Facet& f = all[std::min(size_t(at - upto.begin()), all.size() - 1)];
    const float root = std::sqrt(w.x);
    candidates.push_back({f.a + root * (1 - w.y) * (f.b - f.a) + root * w.y * (f.c - f.a), f.normal});
    candidates.back().any = k < kEven;
  }
  mark_contacts(candidates);
  size_t contacts = 0;
  for (Place& p : candidates) {
    p.contact = p.contact && contacts < kContacts;
    contacts += p.contact;
    if (p.any || p.contact) places_.push_back(p);
  }
}

/// Whether rays that leave flat above the surface soon meet another one.
void SurfaceTruth::mark_contacts(std::vector<Place>& places) const {
  const RayScene rays(scene_, {});
  for (Place& p : places) {
    const Frame frame(p.normal);
    for (int k = 0; k < kDirections && !p.contact; ++k) {
      const float angle = float(2 * kPi) * (float(k) + 0.5f) / kDirections;
      const Vec3 flat = frame.to_world(normalize(Vec3(std::cos(angle), std::sin(angle), 0.2f)));
      p.contact = rays.accelerator->occluded({offset_point(p.position, p.normal), flat, 0, kNear * size_});
    }
  }
}

/// Straight down on the patches.
std::vector<double> SurfaceTruth::light_of(const Solution& solution) const {
  const PatchScene patches(scene_, solution);
  const RayScene rays(patches.scene, {});
  std::vector<double> lux;
  for (const Place& p : places_) {
    const Hit hit = rays.accelerator->intersect(Ray{p.position + 1e-4f * size_ * p.normal, -p.normal});
    lux.push_back(kNotMeasured);
    if (!hit) continue;
    const auto& v = patches.vertices[hit.instance][hit.triangle];
    const bool mirrored = glm::determinant(Mat3(patches.scene.instances[hit.instance].to_world)) < 0;
    const float u = mirrored ? hit.v : hit.u, w = mirrored ? hit.u : hit.v;
    const auto& all = solution.vertex_irradiances;
    lux.back() = double(luminance(all[v[0]].v * (1 - u - w) + all[v[1]].v * u + all[v[2]].v * w));
  }
  return lux;
}

SurfaceTruth::Errors SurfaceTruth::errors(const Solution& solution) const {
  const std::vector<double> lux = light_of(solution);
  std::vector<double> even, contacts;
  for (size_t i = 0; i < places_.size(); ++i) {
    const double off = std::abs(lux[i] - places_[i].lux) / places_[i].lux;
    if (!std::isfinite(off)) continue;
    if (places_[i].any) even.push_back(off);
    if (places_[i].contact) contacts.push_back(off);
  }
  Errors errors{median(even), kNotMeasured, median(contacts)};
  std::sort(even.begin(), even.end());
  even.resize(size_t(double(even.size()) * (1 - kWorst)));
  double squares = 0;
  for (const double e : even) squares += e * e;
  if (!even.empty()) errors.rms = std::sqrt(squares / double(even.size()));
  return errors;
}

}  // namespace aktina
