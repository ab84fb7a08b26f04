// The view-factor job: a model -> its matrix, certificate and grey-body exchange.
#pragma once

#include "aktina/export/view_factor_files.h"
#include "aktina/radiosity/viewfactor/certificate.h"
#include "aktina/radiosity/viewfactor/scene_surfaces.h"
#include "aktina/render/report.h"

namespace aktina {

/// Whatever load_scene() reads, or a View3D input file (.vs3), whose subsurfaces are cut out of their bases and whose
/// combined surfaces are one.
/// @param by, backs, clear  have no effect on .vs3: its surfaces are what they are
/// @throws Error as load_scene(), read_vs3(), surfaces_of()
ViewFactorScene load_view_factor_scene(const Path& path, SurfacesBy by, Backs backs = Backs::hide,
                                       Clear clear = Clear::hide, double metres_per_unit = 0);

struct ViewFactorJob {
  ViewFactorOptions options;
  bool repair = false;           // see repair()
  bool gray_body = false;        // Gebhart factors and script-F; balance where each surface has T or q
  std::vector<GrayBody> bodies;  // of each surface; empty: emissivity 0.9, or what the file says
  double surroundings = 0;       // K
};

struct ViewFactorResult {
  ViewFactors factors;
  Certificate certificate;  // of the factors as computed, before any repair
  bool repaired = false;
  double largest_repair = 0;
  std::vector<GrayBody> bodies;
  GrayExchange exchange{};  // where asked for; size 0 otherwise
  GrayBalance balance{};
  bool balanced = false;
  Report report;
};
ViewFactorResult view_factors(const ViewFactorScene& scene, const ViewFactorJob& job, Progress& progress);

/// JSON text: the certificate, and what was repaired.
std::string certificate_json(const ViewFactorResult& result);

/// By the extension, see export/view_factor_files.h. @throws Error usage, io
void write_view_factors(const Path& path, const ViewFactorScene& scene, const ViewFactorResult& result);

/// What is known of each surface, from a CSV file with a head line: surface,emissivity,temperature_K,flux_W_m2; empty
/// fields are unknown. Surfaces that it does not name keep what they have.
/// @throws Error io, bad_input (a line with other than four fields, no number, no such surface)
std::vector<GrayBody> read_gray_bodies(const Path& path, const ViewFactorScene& scene, std::vector<GrayBody> bodies);

/// Emissivities of the file, `fallback` where it has none.
std::vector<GrayBody> gray_bodies(const ViewFactorScene& scene, double fallback);

}  // namespace aktina
