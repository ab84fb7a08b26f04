#include "aktina/import/gltf/check_data.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "aktina/import/gltf/accessors.h"

namespace aktina::gltf {
namespace {

constexpr uint64_t kBlock = 1 << 14;  // elements looked at in one piece
constexpr size_t kMostFaults = 1000;  // after which unused parts are not looked at further: naming a place takes time
constexpr uint64_t kMostValues = uint64_t(1) << 28;  // that are looked at: accessors may overlap without end

class DataChecker {
 public:
  explicit DataChecker(Document& document)
      : document_(document), accessors_(document.list("accessors")), indexing_(accessors_.size(), false) {}

  void run() {
    const Value views = document_.list("bufferViews"), meshes = document_.list("meshes");
    const Value buffers = document_.list("buffers");
    for (size_t i = 0; i < buffers.size(); ++i) check_buffer(i, buffers[i]);
    for (size_t i = 0; i < views.size(); ++i) check_view(views[i]);
    for (size_t i = 0; i < accessors_.size(); ++i) guarded(&DataChecker::check_accessor, accessors_[i]);
    for (size_t i = 0; i < meshes.size(); ++i) {
      const Value primitives = meshes[i]["primitives"];
      for (size_t k = 0; k < primitives.size(); ++k) check_primitive(meshes[i], primitives[k]);
    }
    for (size_t i = 0; i < accessors_.size(); ++i)
      if (indexing_[i]) guarded(&DataChecker::check_indices, accessors_[i]);
    check_punctual_lights();
    const Value root = document_.root();
    warn(root["animations"].size() > 0, "animations are left out: nodes stand where the file puts them");
    warn(root["skins"].size() > 0, "skins are left out: meshes stand in their rest pose");
  }

 private:
  void warn(bool wrong, const char* text) {
    if (wrong) document_.warnings.add(text);
  }

  void guarded(void (DataChecker::*check)(const Value&), const Value& place) {
    if (faults_ > kMostFaults) return;
    try {
      (this->*check)(place);
    } catch (const Error&) {
      ++faults_;
      document_.warnings.add("accessors that nothing shown needs cannot be read");
    }
  }

  /// Fallbacks of compressed buffers have no data.
  void check_buffer(size_t index, const Value& buffer) {
    if (buffer.extension("EXT_meshopt_compression")) return;
    if (faults_ > kMostFaults) return;
    try {
      document_.buffer(index);
    } catch (const Error&) {
      ++faults_;
      document_.warnings.add("buffers that nothing shown needs cannot be read");
    }
  }

  void check_view(const Value& view) {
    const Value buffer = document_.list("buffers")[size_t(view["buffer"].whole(0))];
    const uint64_t have = buffer["byteLength"].whole(0), offset = view["byteOffset"].whole(0);
    const uint64_t length = view["byteLength"].whole(0), stride = view["byteStride"].whole(0);
    warn(offset > have || length > have - offset, "buffer views reach beyond their buffer");
    warn(stride > length, "buffer views have a stride longer than themselves");
  }

  void check_accessor(const Value& place) {
    const uint64_t component = place["componentType"].whole(0);
    const uint64_t size = component <= 5121 ? 1 : component <= 5123 ? 2 : 4;
    const Value view =
        place["bufferView"] ? document_.list("bufferViews")[size_t(place["bufferView"].whole(0))] : place;
    const uint64_t offset = place["byteOffset"].whole(0), base = place["bufferView"] ? view["byteOffset"].whole(0) : 0;
    warn(offset % size || (base + offset) % size,
         "accessors that are not aligned to their numbers were read as they are");
    if (place["sparse"]) read_floats(document_, open_accessor(document_, place), 0, 0);
    check_bounds(place);
  }

  /// Whether min and max are those of the values. Buffers that are not in memory by now belong to nothing shown.
  void check_bounds(const Value& place) {
    const size_t width = place["min"].size() ? place["min"].size() : place["max"].size();
    const Accessor accessor = open_accessor(document_, place);
    if (width == 0) return;
    warn(width != size_t(accessor.width), "accessors have min or max of another length than their elements");
    if (width != size_t(accessor.width) || accessor.normalized || accessor.bytes.empty() || place["sparse"]) return;
    if (!afford(accessor.count * width)) return;
    std::array<float, 16> low, high;
    low.fill(kInfinity), high.fill(-kInfinity);
    bool finite = true;
    for (uint64_t first = 0; first < accessor.count; first += kBlock) {
      const std::vector<float> values =
          read_floats(document_, accessor, first, std::min(kBlock, accessor.count - first));
      for (size_t i = 0; i < values.size(); ++i) {
        low[i % width] = std::min(low[i % width], values[i]), high[i % width] = std::max(high[i % width], values[i]);
        finite = finite && std::isfinite(values[i]);
      }
    }
    warn(!finite, "accessors hold numbers that are not finite");
    warn(differs(place["min"], low) || differs(place["max"], high),
         "accessors have min or max that their values do not have");
  }

