// Where receivers lie on the surfaces of a scene: for solvers that divide the surfaces as they need instead of asking
// for form factors between receivers.
#pragma once

#include <array>
#include <vector>

#include "aktina/radiosity/solver/shot_geometry.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {

struct SurfaceLayout {
  /// A planar triangle or convex quadrilateral, one-sided, counter-clockwise seen from its front; the last two corners
  /// of a triangle are equal. A two-sided surface is two faces, in opposite order.
  struct Face {
    std::array<Point3, 4> corners;
    Vec3 normal;
  };
  /// What a receiver covers of a face: a triangle or convex quadrilateral. A receiver may have several, of several
  /// faces; together they have its area. A face may be covered in part only: what is buried belongs to nobody.
  struct Piece {
    uint32_t receiver;
    std::array<Point3, 4> corners;
    double area;  // m^2
  };
  std::vector<Face> faces;
  std::vector<Piece> pieces;           // those of a face together, in the order of faces
  std::vector<uint32_t> first_pieces;  // of each face; one more at the end
};

class ReceiverSurfaces {
 public:
  /// The arguments must outlive this.
  ReceiverSurfaces(const Scene& scene, const ShotGeometry& geometry, const Visibility& visibility)
      : scene_(scene), geometry_(geometry), visibility_(visibility) {}

  /// Put together at each call.
  SurfaceLayout layout() const;
  /// What passes between places of the surfaces.
  const Visibility& visibility() const { return visibility_; }

 private:
  const Scene& scene_;
  const ShotGeometry& geometry_;
  const Visibility& visibility_;
};

}  // namespace aktina
