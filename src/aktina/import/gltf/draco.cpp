#include "aktina/import/gltf/draco.h"

#include <draco/compression/decode.h>

#include <limits>
#include <new>

namespace aktina::gltf {
namespace {

/// Largest value of an integer type, to which normalized values refer; 0 for floats.
double scale_of(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return 127;
    case draco::DT_UINT8:
      return 255;
    case draco::DT_INT16:
      return 32767;
    case draco::DT_UINT16:
      return 65535;
    default:
      return 0;
  }
}

class DracoReader {
 public:
  DracoReader(Document& document, const Value& primitive)
      : document_(document), primitive_(primitive), place_(primitive.extension("KHR_draco_mesh_compression")) {}

  Mesh read() {
    decode();
    Mesh mesh;
    document_.allowance.take(uint64_t(packed_->num_faces()) * 12 + uint64_t(packed_->num_points()) * 64, place_);
    for (draco::FaceIndex f(0); f < packed_->num_faces(); ++f) {
      const auto& face = packed_->face(f);
      mesh.triangles.push_back({face[0].value(), face[1].value(), face[2].value()});
    }
    read(mesh.positions, "POSITION", 0);
    read(mesh.normals, "NORMAL", 0);
    read(mesh.tangents, "TANGENT", 0);
    read(mesh.uv[0], "TEXCOORD_0", 0);
    read(mesh.uv[1], "TEXCOORD_1", 0);
    read(mesh.colours, "COLOR_0", 1);
    return mesh;
  }

 private:
  /// Draco holds what its stream claims against the stream's length; a claim that it believes ends as want of memory.
  void decode() {
    const auto bytes = document_.view(size_t(place_["bufferView"].whole(0)));
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::Decoder decoder;
    try {
      auto result = decoder.DecodeMeshFromBuffer(&buffer);
      if (!result.ok()) place_.fail("the packed data are corrupt: " + result.status().error_msg_string());
      packed_ = std::move(result).value();
    } catch (const std::bad_alloc&) {
      place_.fail("the packed data claim more than fits into memory", Code::limit);
    }
  }

  /// @param missing  value of components that the attribute has not
  template <class V>
  void read(std::vector<V>& out, const char* name, float missing) {
    const Value id = place_["attributes"][name];
    if (!id) return;
    const draco::PointAttribute* attribute = packed_->GetAttributeByUniqueId(uint32_t(id.whole(0)));
    if (!attribute) id.fail("the packed data have no such attribute");
    const int width = std::min(int(attribute->num_components()), int(V::length()));
    const double scale = scale_of(attribute->data_type());
    const bool normalized = scale > 0 && is_normalized(name) && !attribute->normalized();
    out.assign(packed_->num_points(), V(missing));
    for (draco::PointIndex p(0); p < packed_->num_points(); ++p) {
      float values[4] = {};
      const draco::AttributeValueIndex index = attribute->mapped_index(p);
      if (index.value() >= attribute->size() || !attribute->ConvertValue<float>(index, int8_t(width), values))
        place_.fail("the packed data are corrupt");
      for (int k = 0; k < width; ++k) out[p.value()][k] = normalized ? float(double(values[k]) / scale) : values[k];
    }
  }

  bool is_normalized(const char* name) const {
    const Value index = primitive_["attributes"][name];
    if (!index) return false;
    return document_.list("accessors")[size_t(index.whole(0))]["normalized"].flag(false);
  }

  Document& document_;
  Value primitive_, place_;
  std::unique_ptr<draco::Mesh> packed_;
};

}  // namespace

Mesh unpack_draco(Document& document, const Value& primitive) { return DracoReader(document, primitive).read(); }

}  // namespace aktina::gltf
