#include <assimp/scene.h>

#include "aktina/base/error.h"
#include "aktina/import/assimp/parse.h"

namespace aktina::assimp {
namespace {

Vec3 vec(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// Memory that a mesh will take, here and then welded, about.
uint64_t memory(const aiMesh& mesh) {
  return uint64_t(mesh.mNumVertices) * 2 * (2 * sizeof(Vec3) + 2 * sizeof(Vec2) + sizeof(Vec4)) +
         uint64_t(mesh.mNumFaces) * 8 * sizeof(uint32_t);
}

void parse_attributes(const aiMesh& from, FileMesh& mesh) {
  const unsigned count = from.mNumVertices;
  for (unsigned i = 0; i < count; ++i) mesh.positions.push_back(vec(from.mVertices[i]));
  if (from.mNormals != nullptr)
    for (unsigned i = 0; i < count; ++i) mesh.normals.push_back(vec(from.mNormals[i]));
  for (const unsigned set : {0u, 1u})
    if (from.mTextureCoords[set] != nullptr)
      for (unsigned i = 0; i < count; ++i)
        mesh.uv[set].emplace_back(from.mTextureCoords[set][i].x, from.mTextureCoords[set][i].y);
  if (from.mColors[0] != nullptr)
    for (unsigned i = 0; i < count; ++i) {
      const aiColor4D c = from.mColors[0][i];
      mesh.colours.emplace_back(c.r, c.g, c.b, c.a);
    }
}

void parse_faces(const aiMesh& from, FileMesh& mesh, Counted& warnings) {
  for (unsigned f = 0; f < from.mNumFaces; ++f) {
    const aiFace& face = from.mFaces[f];
    if (face.mNumIndices < 3) {
      warnings.add("points and lines are not drawn");
      continue;
    }
    bool within = true;
    for (unsigned i = 0; i < face.mNumIndices; ++i) within &= face.mIndices[i] < from.mNumVertices;
    if (!within) {
      warnings.add("faces with vertex indices out of range were dropped");
      continue;
    }
    mesh.sizes.push_back(face.mNumIndices);
    mesh.corners.insert(mesh.corners.end(), face.mIndices, face.mIndices + face.mNumIndices);
  }
}

}  // namespace

void parse_meshes(const aiScene& scene, Document& document, uint64_t most_bytes) {
  uint64_t bytes = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) bytes += memory(*scene.mMeshes[i]);
  if (bytes > most_bytes) throw Error(Code::limit, "", "needs more memory than is allowed", "simplify the scene");
  Counted warnings(document);
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    const aiMesh& from = *scene.mMeshes[i];
    FileMesh& mesh = document.meshes.emplace_back();
    mesh.name = from.mName.C_Str();
    mesh.material = from.mMaterialIndex < document.materials.size() ? int32_t(from.mMaterialIndex) : -1;
    if (from.mVertices == nullptr) continue;
    parse_attributes(from, mesh);
    parse_faces(from, mesh, warnings);
  }
}

}  // namespace aktina::assimp