  static bool differs(const Value& claimed, const std::array<float, 16>& found) {
    for (size_t i = 0; i < claimed.size(); ++i)
      if (std::abs(claimed[i].number(0) - double(found[i])) > 1e-5 * std::max(1.0, std::abs(double(found[i]))))
        return true;
    return false;
  }

  void check_primitive(const Value& mesh, const Value& primitive) {
    const Value attributes = primitive["attributes"];
    check_names(attributes);
    warn(count_named(attributes, "JOINTS_") != count_named(attributes, "WEIGHTS_"),
         "skins have joints without weights, or weights without joints");
    const Value position = attributes["POSITION"];
    warn(position && !bounds_of(position), "POSITION accessors have no min and max");
    if (primitive["indices"]) indexing_[size_t(primitive["indices"].whole(0))] = true;
    const Value targets = primitive["targets"];
    warn(targets.size() > 0, "shapes to morph into are left out: the mesh stands as it is without them");
    warn(mesh["weights"].size() > 0 && mesh["weights"].size() != targets.size(),
         "morph targets and weights differ in number");
    for (size_t i = 0; i < targets.size(); ++i) {
      check_names(targets[i]);
      for (const std::string& name : targets[i].names())
        warn(!attributes[name.c_str()], "morph targets change attributes that the mesh does not have");
    }
  }

  static size_t count_named(const Value& attributes, std::string_view stem) {
    size_t count = 0;
    for (const std::string& name : attributes.names()) count += name.starts_with(stem) ? 1 : 0;
    return count;
  }

  void check_names(const Value& attributes) {
    for (const std::string& name : attributes.names()) {
      const std::string stem = name.substr(0, name.find_last_not_of("0123456789") + 1);
      const bool known =
          name == "POSITION" || name == "NORMAL" || name == "TANGENT" || name.starts_with("_") ||
          ((stem == "TEXCOORD_" || stem == "COLOR_" || stem == "JOINTS_" || stem == "WEIGHTS_") && stem != name);
      warn(!known, "vertex attributes have names that glTF does not know, and were left out");
      check_alignment(accessors_[size_t(attributes[name.c_str()].whole(0))]);
    }
  }

  void check_alignment(const Value& accessor) {
    if (!accessor["bufferView"]) return;
    const Value view = document_.list("bufferViews")[size_t(accessor["bufferView"].whole(0))];
    warn(accessor["byteOffset"].whole(0) % 4 != 0 || view["byteOffset"].whole(0) % 4 != 0 ||
             view["byteStride"].whole(0) % 4 != 0,
         "vertex attributes that are not aligned to 4 bytes were read as they are");
  }

  bool bounds_of(const Value& index) const {
    const Value accessor = accessors_[size_t(index.whole(0))];
    return accessor["min"].size() == 3 && accessor["max"].size() == 3;
  }

  void check_indices(const Value& place) {
    const Accessor accessor = open_accessor(document_, place);
    warn(accessor.width != 1 || accessor.component == Component::f32, "indices are no whole numbers");
    if (accessor.bytes.empty() || !afford(accessor.count)) return;
    const std::vector<uint32_t> values = read_whole(document_, accessor);
    const uint32_t restart = accessor.component == Component::u8    ? 0xff
                             : accessor.component == Component::u16 ? 0xffff
                                                                    : 0xffffffff;
    warn(std::find(values.begin(), values.end(), restart) != values.end(),
         "indices name the highest number, which glTF keeps free");
  }

  void check_punctual_lights() {
    const Value lights = document_.root().extension("KHR_lights_punctual")["lights"];
    for (size_t i = 0; i < lights.size(); ++i)
      warn(lights[i]["type"].text_view() == "spot" && !lights[i]["spot"], "spot lights do not state their cone");
  }

  bool afford(uint64_t values) {
    if (values > left_) return false;
    left_ -= values;
    return true;
  }

  Document& document_;
  Value accessors_;
  std::vector<bool> indexing_;  // accessors that primitives use as indices
  size_t faults_ = 0;           // that were caught
  uint64_t left_ = kMostValues;
};

}  // namespace

void check_data(Document& document) { DataChecker(document).run(); }

}  // namespace aktina::gltf
