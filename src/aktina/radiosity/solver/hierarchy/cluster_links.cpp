#include "aktina/radiosity/solver/hierarchy/cluster_links.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr size_t kBatch = 1 << 15;  // links that are looked at before surfaces are cut
constexpr size_t kGrain = 64;
constexpr float kApart = 1.3f;  // distance over the sum of radii, below which a link is always cut
constexpr int kFewRays = 4, kUsualRays = 16;
constexpr float kClear = 0.999f, kDoubt = 0.1f;  // as in LinkRefinement
constexpr double kOblique = 0.25;                // of the area: what surfaces that seem turned away may yet show
constexpr uint32_t kTries = 16;                  // for a surface that is turned to the other end
constexpr double kMostLinks = 4e7;

}  // namespace

ClusterLinks::ClusterLinks(SurfaceTree& tree, TreeLight& light, const Visibility& visibility, size_t bands,
                           uint32_t seed)
    : tree_(tree), light_(light), visibility_(visibility), bands_(bands), seed_(seed), clusters_(tree) {
  const size_t count = clusters_.clusters().size();
  intensities_.resize(count * kAxes * bands), arriving_.resize(intensities_.size());
  brightness_.resize(count), importance_.resize(count);
  if (count > 0) links_.push_back({ClusterTree::place(0), ClusterTree::place(0), Vec3(0), 0, 0, -1});
}

ClusterLinks::Body ClusterLinks::body(uint32_t place) const {
  if (ClusterTree::is_cluster(place)) {
    const Cluster& c = clusters_.cluster(place);
    return {c.centre, c.radius, c.area};
  }
  const TreePatch patch = tree_.patch(place);
  return {patch.middle(), patch.radius(), patch.area};
}

double ClusterLinks::brightness(uint32_t place) const {
  return ClusterTree::is_cluster(place) ? brightness_[ClusterTree::number(place)] : light_.brightness(place);
}

double ClusterLinks::importance(uint32_t place) const {
  return ClusterTree::is_cluster(place) ? importance_[ClusterTree::number(place)] : light_.importance(place);
}

/// The larger one, if it may be cut; clusters always may.
ClusterLinks::Verdict ClusterLinks::to_cut(const Link& link, const Body& receiver, const Body& sender) const {
  const auto may = [&](uint32_t place) { return ClusterTree::is_cluster(place) || tree_.may_be_cut(place); };
  if (receiver.radius >= sender.radius) return may(link.receiver) ? Verdict::cut_receiver : Verdict::cut_sender;
  return may(link.sender) ? Verdict::cut_sender : Verdict::cut_receiver;
}

/// What scales the light kept by axis so that the projected area is right.
double ClusterLinks::shared(uint32_t place, Vec3 direction) const {
  const Cluster& c = clusters_.cluster(place);
  double by_axis = 0;
  for (size_t axis = 0; axis < kAxes; ++axis)
    by_axis += double(std::max(0.0f, along_axis(direction, axis))) * c.across[axis];
  return by_axis > 0 ? clusters_.across(place, direction) / by_axis : 0;
}

ClusterLinks::Verdict ClusterLinks::evaluate(Link& link) const {
  const Body receiver = body(link.receiver), sender = body(link.sender);
  link.visible = -1;
  if (!shines(link.sender)) return Verdict::link;
  const double bright = weight(link);
  const float distance = length(sender.centre - receiver.centre), reach = receiver.radius + sender.radius;
  if (distance <= kApart * reach) return to_cut(link, receiver, sender);
  link.direction = (sender.centre - receiver.centre) / distance;
  const double d = double(distance), tilt = kOblique * double(reach) / d;
  const double arrives = clusters_.across(link.receiver, link.direction),
               leaves = clusters_.across(link.sender, -link.direction);
  const double kernel = 1 / (kPi * d * d), near = d / (d - double(reach));
  const double carried = kernel * arrives * leaves;
  const double spread =
      kernel * std::max(arrives, tilt * receiver.area) * std::max(leaves, tilt * sender.area) * (near * near - 1);
  const auto end = [&](uint32_t place, Vec3 direction, double across, double area) {
    return ClusterTree::is_cluster(place) ? shared(place, direction) : across / area;
  };
  const bool from_cluster = ClusterTree::is_cluster(link.sender);
  link.scale = float(kernel * end(link.receiver, link.direction, arrives, receiver.area) *
                     (from_cluster ? shared(link.sender, -link.direction) : leaves));
  link.visible = 1;
  if (carried > 0) look(link, bright * carried < 0.5 * final_ ? kFewRays : kUsualRays);
  const double seen = double(std::max(link.visible, kDoubt));
  double error = spread * seen;
  if (link.visible < kClear) error += carried * double(std::max(link.visible * (1 - link.visible), kDoubt));
  link.error = float(error);
  return bright * error > most_ ? to_cut(link, receiver, sender) : Verdict::link;
}

