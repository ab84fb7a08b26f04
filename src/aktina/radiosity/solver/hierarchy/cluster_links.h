// Links of which one end at least is a cluster: light that all its surfaces send or receive together.
//
// A cluster sends as seen from far away: the sum over its surfaces of B A cos, kept for the six directions along the
// axes and scaled to the surfaces' true projected area in the direction of the link. It receives in the same way: what
// arrives is kept by axis and handed to each surface by its cosine. So each link costs the same, however many surfaces
// are at its ends, and carries the right flux; how it is shared out among oblique surfaces is approximate. Other
// surfaces of the same cluster in between are seen by the link's rays.
//
// F. Sillion, "A Unified Hierarchical Algorithm for Global Illumination with Scattering Volumes and Object Clusters",
// IEEE TVCG 1(3) 1995; B. Smits, J. Arvo, D. Greenberg, "A Clustering Algorithm for Radiosity in Complex Environments",
// SIGGRAPH '94.
#pragma once

#include <vector>

#include "aktina/base/progress.h"
#include "aktina/radiosity/solver/hierarchy/cluster_tree.h"
#include "aktina/radiosity/solver/hierarchy/links.h"
#include "aktina/radiosity/solver/hierarchy/tree_light.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {

class ClusterLinks {
 public:
  /// One link: from the whole scene to itself. Light of one function a node. The arguments must outlive this.
  ClusterLinks(SurfaceTree& tree, TreeLight& light, const Visibility& visibility, size_t bands, uint32_t seed);

  /// Replaces links that may carry more than `most` wrongly by finer ones. @param most, final  flux, as LinkRefinement
  /// @return  pairs at whose ends are surfaces only: for others to link
  std::vector<NodePair> refine(double most, double final, Progress* progress);
  /// Adds what arrives over all links to irradiances of nodes, [node * bands + band].
  void gather(std::vector<double>& gathered);
  size_t size() const { return links_.size(); }

 private:
  struct Link {
    uint32_t receiver, sender;  // places
    Vec3 direction;             // from the receiver to the sender
    float scale;    // irradiance at the receiver over radiosity, or intensity, of the sender; for a cluster by axis
    float error;    // of flux over the sender's brightness, m^2
    float visible;  // share of rays that pass; below 0: nothing has shone yet
  };
  enum class Verdict : uint8_t { link, cut_receiver, cut_sender };
  struct Body {
    Point3 centre;
    float radius;
    double area;
  };

  Body body(uint32_t place) const;
  double brightness(uint32_t place) const;
  double importance(uint32_t place) const;
  bool shines(uint32_t place) const {
    return brightness(place) > 0 || (light_.has_importance() && importance(place) > 0);
  }
  /// What an error of a link's flux counts, over that error in m^2.
  double weight(const Link& link) const { return brightness(link.sender) * importance(link.receiver); }
  Verdict to_cut(const Link& link, const Body& receiver, const Body& sender) const;
  Verdict evaluate(Link& link) const;
  void look(Link& link, float rays) const;
  Point3 point_on(uint32_t place, Vec3 towards, uint32_t sample, uint32_t seed) const;
  void cut(const Link& link, Verdict verdict);
  void open(uint32_t receiver, uint32_t sender);
  void pull();
  double shared(uint32_t place, Vec3 direction) const;

  SurfaceTree& tree_;
  TreeLight& light_;
  const Visibility& visibility_;
  size_t bands_;
  uint32_t seed_;
  ClusterTree clusters_;
  std::vector<Link> links_, open_;  // sorted by receiver; to be looked at
  std::vector<NodePair> pairs_;
  std::vector<double> intensities_, arriving_;   // [(cluster * kAxes + axis) * bands + band]
  std::vector<double> brightness_, importance_;  // by cluster
  double most_ = 0, final_ = 0;
};

}  // namespace aktina
