// The shading methods: the only list.
#include "aktina/raster/shading/shading_method.h"

namespace aktina {

extern const ShadingRow flat_shading, gouraud_shading, phong_shading, quadratic_normals_shading,
    overveld_wyvill_shading, lee_jen_shading, quadratic_shading, seiler_shading, cubic_shading, hybrid_shading,
    fence_shading, spherical_shading, fast_phong_shading, angular_shading, angular_decomposed_shading,
    angular_combined_shading, angular_power_shading, euler_shading, lin_shading, h_test_shading,
    cho_neumann_woo_shading, lai_tai_shading, tai_hsu_shading, overveld_highlights_shading, vlasic_shading,
    brown_shading;

std::span<const ShadingRow* const> shading_methods() {
  static constexpr const ShadingRow* kTable[] = {&flat_shading,
                                                 &gouraud_shading,
                                                 &phong_shading,
                                                 &quadratic_normals_shading,
                                                 &overveld_wyvill_shading,
                                                 &lee_jen_shading,
                                                 &quadratic_shading,
                                                 &seiler_shading,
                                                 &cubic_shading,
                                                 &hybrid_shading,
                                                 &fence_shading,
                                                 &spherical_shading,
                                                 &fast_phong_shading,
                                                 &angular_shading,
                                                 &angular_decomposed_shading,
                                                 &angular_combined_shading,
                                                 &angular_power_shading,
                                                 &euler_shading,
                                                 &lin_shading,
                                                 &h_test_shading,
                                                 &cho_neumann_woo_shading,
                                                 &lai_tai_shading,
                                                 &tai_hsu_shading,
                                                 &overveld_highlights_shading,
                                                 &vlasic_shading,
                                                 &brown_shading};
  return kTable;
}

}  // namespace aktina
