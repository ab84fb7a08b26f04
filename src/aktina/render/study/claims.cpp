#include "aktina/render/study/claims.h"

#include <fmt/format.h>

#include <cmath>

namespace aktina {
namespace {

double frame(const MethodStudy& m) { return m.cost.times.empty() ? kNotMeasured : m.cost.times[0].seconds; }
double pixels(const MethodStudy& m) { return m.cost.times.empty() ? kNotMeasured : m.cost.times[0].pixel_seconds; }

/// Whether the time of the pixels' half over another method's lies in [least, most].
template <int least10, int most10>
Judgement costs(const Evidence& e, std::string_view base) {
  const MethodStudy* other = e.find(base);
  if (!other || !std::isfinite(pixels(e.method) / pixels(*other))) return {};
  const double ratio = pixels(e.method) / pixels(*other), whole = frame(e.method) / frame(*other);
  return decide(ratio * 10 >= least10 && ratio * 10 <= most10,
                fmt::format("{:.2f} times {}'s time for the pixels, {:.2f} times its whole frame", ratio, base, whole));
}

Judgement nearer_than(const Evidence& e, std::string_view base) {
  const MethodStudy* other = e.find(base);
  if (!other || !std::isfinite(e.method.quality.rmse + other->quality.rmse)) return {};
  return decide(e.method.quality.rmse < other->quality.rmse,
                fmt::format("RMSE {:.3g} against {:.3g} of {}", e.method.quality.rmse, other->quality.rmse, base));
}

Judgement same_as(const Evidence& e, std::string_view base) {
  const MethodStudy* other = e.find(base);
  if (!other || !std::isfinite(e.method.quality.rmse + other->quality.rmse)) return {};
  const double a = e.method.quality.rmse, b = other->quality.rmse;
  return decide(std::abs(a - b) <= 1e-3 * std::max(a, b), fmt::format("RMSE {:.4g} and {:.4g}", a, b));
}

constexpr double kVisibleKink = 1e-3;  // of white, per pixel

Judgement mach_bands_stay(const Evidence& e) {
  const double band = e.method.quality.mach_band;
  if (!std::isfinite(band)) return {};
  return decide(band > kVisibleKink, fmt::format("the derivative jumps by {:.3g} of white a pixel at edges; in the "
                                                 "reference by {:.3g}",
                                                 band, e.study.reference_edges.mach_band));
}

/// Not always: T. Duff, "Smoothly Shaded Renderings of Polyhedral Objects on Raster Displays", SIGGRAPH 1979.
Judgement weaker_mach_bands(const Evidence& e) {
  const MethodStudy* gouraud = e.find("gouraud");
  const double band = e.method.quality.mach_band;
  if (!gouraud || !std::isfinite(band + gouraud->quality.mach_band)) return {};
  return decide(band < gouraud->quality.mach_band,
                fmt::format("the derivative jumps by {:.3g} of white a pixel at edges, "
                            "Gouraud's by {:.3g}",
                            band, gouraud->quality.mach_band));
}

Judgement no_jumps(const Evidence& e) {
  const MethodStudy* flat = e.find("flat");
  const double jump = e.method.quality.edge_jump, smooth = e.study.reference_edges.edge_jump;
  if (!flat || !std::isfinite(jump + flat->quality.edge_jump)) return {};
  return decide(jump < 0.25 * flat->quality.edge_jump,
                fmt::format("{:.3g} across edges; flat shading {:.3g}, the reference {:.3g}", jump,
                            flat->quality.edge_jump, smooth));
}

Judgement loses_highlights(const Evidence& e) {
  const double there = e.method.quality.highlight_rmse, all = e.method.quality.rmse;
  if (!std::isfinite(there + all)) return {};
  return decide(there > all, fmt::format("RMSE {:.3g} in highlights, {:.3g} in the whole picture", there, all));
}

Judgement discontinuous(const Evidence& e) {
  const double jump = e.method.quality.edge_jump, smooth = e.study.reference_edges.edge_jump;
  if (!std::isfinite(jump + smooth)) return {};
  return decide(jump > 1.5 * smooth, fmt::format("{:.3g} across edges; the reference {:.3g}", jump, smooth));
}

Judgement keeps_highlights(const Evidence& e) {
  const MethodStudy* gouraud = e.find("gouraud");
  const double there = e.method.quality.highlight_rmse;
  if (!gouraud || !std::isfinite(there + gouraud->quality.highlight_rmse)) return {};
  return decide(there < 0.5 * gouraud->quality.highlight_rmse,
                fmt::format("RMSE {:.3g} in highlights, Gouraud's {:.3g}", there, gouraud->quality.highlight_rmse));
}

Judgement quicker_than_phong(const Evidence& e) { return costs<0, 10>(e, "phong"); }
Judgement nearer_than_gouraud(const Evidence& e) { return nearer_than(e, "gouraud"); }

constexpr Claim kClaims[] = {
    {"shading", "flat", "shows each polygon as a facet", "gouraud1971", discontinuous},
    {"shading", "gouraud", "removes the jumps between polygons", "gouraud1971", no_jumps},
    {"shading", "gouraud", "leaves Mach bands", "phong1975", mach_bands_stay},
    {"shading", "gouraud", "misses highlights within polygons", "phong1975", loses_highlights},
    {"shading", "phong", "has weaker Mach bands than Gouraud", "phong1975", weaker_mach_bands},
    {"shading", "phong", "takes six to seven times as long as Gouraud", "hearn1997",
     [](const Evidence& e) { return costs<60, 70>(e, "gouraud"); }},
    {"shading", "quadratic_normals", "is quicker than Phong, having no square root", "szirmay2000", quicker_than_phong},
    {"shading", "lee_jen", "costs little more than Phong", "lee2001",
     [](const Evidence& e) { return costs<0, 12>(e, "phong"); }},
    {"shading", "quadratic", "is nearer to Phong than Gouraud is", "szirmay2000", nearer_than_gouraud},
    {"shading", "quadratic", "takes two additions a pixel: at most twice Gouraud's time", "szirmay2000",
     [](const Evidence& e) { return costs<0, 20>(e, "gouraud"); }},
    {"shading", "seiler", "is quadratic shading in another form", "seiler1998",
     [](const Evidence& e) { return same_as(e, "quadratic"); }},
    {"shading", "cubic", "is nearer to Phong than quadratic shading is", "vlasic2002",
     [](const Evidence& e) { return nearer_than(e, "quadratic"); }},
    {"shading", "hybrid", "is quicker than Phong", "hast2001", quicker_than_phong},
    {"shading", "fast_phong", "takes about twice as long as Gouraud", "hearn1997",
     [](const Evidence& e) { return costs<15, 25>(e, "gouraud"); }},
    {"shading", "fast_phong", "is quicker than Phong", "bishop1986", quicker_than_phong},
    {"shading", "fast_phong", "is not continuous across edges", "hast2001euler", discontinuous},
    {"shading", "spherical", "is quicker than Phong, having no square root a pixel", "mohamed2000", quicker_than_phong},
    {"shading", "angular", "is quicker than Phong", "kuijk1989", quicker_than_phong},
    {"shading", "angular_combined", "is quicker than the exact form", "kuijk1989",
     [](const Evidence& e) { return costs<0, 10>(e, "angular"); }},
    {"shading", "angular_power", "is the quickest form: two additions for a highlight", "kuijk1989",
     [](const Evidence& e) { return costs<0, 10>(e, "angular_combined"); }},
    {"shading", "euler", "is as quick as fast Phong", "hast2001euler",
     [](const Evidence& e) { return costs<0, 11>(e, "fast_phong"); }},
    {"shading", "euler", "is nearer to Phong than fence shading", "hast2001euler",
     [](const Evidence& e) { return nearer_than(e, "fence"); }},
    {"shading", "lin", "keeps highlights within polygons", "lin2002", keeps_highlights},
    {"shading", "h_test", "is quicker than Phong", "harrison1988", quicker_than_phong},
    {"shading", "h_test", "keeps highlights within polygons", "harrison1988", keeps_highlights},
    {"shading", "cho_neumann_woo", "comes near to Phong", "cho1996", keeps_highlights},
    {"shading", "cho_neumann_woo", "costs little more than Gouraud", "cho1996",
     [](const Evidence& e) { return costs<0, 15>(e, "gouraud"); }},
    {"shading", "lai_tai", "is quicker than Phong", "lai2000", quicker_than_phong},
    {"shading", "lai_tai", "keeps highlights within polygons", "lai2000", keeps_highlights},
    {"shading", "tai_hsu", "is quicker than Phong", "tai2002", quicker_than_phong},
    {"shading", "overveld_highlights", "is quicker than Phong", "overveld1996", quicker_than_phong},
    {"shading", "vlasic", "shows highlights within polygons", "vlasic2002", keeps_highlights},
    {"shading", "brown", "is quicker than Phong", "brown1999", quicker_than_phong},
    {"shading", "brown", "shows highlights within polygons", "brown1999", keeps_highlights},
    {"illumination", "schlick", "is quicker than Phong's power", "schlick1994", quicker_than_phong},
    {"normals", "angle", "is nearer to the surface than the plain mean", "thurmer1998",
     [](const Evidence& e) { return nearer_than(e, "plain"); }},
    {"normals", "max", "is nearer to the surface than weights by area", "max1999",
     [](const Evidence& e) { return nearer_than(e, "area"); }},
    {"integrator", "path", "is nearer to the light of a scene than direct light alone", "kajiya1986",
     [](const Evidence& e) { return nearer_than(e, "direct"); }},
};

/// Where a method that is meant to be quicker than Phong is not.
void compare_with_phong(Study& study) {
  const Evidence all{study, study.methods.front()};
  const MethodStudy* phong = all.find("phong");
  if (!phong || !std::isfinite(frame(*phong))) return;
  for (const MethodStudy& m : study.methods) {
    const double ratio = frame(m) / frame(*phong);
    if (m.id == "phong" || !std::isfinite(ratio)) continue;
    const std::string times =
        fmt::format("{:.2f} ms a frame, Phong {:.2f} ms, on one thread", frame(m) * 1e3, frame(*phong) * 1e3);
    if (ratio > 0.97)
      study.remarks.push_back(fmt::format("{} does not beat Phong by SIMD here: {}.", m.choice, times));
    else
      study.remarks.push_back(
          fmt::format("{} beats Phong by SIMD here by {:.0f} %: {}.", m.choice, 100 * (1 / ratio - 1), times));
  }
}

void judge(const Study& study, MethodStudy& method, std::span<const Claim> claims) {
  for (const Claim& claim : claims) {
    if (claim.family != study.family || claim.method != method.id) continue;
    const Judgement j = method.failure.empty() ? claim.judge({study, method}) : Judgement{};
    method.claims.push_back({std::string(claim.text), std::string(claim.source), j.verdict, j.measured});
  }
}

}  // namespace

const MethodStudy* Evidence::find(std::string_view id) const {
  for (const MethodStudy& m : study.methods)
    if (m.id == id && m.failure.empty()) return &m;
  return nullptr;
}

Judgement decide(bool holds, std::string measured) {
  return {holds ? ClaimResult::Verdict::holds : ClaimResult::Verdict::fails, std::move(measured)};
}

void judge_claims(Study& study) {
  for (MethodStudy& m : study.methods) {
    if (!m.failure.empty())
      study.remarks.push_back(
          fmt::format("{} cannot {} this scene: {}", m.choice, study.error_name.empty() ? "draw" : "take", m.failure));
    judge(study, m, kClaims);
    judge(study, m, run_claims());
  }
  if (study.family == "shading") compare_with_phong(study);
}

}  // namespace aktina
