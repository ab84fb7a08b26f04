// A scene -> the light on its surfaces: the front of meshers, form factors and solvers.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "aktina/base/progress.h"
#include "aktina/image/image.h"
#include "aktina/radiosity/checkpoint.h"
#include "aktina/radiosity/solution.h"
#include "aktina/scene/scene.h"

namespace aktina {

struct RadiosityOptions {
  std::string solver = "stochastic_jacobi";  // "METHOD" or "METHOD:parameter=number,...", as solvers() lists them
  std::string formfactor = "ray_cast";       // as formfactors() lists them
  std::string mesher = "uniform";            // as meshers() lists them
  std::string quality = "normal";            // draft, normal, fine: what the values that are 0 below stand for
  double patch_size = 0;                     // m, longest edge; 0: by quality and the scene's size
  double tolerance = 0;     // stop when the unshot flux is below this share of the emitted; 0: by quality
  double target_error = 0;  // relative, of irradiances, where a solver draws samples; 0: by quality
  /// Direct light is computed apart, on every patch; indirect light on coarser ones, this many patch sizes long. 0: all
  /// light on all patches. Form factors other than by rays know no coarser patches.
  double indirect_size = 2;
  /// The picture that the light is for: what it does not show is computed no finer than that picture needs. Of solvers
  /// on trees (hierarchical, clustering, wavelets).
  std::optional<Camera> importance{};
  uint64_t most_steps = 0;            // 0: no limit
  uint64_t most_patches = 2'000'000;  // more are refused before memory is taken
  uint32_t seed = 0;
  /// A run that was killed goes on from its checkpoint and gives the same bytes as one that was not. Meshing is done
  /// again.
  CheckpointOptions checkpoint{};
  /// Called after each step with the solution so far (patch values; vertices are not reconstructed yet), to watch it
  /// converge. With `ambient` the displayed radiosity of a patch is B + rho `ambient` (Cohen et al. 1988).
  struct Step {
    uint64_t step;
    double unshot;  // as Solution::unshot
    Radiosity ambient;
    const Solution* solution;
  };
  std::function<void(const Step&)> each_step{};
};

/// Light sources are emissive surfaces, and the scene's point, spot, directional and environment lights (as direct
/// illuminance with shadow rays). What is done when `progress` is cancelled is returned, with converged = false.
/// The same bytes for any number of threads.
/// Patches that would reflect more than 0.99 are taken to reflect that, and counted in Solution::warnings.
/// @throws Error usage, bad_param, no_such_method, limit; bad_input (nothing shines, no surface)
Solution solve_radiosity(const Scene& scene, const RadiosityOptions& options = {}, Progress* progress = nullptr);

/// The light of one lamp, one object that emits, or the sky.
struct LightSolution {
  std::string name;
  Solution solution;  // on the same patches for all; what others emit is 0
};
/// As solve_each_light() calls them, in its order.
std::vector<std::string> light_names(const Scene& scene);
/// Each light of the scene by itself, on one set of patches, form factors or links: lights to be dimmed, suns to be
/// moved. Lamps, objects and the sky ("environment") by name, those of one name together. As solve_radiosity() for the
/// rest; `each_step` is not called.
/// @throws Error as solve_radiosity(); unsupported (direct light not computed apart); limit (more than 256 lights)
std::vector<LightSolution> solve_each_light(const Scene& scene, const RadiosityOptions& options = {},
                                            Progress* progress = nullptr);
/// Light is additive: the sum of solutions on the same patches, each times its weight.
/// @param weights  as many, 0 .. inf
/// @throws Error usage (patches that are not the same, no solutions, other weights)
Solution mixed(std::span<const Solution* const> solutions, std::span<const double> weights);

/// The scene as any viewer shows it without computing light: each instance's mesh cut into its patches, H / pi (cd/m^2)
/// as vertex colours on unlit materials that keep their base texture; emissive surfaces carry their own radiance.
/// Names, nodes, cameras and lights stay. What write_lit_gltf() writes and render_solution() draws.
Scene lit_scene(const Scene& scene, const Solution& solution);

/// The solution seen from a camera, by the rasterizer: linear radiance, cd/m^2. Base textures stay sharp: the
/// interpolated irradiance multiplies them pixel by pixel.
LayeredImage render_solution(const Scene& scene, const Solution& solution, const Camera& camera, int width, int height,
                             int samples = 4, Progress* progress = nullptr);

/// Two passes: radiosity for the light between diffuse surfaces, rays for shadows of direct light, mirrors and glass.
/// J. Wallace, M. Cohen, D. Greenberg, "A Two-pass Solution to the Rendering Equation", SIGGRAPH 1987.
struct TwoPassOptions {
  std::string method = "two_pass";  // and its parameters: "two_pass:gather=1"
  int samples = 16;                 // per pixel
  uint32_t seed = 0;
  std::function<void(const LayeredImage& picture, int samples)> each_pass{};
};
LayeredImage render_two_pass(const Scene& scene, const Solution& solution, const Camera& camera, int width, int height,
                             const TwoPassOptions& options = {}, Progress* progress = nullptr);

}  // namespace aktina
