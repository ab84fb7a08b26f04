// Materials, in the classic terms in which all three formats state them, and the pictures within the file.
#include <assimp/scene.h>

#include <algorithm>

#include "aktina/import/assimp/parse.h"
#include "aktina/texture/texture.h"

namespace aktina::assimp {
namespace {

class MaterialParser {
 public:
  MaterialParser(const aiScene& scene, Format format, Document& document)
      : scene_(scene), format_(format), warnings_(document) {}

  FileMaterial parse(const aiMaterial& from) {
    FileMaterial m;
    aiString name;
    if (from.Get(AI_MATKEY_NAME, name) == AI_SUCCESS) m.name = name.C_Str();
    read_colours(from, m);
    read_lobe(from, m);
    from.Get(AI_MATKEY_OPACITY, m.opacity);
    from.Get(AI_MATKEY_REFRACTI, m.index);
    int sides = 0;
    m.double_sided = from.Get(AI_MATKEY_TWOSIDED, sides) == AI_SUCCESS && sides != 0;
    m.diffuse = texture(from, aiTextureType_DIFFUSE);
    m.emissive = texture(from, aiTextureType_EMISSIVE);
    m.normal = texture(from, aiTextureType_NORMALS);
    m.alpha = texture(from, aiTextureType_OPACITY);
    for (const aiTextureType type : {aiTextureType_SPECULAR, aiTextureType_SHININESS, aiTextureType_HEIGHT,
                                     aiTextureType_AMBIENT, aiTextureType_REFLECTION, aiTextureType_DISPLACEMENT})
      warnings_.add("pictures of shininess, height, ambience and reflection were left out", from.GetTextureCount(type));
    return m;
  }

 private:
  static bool colour(const aiMaterial& from, const char* key, unsigned type, unsigned index, Vec3& to) {
    aiColor3D c;
    if (from.Get(key, type, index, c) != AI_SUCCESS) return false;
    to = {c.r, c.g, c.b};
    return true;
  }

  static void read_colours(const aiMaterial& from, FileMaterial& m) {
    colour(from, AI_MATKEY_COLOR_DIFFUSE, m.kd);
    if (!colour(from, AI_MATKEY_COLOR_AMBIENT, m.ka)) m.ka = m.kd;
    colour(from, AI_MATKEY_COLOR_EMISSIVE, m.emission);
    colour(from, AI_MATKEY_COLOR_SPECULAR, m.ks);
    float share = 1;
    if (from.Get(AI_MATKEY_SHININESS_STRENGTH, share) == AI_SUCCESS) m.ks *= share;
    share = 0;
    if (from.Get(AI_MATKEY_REFLECTIVITY, share) == AI_SUCCESS && colour(from, AI_MATKEY_COLOR_REFLECTIVE, m.kr))
      m.kr *= share;
    else
      m.kr = Vec3(0);
  }

  /// Blinn's exponent is four times Phong's for the same lobe; Lambert's model has no lobe. In 3DS a model is a way of
  /// interpolating.
  void read_lobe(const aiMaterial& from, FileMaterial& m) const {
    int model = aiShadingMode_Phong;
    from.Get(AI_MATKEY_SHADING_MODEL, model);
    from.Get(AI_MATKEY_SHININESS, m.exponent);
    if (model == aiShadingMode_Blinn) m.exponent /= 4;
    const bool lambert =
        model == aiShadingMode_Gouraud || model == aiShadingMode_Flat || model == aiShadingMode_NoShading;
    if (lambert && format_ != Format::max3ds) m.ks = Vec3(0);
  }

  static uint8_t wrap(int mode) {
    return uint8_t(mode == aiTextureMapMode_Mirror                                    ? Wrap::mirror
                   : mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal ? Wrap::clamp
                                                                                      : Wrap::repeat);
  }

  FileTexture texture(const aiMaterial& from, aiTextureType type) {
    FileTexture to;
    aiString file;
    if (from.GetTexture(type, 0, &file) != AI_SUCCESS) return to;
    to.file = file.C_Str();
    if (const auto [inside, index] = scene_.GetEmbeddedTextureAndIndex(to.file.c_str()); inside != nullptr)
      to.file = "*" + std::to_string(index);
    int number = 0;
    if (from.Get(AI_MATKEY_UVWSRC(type, 0), number) == AI_SUCCESS && number > 0) {
      to.uv_set = std::min(number, 1);
      if (number > 1) warnings_.add("pictures on a third set of texture coordinates use the second");
    }
    if (from.Get(AI_MATKEY_MAPPINGMODE_U(type, 0), number) == AI_SUCCESS) to.wrap_u = wrap(number);
    if (from.Get(AI_MATKEY_MAPPINGMODE_V(type, 0), number) == AI_SUCCESS) to.wrap_v = wrap(number);
    aiUVTransform place;
    if (from.Get(AI_MATKEY_UVTRANSFORM(type, 0), place) == AI_SUCCESS) {
      to.scale = {place.mScaling.x, place.mScaling.y};
      to.offset = {place.mTranslation.x, place.mTranslation.y};
      if (place.mRotation != 0) warnings_.add("turned textures were left unturned");
    }
    return to;
  }

  const aiScene& scene_;
  Format format_;
  Counted warnings_;
};

void parse_pictures(const aiScene& scene, Document& document) {
  for (unsigned i = 0; i < scene.mNumTextures; ++i) {
    const aiTexture& from = *scene.mTextures[i];
    FilePicture picture;
    picture.name = from.mFilename.C_Str();
    const auto* bytes = reinterpret_cast<const uint8_t*>(from.pcData);
    if (from.mHeight == 0 && bytes != nullptr) picture.bytes.assign(bytes, bytes + from.mWidth);
    document.pictures.push_back(std::move(picture));
  }
}

}  // namespace

void parse_materials(const aiScene& scene, Format format, Document& document) {
  MaterialParser parser(scene, format, document);
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) document.materials.push_back(parser.parse(*scene.mMaterials[i]));
  parse_pictures(scene, document);
}

}  // namespace aktina::assimp
