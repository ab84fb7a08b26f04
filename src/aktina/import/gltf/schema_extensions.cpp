// Extensions: where each may stand and what it holds. Those that Aktina does not read are described so that their
// faults are told.
#include "aktina/import/gltf/schema_rows.h"

namespace aktina::gltf {
namespace rows {
namespace {

constexpr std::string_view kLights = "/extensions/KHR_lights_punctual/lights";
constexpr std::string_view kVariants = "/extensions/KHR_materials_variants/variants";
constexpr double kHalfTurn = 1.5707964;  // pi / 2, rounded up to a float

constexpr Property kSpotRows[] = {number("innerConeAngle", 0, kHalfTurn), number("outerConeAngle", kTiny, kHalfTurn)};
constexpr Shape kSpot{"spot", kSpotRows};
constexpr Property kLightRows[] = {required(text("type")), numbers("color", 3, 0, 1), number("intensity", 0),
                                   number("range", kTiny), object("spot", kSpot),     text("name")};
constexpr Shape kLight{"light", kLightRows};
constexpr Property kLightListRows[] = {required(objects("lights", kLight))};
constexpr Shape kLightList{"KHR_lights_punctual", kLightListRows};
constexpr Property kLightUseRows[] = {required(reference("light", kLights))};
constexpr Shape kLightUse{"KHR_lights_punctual", kLightUseRows};

constexpr Property kProfileRows[] = {text("name"), text("uri"), text("mimeType"),
                                     reference("bufferView", "/bufferViews")};
constexpr Shape kProfile{"light profile", kProfileRows};
constexpr Property kProfileListRows[] = {required(objects("lights", kProfile))};
constexpr Shape kProfileList{"EXT_lights_ies", kProfileListRows};
constexpr Property kProfileUseRows[] = {required(reference("light", "/extensions/EXT_lights_ies/lights")),
                                        number("multiplier", 0), numbers("color", 3, 0, 1)};
constexpr Shape kProfileUse{"EXT_lights_ies", kProfileUseRows};

constexpr Property kStrengthRows[] = {number("emissiveStrength", 0)};
constexpr Shape kStrength{"KHR_materials_emissive_strength", kStrengthRows};
constexpr Property kIorRows[] = {number("ior")};  // 0, or from 1: see read_material
constexpr Shape kIor{"KHR_materials_ior", kIorRows};
constexpr Property kTransmissionRows[] = {number("transmissionFactor", 0, 1),
                                          object("transmissionTexture", kTextureInfo)};
constexpr Shape kTransmission{"KHR_materials_transmission", kTransmissionRows};
constexpr Property kSpecularRows[] = {number("specularFactor", 0, 1), object("specularTexture", kTextureInfo),
                                      numbers("specularColorFactor", 3, 0),
                                      object("specularColorTexture", kTextureInfo)};
constexpr Shape kSpecular{"KHR_materials_specular", kSpecularRows};
constexpr Shape kUnlit{"KHR_materials_unlit", {}};
constexpr Property kTransformRows[] = {numbers("offset", 2), number("rotation"), numbers("scale", 2),
                                       whole("texCoord")};
constexpr Shape kTransform{"KHR_texture_transform", kTransformRows};
constexpr Property kWebpRows[] = {reference("source", "/images")};
constexpr Shape kWebp{"EXT_texture_webp", kWebpRows};
constexpr Property kGlossinessRows[] = {numbers("diffuseFactor", 4, 0, 1), object("diffuseTexture", kTextureInfo),
                                        numbers("specularFactor", 3, 0, 1), number("glossinessFactor", 0, 1),
                                        object("specularGlossinessTexture", kTextureInfo)};
constexpr Shape kGlossiness{"KHR_materials_pbrSpecularGlossiness", kGlossinessRows};
constexpr Property kVisibilityRows[] = {flag("visible")};
constexpr Shape kVisibility{"KHR_node_visibility", kVisibilityRows};

constexpr Property kDracoRows[] = {required(reference("bufferView", "/bufferViews")),
                                   required({"attributes", Kind::extension})};
constexpr Shape kDraco{"KHR_draco_mesh_compression", kDracoRows};
constexpr Property kMeshoptRows[] = {required(reference("buffer", "/buffers")),
                                     whole("byteOffset"),
                                     required(whole("byteLength", 1)),
                                     required(whole("byteStride", 1, 256)),
                                     required(whole("count", 1)),
                                     required(text("mode")),
                                     text("filter")};
constexpr Shape kMeshopt{"EXT_meshopt_compression", kMeshoptRows};
constexpr Property kInstancingRows[] = {required(map("attributes", "/accessors"))};
constexpr Shape kInstancing{"EXT_mesh_gpu_instancing", kInstancingRows};

// Not read: what they add is left out.
constexpr Property kVariantRows[] = {required(text("name"))};
constexpr Shape kVariant{"variant", kVariantRows, false};
constexpr Property kVariantListRows[] = {required(objects("variants", kVariant))};
constexpr Shape kVariantList{"KHR_materials_variants", kVariantListRows, false};
constexpr Property kMappingRows[] = {required(references("variants", kVariants)),
                                     required(reference("material", "/materials")), text("name")};
constexpr Shape kMapping{"mapping", kMappingRows, false};
constexpr Property kMappingListRows[] = {required(objects("mappings", kMapping))};
constexpr Shape kMappingList{"KHR_materials_variants", kMappingListRows, false};
constexpr Property kClearcoatRows[] = {
    number("clearcoatFactor", 0, 1), object("clearcoatTexture", kTextureInfo), number("clearcoatRoughnessFactor", 0, 1),
    object("clearcoatRoughnessTexture", kTextureInfo), object("clearcoatNormalTexture", kTextureInfo)};
constexpr Shape kClearcoat{"KHR_materials_clearcoat", kClearcoatRows, false};
constexpr Property kSheenRows[] = {numbers("sheenColorFactor", 3, 0, 1), object("sheenColorTexture", kTextureInfo),
                                   number("sheenRoughnessFactor", 0, 1), object("sheenRoughnessTexture", kTextureInfo)};
constexpr Shape kSheen{"KHR_materials_sheen", kSheenRows, false};
constexpr Property kVolumeRows[] = {number("thicknessFactor", 0), object("thicknessTexture", kTextureInfo),
                                    number("attenuationDistance", kTiny), numbers("attenuationColor", 3, 0, 1)};
constexpr Shape kVolume{"KHR_materials_volume", kVolumeRows, false};
constexpr Property kIridescenceRows[] = {number("iridescenceFactor", 0, 1),
                                         object("iridescenceTexture", kTextureInfo),
                                         number("iridescenceIor", 1),
                                         number("iridescenceThicknessMinimum", 0),
                                         number("iridescenceThicknessMaximum", 0),
                                         object("iridescenceThicknessTexture", kTextureInfo)};
constexpr Shape kIridescence{"KHR_materials_iridescence", kIridescenceRows, false};
constexpr Property kAnisotropyRows[] = {number("anisotropyStrength", 0, 1), number("anisotropyRotation"),
                                        object("anisotropyTexture", kTextureInfo)};
constexpr Shape kAnisotropy{"KHR_materials_anisotropy", kAnisotropyRows, false};
constexpr Property kDispersionRows[] = {number("dispersion", 0)};
constexpr Shape kDispersion{"KHR_materials_dispersion", kDispersionRows, false};
constexpr Property kPointerRows[] = {required(text("pointer"))};
constexpr Shape kPointer{"KHR_animation_pointer", kPointerRows, false};

constexpr ExtensionShape kExtensions[] = {
    {"KHR_lights_punctual", "glTF", &kLightList},
    {"KHR_lights_punctual", "node", &kLightUse},
    {"EXT_lights_ies", "glTF", &kProfileList},
    {"EXT_lights_ies", "node", &kProfileUse},
    {"KHR_materials_emissive_strength", "material", &kStrength},
    {"KHR_materials_ior", "material", &kIor},
    {"KHR_materials_transmission", "material", &kTransmission},
    {"KHR_materials_specular", "material", &kSpecular},
    {"KHR_materials_unlit", "material", &kUnlit},
    {"KHR_texture_transform", "textureInfo", &kTransform},
    {"EXT_texture_webp", "texture", &kWebp},
    {"KHR_draco_mesh_compression", "primitive", &kDraco},
    {"EXT_meshopt_compression", "bufferView", &kMeshopt},
    {"EXT_meshopt_compression", "buffer"},
    {"EXT_mesh_gpu_instancing", "node", &kInstancing},
    {"KHR_materials_pbrSpecularGlossiness", "material", &kGlossiness},
    {"KHR_node_visibility", "node", &kVisibility},
    {"KHR_materials_variants", "glTF", &kVariantList},
    {"KHR_materials_variants", "primitive", &kMappingList},
    {"KHR_materials_clearcoat", "material", &kClearcoat},
    {"KHR_materials_sheen", "material", &kSheen},
    {"KHR_materials_volume", "material", &kVolume},
    {"KHR_materials_iridescence", "material", &kIridescence},
    {"KHR_materials_anisotropy", "material", &kAnisotropy},
    {"KHR_materials_dispersion", "material", &kDispersion},
    {"KHR_animation_pointer", "target", &kPointer},
};

}  // namespace
}  // namespace rows

std::span<const ExtensionShape> extension_shapes() { return rows::kExtensions; }

}  // namespace aktina::gltf