void ClusterLinks::look(Link& link, float rays) const {
  float passed = 0;
  VisibilityQueue queue(visibility_, Coherence::coherent, &passed);
  const uint32_t seed = hash_combine(hash_combine(seed_, link.receiver), link.sender);
  for (uint32_t k = 0; k < uint32_t(rays); ++k) {
    const Point3 x = point_on(link.receiver, link.direction, k, seed),
                 y = point_on(link.sender, -link.direction, k, hash32(seed));
    queue.add({x, y - x, 0, 1}, 0);
  }
  queue.flush();
  link.visible = passed / rays;
}

/// A place on a surface that is turned there, a little in front of it.
Point3 ClusterLinks::point_on(uint32_t place, Vec3 towards, uint32_t sample, uint32_t seed) const {
  const Vec2 at = sobol_owen(sample, seed);
  uint32_t root = place;
  if (ClusterTree::is_cluster(place))
    for (uint32_t k = 0; k < kTries; ++k) {
      const Vec2 u = sobol_owen(sample, hash_combine(seed, k + 1));
      root = clusters_.root_at(clusters_.cluster(place), u.x);
      if (dot(tree_.root(root).normal, towards) > u.y) break;
    }
  const TreePatch patch = tree_.patch(root);
  return patch.place(at) + visibility_.offset() * patch.normal;
}

void ClusterLinks::open(uint32_t receiver, uint32_t sender) {
  if (ClusterTree::is_cluster(receiver) || ClusterTree::is_cluster(sender))
    open_.push_back({receiver, sender, Vec3(0), 0, 0, -1});
  else if (receiver != sender)
    pairs_.push_back({receiver, sender});
}

void ClusterLinks::cut(const Link& link, Verdict verdict) {
  if (link.receiver == link.sender) {  // both: each half with itself and the other
    const auto& children = clusters_.cluster(link.receiver).children;
    for (const uint32_t receiver : children)
      for (const uint32_t sender : children) open(receiver, sender);
    return;
  }
  const bool of_receiver = verdict == Verdict::cut_receiver;
  const uint32_t place = of_receiver ? link.receiver : link.sender;
  const auto each = [&](uint32_t part) { of_receiver ? open(part, link.sender) : open(link.receiver, part); };
  if (ClusterTree::is_cluster(place)) {
    for (const uint32_t child : clusters_.cluster(place).children) each(child);
  } else {
    const uint32_t first = tree_.is_leaf(place) ? tree_.cut(place) : tree_.nodes()[place].children;
    for (uint32_t c = 0; c < 4; ++c) each(first + c);
  }
}

std::vector<NodePair> ClusterLinks::refine(double most, double final, Progress* progress) {
  most_ = most, final_ = final;
  pull();
  std::vector<Link> kept;
  pairs_.clear();
  for (const Link& link : links_) {
    const bool known = link.visible >= 0 && weight(link) * double(link.error) <= most;
    (known ? kept : open_).push_back(link);
  }
  std::vector<Link> batch;
  std::vector<Verdict> verdicts;
  while (!open_.empty() && !(progress && progress->cancelled())) {
    const size_t count = std::min(open_.size(), kBatch);
    batch.assign(open_.end() - std::ptrdiff_t(count), open_.end());
    open_.resize(open_.size() - count);
    verdicts.resize(count);
    parallel_for(count, kGrain, [&](size_t begin, size_t end) {
      for (size_t k = begin; k < end; ++k) verdicts[k] = evaluate(batch[k]);
    });
    const size_t nodes = tree_.nodes().size();
    for (size_t k = 0; k < count; ++k)
      verdicts[k] == Verdict::link ? kept.push_back(batch[k]) : cut(batch[k], verdicts[k]);
    if (tree_.nodes().size() > nodes) light_.grow();
    if (double(kept.size()) + double(pairs_.size()) > kMostLinks)
      throw Error(Code::limit, "target_error", fmt::format("more than {:.0f} links of clusters", kMostLinks),
                  "a higher target error");
  }
  kept.insert(kept.end(), open_.begin(), open_.end());
  open_.clear();
  std::sort(kept.begin(), kept.end(), [](const Link& a, const Link& b) {
    return a.receiver != b.receiver ? a.receiver < b.receiver : a.sender < b.sender;
  });
  links_ = std::move(kept);
  return std::move(pairs_);
}

