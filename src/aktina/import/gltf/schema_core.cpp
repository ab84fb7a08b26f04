// The objects of glTF 2.0 itself (Khronos Group, "glTF 2.0 Specification", 2021, section 5).
#include "aktina/import/gltf/schema_rows.h"

namespace aktina::gltf {
namespace rows {
namespace {

constexpr Property kAssetRows[] = {required(text("version")), text("minVersion"), text("generator"), text("copyright")};
constexpr Shape kAsset{"asset", kAssetRows};

constexpr Property kBufferRows[] = {required(whole("byteLength", 1)), text("uri"), text("name")};
constexpr Shape kBuffer{"buffer", kBufferRows};

constexpr Property kBufferViewRows[] = {required(reference("buffer", "/buffers")), whole("byteOffset"),
                                        required(whole("byteLength", 1)), whole("byteStride", 4, 252), whole("target")};
constexpr Shape kBufferView{"bufferView", kBufferViewRows};

constexpr Property kSparseIndexRows[] = {required(reference("bufferView", "/bufferViews")), whole("byteOffset"),
                                         required(whole("componentType"))};
constexpr Shape kSparseIndices{"sparse indices", kSparseIndexRows};
constexpr Property kSparseValueRows[] = {required(reference("bufferView", "/bufferViews")), whole("byteOffset")};
constexpr Shape kSparseValues{"sparse values", kSparseValueRows};
constexpr Property kSparseRows[] = {required(whole("count", 1)), required(object("indices", kSparseIndices)),
                                    required(object("values", kSparseValues))};
constexpr Shape kSparse{"sparse", kSparseRows};
constexpr Property many(std::string_view name) { return {name, Kind::numbers, -1e300, 1e300, 1, 16}; }
constexpr Property kAccessorRows[] = {reference("bufferView", "/bufferViews"),
                                      whole("byteOffset"),
                                      required(whole("componentType")),
                                      flag("normalized"),
                                      required(whole("count", 1)),
                                      required(text("type")),
                                      many("max"),
                                      many("min"),
                                      object("sparse", kSparse)};
constexpr Shape kAccessor{"accessor", kAccessorRows};

constexpr Property kImageRows[] = {text("uri"), text("mimeType"), reference("bufferView", "/bufferViews"),
                                   text("name")};
constexpr Shape kImage{"image", kImageRows};
constexpr Property kSamplerRows[] = {whole("magFilter"), whole("minFilter"), whole("wrapS"), whole("wrapT")};
constexpr Shape kSampler{"sampler", kSamplerRows};
constexpr Property kTextureRows[] = {reference("sampler", "/samplers"), reference("source", "/images"), text("name")};
constexpr Shape kTexture{"texture", kTextureRows};

constexpr Property kInfoRows[] = {required(reference("index", "/textures")), whole("texCoord"), number("scale"),
                                  number("strength", 0, 1)};
constexpr Property kPbrRows[] = {numbers("baseColorFactor", 4, 0, 1), object("baseColorTexture", kTextureInfo),
                                 number("metallicFactor", 0, 1), number("roughnessFactor", 0, 1),
                                 object("metallicRoughnessTexture", kTextureInfo)};
constexpr Shape kPbr{"pbrMetallicRoughness", kPbrRows};
constexpr Property kMaterialRows[] = {text("name"),
                                      object("pbrMetallicRoughness", kPbr),
                                      object("normalTexture", kTextureInfo),
                                      object("occlusionTexture", kTextureInfo),
                                      object("emissiveTexture", kTextureInfo),
                                      numbers("emissiveFactor", 3, 0, 1),
                                      text("alphaMode"),
                                      number("alphaCutoff", 0),
                                      flag("doubleSided")};
constexpr Shape kMaterial{"material", kMaterialRows};

constexpr Property kPrimitiveRows[] = {required(map("attributes", "/accessors")), reference("indices", "/accessors"),
                                       reference("material", "/materials"), whole("mode", 0, 6),
                                       maps("targets", "/accessors")};
constexpr Shape kPrimitive{"primitive", kPrimitiveRows};
constexpr Property kMeshRows[] = {
    required(objects("primitives", kPrimitive)), {"weights", Kind::numbers}, text("name")};
constexpr Shape kMesh{"mesh", kMeshRows};

constexpr Property kPerspectiveRows[] = {required(number("yfov", kTiny)), number("aspectRatio", kTiny),
                                         required(number("znear", kTiny)), number("zfar", kTiny)};
constexpr Shape kPerspective{"perspective", kPerspectiveRows};
constexpr Property kOrthographicRows[] = {required(number("xmag")), required(number("ymag")),
                                          required(number("znear", 0)), required(number("zfar", kTiny))};
constexpr Shape kOrthographic{"orthographic", kOrthographicRows};
constexpr Property kCameraRows[] = {required(text("type")), object("perspective", kPerspective),
                                    object("orthographic", kOrthographic), text("name")};
constexpr Shape kCamera{"camera", kCameraRows};

constexpr Property kNodeRows[] = {text("name"),
                                  reference("camera", "/cameras"),
                                  references("children", "/nodes"),
                                  reference("skin", "/skins"),
                                  numbers("matrix", 16),
                                  reference("mesh", "/meshes"),
                                  numbers("rotation", 4, -1, 1),
                                  numbers("scale", 3),
                                  numbers("translation", 3),
                                  {"weights", Kind::numbers}};
constexpr Shape kNode{"node", kNodeRows};
constexpr Property kSceneRows[] = {references("nodes", "/nodes"), text("name")};
constexpr Shape kScene{"scene", kSceneRows};

constexpr Property kSkinRows[] = {reference("inverseBindMatrices", "/accessors"), reference("skeleton", "/nodes"),
                                  required(references("joints", "/nodes")), text("name")};
constexpr Shape kSkin{"skin", kSkinRows, false};
constexpr Property kTargetRows[] = {reference("node", "/nodes"), required(text("path"))};
constexpr Shape kTarget{"target", kTargetRows, false};
constexpr Property kChannelRows[] = {required(whole("sampler")), required(object("target", kTarget))};
constexpr Shape kChannel{"channel", kChannelRows, false};
constexpr Property kAnimationSamplerRows[] = {required(reference("input", "/accessors")),
                                              required(reference("output", "/accessors")), text("interpolation")};
constexpr Shape kAnimationSampler{"animation sampler", kAnimationSamplerRows, false};
constexpr Property kAnimationRows[] = {required(objects("channels", kChannel)),
                                       required(objects("samplers", kAnimationSampler)), text("name")};
constexpr Shape kAnimation{"animation", kAnimationRows, false};

constexpr Property kRootRows[] = {
    required(object("asset", kAsset)), objects("buffers", kBuffer),       objects("bufferViews", kBufferView),
    objects("accessors", kAccessor),   objects("images", kImage),         objects("samplers", kSampler),
    objects("textures", kTexture),     objects("materials", kMaterial),   objects("meshes", kMesh),
    objects("cameras", kCamera),       objects("skins", kSkin),           objects("nodes", kNode),
    objects("scenes", kScene),         objects("animations", kAnimation), reference("scene", "/scenes")};

}  // namespace

constexpr Shape kTextureInfo{"textureInfo", kInfoRows};

}  // namespace rows

constexpr Shape kRootShape{"glTF", rows::kRootRows};

}  // namespace aktina::gltf
