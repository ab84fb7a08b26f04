#include "aktina/import/assimp/parse.h"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>
#include <fmt/core.h>

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>

#include "aktina/base/error.h"

namespace aktina::assimp {
namespace {

constexpr size_t kMostNodes = 1'000'000;
constexpr size_t kMostUses = 10'000'000;  // of meshes by nodes

const char* extension(Format format) {
  return format == Format::fbx ? "fbx" : format == Format::collada ? "dae" : "3ds";
}

/// The one file that Assimp sees: the bytes at hand. Pictures are only named, and are found by us.
class OneFile final : public Assimp::IOSystem {
 public:
  OneFile(std::span<const uint8_t> bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}
  bool Exists(const char* file) const override { return name_ == file; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    const bool reads = std::strchr(mode, 'w') == nullptr && std::strchr(mode, 'a') == nullptr;
    return Exists(file) && reads ? new Assimp::MemoryIOStream(bytes_.data(), bytes_.size()) : nullptr;
  }
  void Close(Assimp::IOStream* file) override { delete file; }

 private:
  std::span<const uint8_t> bytes_;
  std::string name_;
};

/// Assimp guesses formats by content as well: no other reader may get the bytes.
void keep_only(Assimp::Importer& importer, const char* extension) {
  for (size_t i = importer.GetImporterCount(); i-- > 0;)
    if (std::strstr(importer.GetImporterInfo(i)->mFileExtensions, extension) == nullptr)
      importer.UnregisterLoader(importer.GetImporter(i));
}

Mat4 matrix(const aiMatrix4x4& m) {
  return {m.a1, m.b1, m.c1, 0, m.a2, m.b2, m.c2, 0, m.a3, m.b3, m.c3, 0, m.a4, m.b4, m.c4, 1};
}

/// Nodes, parents before children, and the meshes that they show.
void parse_nodes(const aiScene& scene, Document& document) {
  std::vector<std::pair<const aiNode*, int32_t>> left = {{scene.mRootNode, -1}};
  while (!left.empty()) {
    const auto [node, parent] = left.back();
    left.pop_back();
    if (node == nullptr) continue;
    const auto index = int32_t(document.nodes.size());
    document.nodes.push_back({node->mName.C_Str(), parent, matrix(node->mTransformation)});
    for (unsigned i = 0; i < node->mNumMeshes; ++i)
      if (node->mMeshes[i] < scene.mNumMeshes) document.uses.push_back({index, int32_t(node->mMeshes[i])});
    if (document.nodes.size() > kMostNodes || document.uses.size() > kMostUses)
      throw Error(Code::limit, "", "has more nodes than are read", "simplify the scene");
    for (unsigned i = node->mNumChildren; i-- > 0;) left.emplace_back(node->mChildren[i], index);
  }
}

/// One of FBX's axes as a vector: 0, 1, 2 for x, y, z, and a sign.
Vec3 axis(const aiMetadata& data, const std::string& name, int fallback, int fallback_sign) {
  int32_t which = fallback, sign = fallback_sign;
  data.Get(name, which), data.Get(name + "Sign", sign);
  Vec3 v(0);
  v[std::clamp(which, 0, 2)] = sign < 0 ? -1 : 1;
  return v;
}

/// The number that was written, of one that has been in single precision: 2.54, not 2.53999996.
double as_written(double value) { return std::stod(fmt::format("{:.7g}", value)); }

/// FBX says its unit in centimetres and which axes are up, towards the viewer and to the right.
void place_fbx(const aiScene& scene, Document& document) {
  if (scene.mMetaData == nullptr) return;
  const aiMetadata& data = *scene.mMetaData;
  double centimetres = 1;
  float single = 0;
  if (!data.Get("UnitScaleFactor", centimetres) && data.Get("UnitScaleFactor", single)) centimetres = double(single);
  if (!(centimetres > 1e-9 && centimetres < 1e9)) {
    Counted(document).add("a unit that is not a length was taken as a centimetre");
    centimetres = 1;
  }
  document.metres_per_unit = as_written(centimetres) / 100;
  const Vec3 up = axis(data, "UpAxis", 1, 1);
  Vec3 right = axis(data, "CoordAxis", 0, 1), front = axis(data, "FrontAxis", 2, 1);
  if (cross(right, up) != front) {
    Counted(document).add("axes that do not fit together: only the one that is up was followed");
    right = up.x != 0 ? Vec3(0, -up.x, 0) : Vec3(1, 0, 0);
    front = cross(right, up);
  }
  const auto s = float(document.metres_per_unit);
  const Mat4 place = glm::transpose(Mat4(Vec4(right * s, 0), Vec4(up * s, 0), Vec4(front * s, 0), Vec4(0, 0, 0, 1)));
  document.nodes[0].local = place * document.nodes[0].local;
}

/// Assimp has put COLLADA's unit and axes, and the axes of 3DS, into the root's matrix.
void place(const aiScene& scene, Format format, Document& document) {
  if (document.nodes.empty()) throw Error(Code::bad_input, "", "holds no scene");
  if (format == Format::fbx) return place_fbx(scene, document);
  const double unit = double(length(Vec3(document.nodes[0].local[0])));
  if (format == Format::collada && unit > 1e-9 && unit < 1e9) document.metres_per_unit = as_written(unit);
}

void say_what_is_left_out(const aiScene& scene, std::span<const uint8_t> bytes, Format format, Document& document) {
  Counted warnings(document);
  if (scene.mNumAnimations > 0) warnings.add("animations were left out", scene.mNumAnimations);
  uint64_t boned = 0, morphed = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i)
    boned += scene.mMeshes[i]->mNumBones > 0, morphed += scene.mMeshes[i]->mNumAnimMeshes > 0;
  warnings.add("meshes with bones stand in their rest pose", boned);
  warnings.add("morph targets were left out", morphed);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (format == Format::collada && text.find("<orthographic>") != text.npos)
    warnings.add("orthographic cameras of COLLADA are read as perspective ones");
}

}  // namespace

void Counted::add(const std::string& text, uint64_t count) {
  if (count == 0) return;
  for (FileWarning& warning : document_.warnings)
    if (warning.text == text) return void(warning.count += count);
  document_.warnings.push_back({text, count});
}

Document parse(std::span<const uint8_t> bytes, Format format, uint64_t most_bytes) {
  const std::string name = std::string("scene.") + extension(format);
  Assimp::Importer importer;
  keep_only(importer, extension(format));
  importer.SetIOHandler(new OneFile(bytes, name));
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  const aiScene* scene = importer.ReadFile(name, 0);
  if (scene == nullptr || scene->mRootNode == nullptr)
    throw Error(Code::bad_input, "", one_line(importer.GetErrorString()), "the file is damaged");
  Document document;
  if (scene->mMetaData != nullptr) {
    aiString generator;
    if (scene->mMetaData->Get("SourceAsset_Generator", generator)) document.generator = generator.C_Str();
  }
  parse_nodes(*scene, document);
  place(*scene, format, document);
  parse_materials(*scene, format, document);
  parse_meshes(*scene, document, most_bytes);
  parse_lights_and_cameras(*scene, format, document);
  say_what_is_left_out(*scene, bytes, format, document);
  return document;
}

}  // namespace aktina::assimp
