// Claims on methods that are compared by runs: judged at equal time or size, or over a method's own settings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/render/study/claims.h"
#include "aktina/render/study/runs.h"

namespace aktina {
namespace {

/// Whether the method's error is lower than another's in the middle of what both reach.
Judgement nearer_at_equal(const Evidence& e, double StudyRun::*x, std::string_view name, std::string_view base) {
  const MethodStudy* other = e.find(base);
  if (!other) return {};
  const auto own = best_runs(e.method, x), its = best_runs(*other, x);
  if (own.empty() || its.empty()) return {};
  const double low = std::max(own.front()->*x, its.front()->*x), high = std::min(own.back()->*x, its.back()->*x);
  if (!(low <= high)) return {};
  const double at = std::sqrt(low * high), a = error_at(e.method, x, at), b = error_at(*other, x, at);
  if (!std::isfinite(a + b)) return {};
  return decide(a < b, fmt::format("error {:.3g} against {:.3g} of {}, at {:.3g} {}", a, b, base, at, name));
}

Judgement nearer_at_equal_time(const Evidence& e, std::string_view base) {
  return nearer_at_equal(e, &StudyRun::seconds, "s", base);
}

Judgement nearer_at_equal_size(const Evidence& e, std::string_view base) {
  return nearer_at_equal(e, &StudyRun::size, "patches", base);
}

/// Slope of log error over log value of the longest sweep of one parameter.
Judgement falls_as(const Evidence& e, std::string_view parameter, double least, double most) {
  std::vector<std::pair<double, double>> points;
  for (const StudyRun& run : e.method.runs)
    if (run.parameter == parameter && !run.others_least && run.error > 0)
      points.emplace_back(std::log(run.value), std::log(run.error));
  if (points.size() < 3) return {};
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [px, py] : points) x += px, y += py;
  x /= double(points.size()), y /= double(points.size());
  for (const auto& [px, py] : points) xx += (px - x) * (px - x), xy += (px - x) * (py - y);
  const double slope = xy / xx;
  return decide(slope >= least && slope <= most,
                fmt::format("with {} to the power {:.2f}, over {} settings", parameter, slope, points.size()));
}

/// Whether every run keeps the error it was asked for.
Judgement keeps(const Evidence& e, std::string_view parameter, double StudyRun::*error) {
  double worst = -INFINITY;
  for (const StudyRun& run : e.method.runs)
    if (run.parameter == parameter) worst = std::max(worst, run.*error / run.value);
  if (!std::isfinite(worst)) return {};
  return decide(worst <= 1, fmt::format("at most {:.2g} times the {} asked for", worst, parameter));
}

/// Whether the method reaches a tolerance in fewer steps than another; at the last setting that both have.
Judgement fewer_steps(const Evidence& e, std::string_view base, double share) {
  const MethodStudy* other = e.find(base);
  if (!other) return {};
  Judgement found;
  for (const StudyRun& own : e.method.runs)
    for (const StudyRun& its : other->runs)
      if (own.setting == its.setting && its.steps > 0)
        found = decide(own.steps <= share * its.steps,
                       fmt::format("{:g} steps, {} {:g}, {}", own.steps, base, its.steps, own.setting));
  return found;
}

/// Whether the first answer within twice the matrix solution's error comes before it.
Judgement early_answer(const Evidence& e) {
  const MethodStudy* matrix = e.find("matrix");
  if (!matrix) return {};
  const auto own = best_runs(e.method, &StudyRun::seconds), its = best_runs(*matrix, &StudyRun::seconds);
  if (its.empty()) return {};
  const double wanted = 2 * its.back()->error;
  const auto first = [&](const auto& runs) {
    for (const StudyRun* run : runs)
      if (run->error <= wanted) return run->seconds;
    return kNotMeasured;
  };
  const double a = first(own), b = first(its);
  if (!std::isfinite(a + b)) return {};
  return decide(a < b, fmt::format("error {:.3g} after {:.3g} s, by the matrix after {:.3g} s", wanted, a, b));
}

constexpr Claim kClaims[] = {
    {"formfactor", "contour", "is exact: each factor within the tolerance", "schroder1993",
     [](const Evidence& e) { return keeps(e, "tolerance", &StudyRun::largest_error); }},
    {"formfactor", "cubature", "meets its tolerance", "walton2002",
     [](const Evidence& e) { return keeps(e, "tolerance", &StudyRun::largest_error); }},
    {"formfactor", "hybrid", "meets its target error", "walton2002",
     [](const Evidence& e) { return keeps(e, "target_error", &StudyRun::largest_error); }},
    {"formfactor", "monte_carlo", "has an error that falls with the root of its rays", "malley1988",
     [](const Evidence& e) { return falls_as(e, "samples", -0.7, -0.4); }},
    {"formfactor", "ray_cast", "is nearer than the hemicube, which aliases", "wallace1989",
     [](const Evidence& e) { return nearer_at_equal_time(e, "hemicube"); }},
    {"formfactor", "single_plane", "is quicker than the hemicube at the same error", "sillion1989",
     [](const Evidence& e) { return nearer_at_equal_time(e, "hemicube"); }},
    {"formfactor", "cubic_tetrahedron", "is quicker than the hemicube at the same error", "berankoehn1991",
     [](const Evidence& e) { return nearer_at_equal_time(e, "hemicube"); }},
    {"radiosity", "progressive", "shows a useful picture before the matrix is solved", "cohen1988", early_answer},
    {"radiosity", "overshooting", "takes fewer shots than progressive refinement", "feda1992",
     [](const Evidence& e) { return fewer_steps(e, "progressive", 1); }},
    {"radiosity", "matrix", "takes about half the sweeps of Jacobi's iteration", "goral1984",
     [](const Evidence& e) { return fewer_steps(e, "jacobi", 0.65); }},
    {"radiosity", "overrelaxed", "takes fewer sweeps than Gauss and Seidel", "young1954",
     [](const Evidence& e) { return fewer_steps(e, "matrix", 1); }},
    {"radiosity", "conjugate_gradient", "takes fewer steps than Jacobi's iteration", "hestenes1952",
     [](const Evidence& e) { return fewer_steps(e, "jacobi", 1); }},
    {"radiosity", "gmres", "takes fewer steps than Jacobi's iteration", "saad1986",
     [](const Evidence& e) { return fewer_steps(e, "jacobi", 1); }},
    {"radiosity", "hierarchical", "is nearer than the matrix in the same time", "hanrahan1991",
     [](const Evidence& e) { return nearer_at_equal_time(e, "matrix"); }},
    {"radiosity", "clustering", "is nearer than links between every two surfaces in the same time", "smits1994",
     [](const Evidence& e) { return nearer_at_equal_time(e, "hierarchical"); }},
    {"radiosity", "wavelet_m2", "is nearer than Haar wavelets in the same time", "gortler1993",
     [](const Evidence& e) { return nearer_at_equal_time(e, "wavelet_haar"); }},
    {"radiosity", "wavelet_m3", "is nearer than Haar wavelets in the same time", "gortler1993",
     [](const Evidence& e) { return nearer_at_equal_time(e, "wavelet_haar"); }},
    {"radiosity", "wavelet_f2", "is nearer than Haar wavelets in the same time", "gortler1993",
     [](const Evidence& e) { return nearer_at_equal_time(e, "wavelet_haar"); }},
    {"radiosity", "stochastic_jacobi", "is nearer than the matrix in the same time", "neumann1995",
     [](const Evidence& e) { return nearer_at_equal_time(e, "matrix"); }},
    {"mesher", "quadtree", "is nearer than an even mesh of as many patches", "baum1991",
     [](const Evidence& e) { return nearer_at_equal_size(e, "uniform"); }},
    {"mesher", "discontinuity", "is nearer than an even mesh of as many patches", "campbell1990",
     [](const Evidence& e) { return nearer_at_equal_size(e, "uniform"); }},
};

}  // namespace

std::span<const Claim> run_claims() { return kClaims; }

}  // namespace aktina