void ClusterLinks::pull() {
  std::fill(intensities_.begin(), intensities_.end(), 0.0);
  const auto clusters = clusters_.clusters();
  const size_t per_cluster = kAxes * bands_;
  for (size_t c = clusters.size(); c-- > 0;) {
    double* own = &intensities_[c * per_cluster];
    double power = 0, matters = 0;
    for (const uint32_t child : clusters[c].children) {
      power += body(child).area * brightness(child), matters += body(child).area * importance(child);
      if (ClusterTree::is_cluster(child)) {
        const double* from = &intensities_[ClusterTree::number(child) * per_cluster];
        for (size_t k = 0; k < per_cluster; ++k) own[k] += from[k];
        continue;
      }
      const std::span<const double> radiosity = light_.radiosity(child);
      for (size_t axis = 0; axis < kAxes; ++axis) {
        const double across = tree_.area(child) * double(std::max(0.0f, along_axis(tree_.root(child).normal, axis)));
        for (size_t b = 0; b < bands_; ++b) own[axis * bands_ + b] += across * radiosity[b];
      }
    }
    brightness_[c] = power / clusters[c].area, importance_[c] = matters / clusters[c].area;
  }
}

void ClusterLinks::gather(std::vector<double>& gathered) {
  pull();
  std::fill(arriving_.begin(), arriving_.end(), 0.0);
  std::vector<size_t> first;  // link of each receiver
  for (size_t k = 0; k < links_.size(); ++k)
    if (k == 0 || links_[k].receiver != links_[k - 1].receiver) first.push_back(k);
  first.push_back(links_.size());
  const size_t per_cluster = kAxes * bands_;
  parallel_for(first.size() - 1, kGrain, [&](size_t begin, size_t end) {
    std::vector<double> light(bands_);
    for (size_t k = first[begin]; k < first[end]; ++k) {
      const Link& link = links_[k];
      if (!(link.visible > 0) || !(link.scale > 0)) continue;
      const double scale = double(link.scale) * double(link.visible);
      for (size_t b = 0; b < bands_; ++b) {
        if (!ClusterTree::is_cluster(link.sender)) {
          light[b] = scale * light_.radiosity(link.sender)[b];
          continue;
        }
        light[b] = 0;
        const double* from = &intensities_[ClusterTree::number(link.sender) * per_cluster];
        for (size_t axis = 0; axis < kAxes; ++axis)
          light[b] += scale * double(std::max(0.0f, along_axis(-link.direction, axis))) * from[axis * bands_ + b];
      }
      if (!ClusterTree::is_cluster(link.receiver)) {
        for (size_t b = 0; b < bands_; ++b) gathered[link.receiver * bands_ + b] += light[b];
        continue;
      }
      double* to = &arriving_[ClusterTree::number(link.receiver) * per_cluster];
      for (size_t axis = 0; axis < kAxes; ++axis)
        for (size_t b = 0; b < bands_; ++b)
          to[axis * bands_ + b] += double(std::max(0.0f, along_axis(link.direction, axis))) * light[b];
    }
  });
  const auto clusters = clusters_.clusters();
  for (size_t c = 0; c < clusters.size(); ++c)
    for (const uint32_t child : clusters[c].children) {
      const double* from = &arriving_[c * per_cluster];
      if (ClusterTree::is_cluster(child)) {
        double* to = &arriving_[ClusterTree::number(child) * per_cluster];
        for (size_t k = 0; k < per_cluster; ++k) to[k] += from[k];
        continue;
      }
      for (size_t axis = 0; axis < kAxes; ++axis) {
        const double cosine = double(std::max(0.0f, along_axis(tree_.root(child).normal, axis)));
        for (size_t b = 0; b < bands_; ++b) gathered[child * bands_ + b] += cosine * from[axis * bands_ + b];
      }
    }
}

}  // namespace aktina
