// Rays among faces: what the sampling methods share.
#pragma once

#include <memory>

#include "aktina/radiosity/formfactor/faces.h"
#include "aktina/scene/scene.h"
#include "aktina/trace/accelerator/accelerator.h"

namespace aktina {

/// A scene's faces for the ray tracer, in units of its size about its middle, where 32-bit floats are finest.
class FaceRays {
 public:
  /// How far rays start and end above their surfaces, of the scene's size: gaps below about twice this are not seen.
  static constexpr float kOffset = 1e-6f;

  void build(const Faces& faces);
  /// A world point, lifted off a surface whose normal is n.
  Point3 lifted(Point3d x, Vec3d n) const { return Vec3((x - centre_) / unit_) + kOffset * Vec3(n); }
  const Mesh& mesh() const { return scene_->meshes[0]; }
  const Accelerator& accelerator() const { return *accelerator_; }
  /// The surface that a hit triangle belongs to; faces.size() and above: an occluder.
  size_t face_of(uint32_t triangle) const { return owners_[triangle]; }

 private:
  Point3d centre_{0};
  double unit_ = 1;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Accelerator> accelerator_;
  std::vector<uint32_t> owners_;
};

/// A method that sends rays among the faces.
class FaceRaysMethod : public FormFactorMethod {
 public:
  void build(const FormFactorScene& scene) override {
    faces_ = Faces(scene);
    rays_.build(faces_);
  }

 protected:
  Faces faces_;
  FaceRays rays_;
};

/// The point of a face at two numbers in [0, 1), uniform by area; stratified numbers give stratified points.
Point3d point_on(const Face& face, Vec2d u);

}  // namespace aktina
