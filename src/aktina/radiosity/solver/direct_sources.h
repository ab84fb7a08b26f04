// Where light comes straight from: lamps, the sky, and the brightest emitting surfaces.
#pragma once

#include <deque>
#include <vector>

#include "aktina/radiosity/checkpoint.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solve.h"
#include "aktina/radiosity/solver/coarse_patches.h"
#include "aktina/radiosity/solver/light_groups.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {

/// Of each side, lx. Empty: not known yet.
struct DirectLight {
  std::vector<Rgb> lamps;  // and sky
  std::vector<Rgb> all;
};

/// Direct light in a checkpoint, as it was computed call by call.
class KeptDirectLight {
 public:
  /// @param checkpoint  may be null
  explicit KeptDirectLight(Checkpoint* checkpoint) : checkpoint_(checkpoint) {}
  struct Call {
    Call(Checkpoint* checkpoint, size_t sides)
        : lamps(checkpoint, "light of lamps", sides), all(checkpoint, "direct light", sides) {}
    KeptList<Rgb> lamps, all;
  };
  Call& next(size_t sides) {
    if (!checkpoint_) calls_.clear();
    return calls_.emplace_back(checkpoint_, sides);
  }

 private:
  Checkpoint* checkpoint_;
  std::deque<Call> calls_;
};

class DirectSources {
 public:
  /// @param open  by side, as CoarsePatches has it. The arguments must outlive this.
  DirectSources(const LightGroup& lights, const Sides& sides, const std::vector<float>& open,
                const Visibility& visibility, const RadiosityOptions& options, const MeshOptions& mesh);

  /// What arrives on the sides `of` replaces what `light` has there. The same values for a side whichever others are
  /// asked for with it.
  void shine_on(std::span<const uint32_t> of, DirectLight& light, KeptDirectLight& kept, Progress* progress) const;
  /// What a side emits beside these sources.
  Rgb other_emission(size_t side) const { return taken_[side] ? Rgb(0) : emission(side); }

 private:
  void find_emitters();
  Rgb emission(size_t side) const { return lights_.emission(sides_.mesh(), sides_.patch(side)).v; }
  /// Of the mean irradiance of a side, what its open part has.
  Rgb on_open(uint32_t side, Rgb mean) const { return clusters_.partly_open(side) ? mean / open_[side] : mean; }

  const LightGroup& lights_;
  const Sides& sides_;
  const std::vector<float>& open_;
  const Visibility& visibility_;
  int samples_;
  uint32_t seed_;
  CoarsePatches clusters_;
  std::vector<uint32_t> emitters_;  // among the clusters
  std::vector<Rgb> exitances_;      // of each of them, lm/m^2
  std::vector<uint8_t> taken_;      // by side: belongs to one of them
};

/// m^2
double total_area(const PatchMesh& mesh);

}  // namespace aktina
