// EXT_lights_ies: lights with a measured distribution, placed by the nodes that name them.
#include <map>

#include "aktina/import/gltf/nodes.h"
#include "aktina/import/luminaire/luminaire.h"

namespace aktina::gltf {
namespace {

constexpr size_t kMostFaults = 100;  // broken profiles in one file

class LuminaireReader {
 public:
  explicit LuminaireReader(Document& document)
      : document_(document), list_(document.root().extension("EXT_lights_ies")["lights"]) {}

  void read(const Value& node, int index, Scene& scene) {
    const Value use = node.extension("EXT_lights_ies");
    const int number = use["light"].index(list_.size());
    if (number < 0) return;
    const Profile& profile = profile_of(size_t(number));
    if (!profile.table) return;
    const Mat4 placed = rigid(scene.nodes[size_t(index)].to_world);
    LuminaireLight light;
    light.position = Vec3(placed[3]), light.direction = -Vec3(placed[2]), light.c0 = Vec3(placed[0]);
    light.colour = use["color"].rgb(Rgb(1)) * use["multiplier"].real(1);
    if (!is_finite(light.colour) || min_channel(light.colour) < 0)
      use.fail("color and multiplier should not be below 0");
    light.colour *= tilt_factor(profile.tilt, light.direction);
    light.table = profile.table;
    scene.lights.push_back({list_[size_t(number)]["name"].text(scene.nodes[size_t(index)].name), light, index});
  }

 private:
  std::vector<uint8_t> bytes_of(const Value& place) {
    if (place["uri"]) return fetch(document_, place["uri"]);
    const int view = place["bufferView"].index(document_.list("bufferViews").size());
    if (view < 0) place.fail("has neither a uri nor a bufferView");
    const auto bytes = document_.view(size_t(view));
    return {bytes.begin(), bytes.end()};
  }

  struct Profile {
    std::shared_ptr<const PhotometricTable> table;  // none where it is missing or broken
    LampTilt tilt;
  };

  /// Nodes that share a profile share its table.
  const Profile& profile_of(size_t number) {
    const auto [at, fresh] = profiles_.try_emplace(number);
    if (!fresh) return at->second;
    const Value place = list_[number];
    const std::string where = document_.root().place() + " /extensions/EXT_lights_ies/lights/" + std::to_string(number);
    try {
      Luminaire luminaire = read_ies(bytes_of(place), document_.folder, where);
      document_.warnings.add(luminaire.warnings);
      at->second = {luminaire.table, std::move(luminaire.tilt)};
    } catch (const Error& error) {
      if (error.code() == Code::limit) throw;
      if (++faults_ > kMostFaults) throw;
      document_.warnings.add("lights whose IES profile is missing or broken were left out");
    }
    return at->second;
  }

  Document& document_;
  Value list_;
  size_t faults_ = 0;
  std::map<size_t, Profile> profiles_;
};

}  // namespace

void read_luminaires(Document& document, const Hierarchy& hierarchy, Scene& scene) {
  const Value nodes = document.list("nodes");
  LuminaireReader reader(document);
  for (size_t i = 0; i < scene.nodes.size(); ++i) reader.read(nodes[size_t(hierarchy.source[i])], int(i), scene);
}

}  // namespace aktina::gltf
