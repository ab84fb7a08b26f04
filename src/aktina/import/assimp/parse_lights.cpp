// Lights and cameras. Assimp ties them to nodes by name, and hands each format's numbers on in its own way.
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "aktina/import/assimp/parse.h"

namespace aktina::assimp {
namespace {

Vec3 vec(const aiVector3D& v) { return {v.x, v.y, v.z}; }
Vec3 vec(const aiColor3D& c) { return {c.r, c.g, c.b}; }

/// Names -> nodes, the first of each; the root, which holds units and axes, where there is no such node.
class NodeNames {
 public:
  explicit NodeNames(Document& document) : warnings_(document) {
    for (size_t i = 0; i < document.nodes.size(); ++i) {
      const auto [at, fresh] = first_.try_emplace(document.nodes[i].name, int32_t(i));
      if (!fresh) shared_[at->first] = true;
    }
  }
  int32_t find(const std::string& name, const char* what) {
    const auto at = first_.find(name);
    if (at == first_.end()) return 0;
    if (shared_.count(name) > 0)
      warnings_.add(std::string(what) + " at nodes of the same name stand at the first of these nodes");
    return at->second;
  }

 private:
  Counted warnings_;
  std::map<std::string, int32_t> first_;
  std::map<std::string, bool> shared_;
};

/// 3DS: hotspot and fall-off are whole angles, of which Assimp adds the second to the first; FBX: whole angles.
void cone_of_two_angles(const aiLight& from, Format format, FileLight& light) {
  light.inner_angle = from.mAngleInnerCone / 2;
  light.outer_angle = from.mAngleOuterCone / 2 - (format == Format::max3ds ? light.inner_angle : 0);
}

/// COLLADA: a whole angle and an exponent e, from which Assimp makes a second angle, acos(0.1^(1/e)) wider, e at
/// least 1.
void cone_of_exponent(const aiLight& from, FileLight& light) {
  light.inner_angle = light.outer_angle = from.mAngleInnerCone / 2;
  const float wider = std::cos(from.mAngleOuterCone - from.mAngleInnerCone);
  const float exponent = std::log(0.1f) / std::log(std::clamp(wider, 0.1f, 0.9999f));
  light.exponent = exponent > 1.01f ? exponent : 0;
}

/// COLLADA's factors stand as they are; Assimp doubles FBX's, and invents those of 3DS.
Vec3 attenuation(const aiLight& from, Format format) {
  if (format == Format::max3ds) return {1, 0, 0};
  const Vec3 a(from.mAttenuationConstant, from.mAttenuationLinear, from.mAttenuationQuadratic);
  if (format == Format::collada) return a;
  return a.z > 0 ? Vec3(0, 0, a.z / 2) : a.y > 0 ? Vec3(0, a.y / 2, 0) : Vec3(1, 0, 0);
}

void parse_light(const aiLight& from, Format format, NodeNames& names, Document& document) {
  FileLight light;
  switch (from.mType) {
    case aiLightSource_POINT:
      light.kind = FileLight::point;
      break;
    case aiLightSource_SPOT:
      light.kind = FileLight::spot;
      break;
    case aiLightSource_DIRECTIONAL:
      light.kind = FileLight::directional;
      break;
    case aiLightSource_AMBIENT:
      light.kind = FileLight::ambient;
      break;
    default:
      Counted(document).add("area and volume lights were left out");
      return;
  }
  light.name = from.mName.C_Str();
  light.node = names.find(light.name, "lights");
  light.position = vec(from.mPosition), light.direction = vec(from.mDirection);
  light.colour = vec(light.kind == FileLight::ambient ? from.mColorAmbient : from.mColorDiffuse);
  light.attenuation = attenuation(from, format);
  if (light.kind == FileLight::spot && format == Format::collada)
    cone_of_exponent(from, light);
  else if (light.kind == FileLight::spot)
    cone_of_two_angles(from, format, light);
  document.lights.push_back(light);
}

void parse_camera(const aiCamera& from, Format format, NodeNames& names, Document& document) {
  FileCamera camera;
  camera.name = from.mName.C_Str();
  camera.node = names.find(camera.name, "cameras");
  camera.position = vec(from.mPosition), camera.forward = vec(from.mLookAt), camera.up = vec(from.mUp);
  camera.width_angle = from.mHorizontalFOV, camera.aspect = from.mAspect;
  camera.half_width = from.mOrthographicWidth;
  camera.near = from.mClipPlaneNear, camera.far = from.mClipPlaneFar;
  if (format == Format::max3ds) {
    // The file holds a lens in mm, which Assimp takes for degrees; 3D Studio's angle is 2400 / lens degrees. +z is up.
    const double lens = double(from.mHorizontalFOV) * 180 / kPi;
    camera.width_angle = float(std::clamp(2400 / std::max(lens, 1.0), 1.0, 170.0) * kPi / 180);
    camera.up = {0, 0, 1};
    camera.aspect = 4.0f / 3;
  }
  document.cameras.push_back(camera);
}

}  // namespace

void parse_lights_and_cameras(const aiScene& scene, Format format, Document& document) {
  NodeNames names(document);
  for (unsigned i = 0; i < scene.mNumLights; ++i) parse_light(*scene.mLights[i], format, names, document);
  for (unsigned i = 0; i < scene.mNumCameras; ++i) parse_camera(*scene.mCameras[i], format, names, document);
}

}  // namespace aktina::assimp
