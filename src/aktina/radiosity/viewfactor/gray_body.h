// Exchange of heat between grey, diffuse surfaces, from their view factors.
#pragma once

#include <limits>

#include "aktina/radiosity/viewfactor/view_factors.h"

namespace aktina {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kStefanBoltzmann = 5.670374419e-8;  // W m^-2 K^-4, CODATA 2018 (exact)

/// What is known of a surface: its temperature or the flux that it must lose, the other is found.
struct GrayBody {
  double emissivity = 0.9;        // 0 .. 1, equal to its absorptance
  double temperature = kUnknown;  // K
  double flux = kUnknown;         // W/m^2, net: emitted and reflected less arriving; positive where heat leaves
};

/// Gebhart factors and script-F, N x N row after row.
struct GrayExchange {
  size_t size;
  std::vector<double> gebhart;   // B_ij: share of what i emits that j absorbs, all reflections counted
  std::vector<double> script_f;  // e_i B_ij: the net exchange is A_i scriptF_ij sigma (T_i^4 - T_j^4)
  std::vector<double> escaped;   // 1 - sum_j B_ij: through the openings
};

/// B = F e + F (1 - e) B, solved directly.
/// @throws Error bad_param (an emissivity outside (0, 1]), limit (more surfaces than fit into memory),
/// bad_input (rows that sum to more than 1 with reflecting surfaces: no finite solution)
/// @cite  B. Gebhart, "Surface Temperature Calculations in Radiant Surroundings of Arbitrary Complexity", Int. J. Heat
///        and Mass Transfer 3, 1961; H. Hottel, A. Sarofim, "Radiative Transfer", 1967 (script-F)
GrayExchange gray_exchange(const ViewFactors& factors, const std::vector<GrayBody>& bodies);

/// Temperatures, radiosities and fluxes in balance.
struct GrayBalance {
  std::vector<double> temperatures;  // K
  std::vector<double> radiosities;   // J, W/m^2
  std::vector<double> fluxes;        // W/m^2, net leaving
  double net = 0;                    // W, sum of A q: what escapes to the surroundings, 0 in an enclosure
};

/// The network of surface resistances (1 - e) / (e A) and space resistances 1 / (A_i F_ij), solved directly. What a row
/// lacks to 1 sees surroundings that are black and have one temperature.
/// @param surroundings  K
/// @throws Error bad_param (a body with both or neither of temperature and flux; emissivity; negative temperature; a
/// flux that would need a temperature below 0 K), limit, bad_input (fluxes alone in an enclosure: no temperature)
/// @cite  A. Oppenheim, "Radiation Analysis by the Network Method", Trans. ASME 78, 1956
GrayBalance gray_balance(const ViewFactors& factors, const std::vector<GrayBody>& bodies, double surroundings);

}  // namespace aktina
