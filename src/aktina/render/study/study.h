// The study: which method is good enough on a scene, and what it costs. The same view is drawn by each method of a
// family, held against a reference, timed and counted. docs/study.md shows one and says what each number means.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "aktina/render/job.h"
#include "aktina/render/study/operations.h"

namespace aktina {

inline constexpr double kNotMeasured =
    std::numeric_limits<double>::quiet_NaN();  // not measured, or without meaning here

/// Families whose methods can be compared: by pictures; form factors, radiosity and meshers by runs.
inline constexpr std::string_view kStudyFamilies[] = {"shading",   "illumination", "normals", "integrator",
                                                      "radiosity", "formfactor",   "mesher",  "specular"};

struct StudyOptions {
  std::string family = "shading";      // one of kStudyFamilies
  std::vector<std::string> methods{};  // "METHOD" or "METHOD:parameter=number,..."; empty: all of the family
  std::string reference{};             // a method of the family, or an integrator; empty: the family's own
  std::string illumination = "phong";  // of the families that are rasterized
  int width = 0, height = 0;           // px; 0: from the camera's aspect, 480 px wide
  int samples = 16;                    // per pixel of the pictures that are compared
  int camera = 0;
  uint32_t seed = 0;
  int rounds = 7;      // of timing; the least time counts
  bool growth = true;  // cost and error over finer meshes and larger pictures
  /// The same scene, finer and finer; empty: each triangle cut in four by the middles of its edges, twice.
  std::vector<const Scene*> levels{};
};

/// Differences from the reference, of pictures exposed so that 1 is white.
struct Quality {
  double rmse = kNotMeasured, max_error = kNotMeasured;  // of linear values
  double psnr = kNotMeasured;                            // dB, of what a screen shows; infinite where equal
  double flip = kNotMeasured;                            // mean, of what a screen shows
  double highlight_rmse = kNotMeasured;  // where the reference has highlights; unknown where it has none
  // Across edges that smooth triangles share, root of the mean square over all places, per pixel; of luminance.
  double edge_jump = kNotMeasured;  // of the value
  double mach_band = kNotMeasured;  // of the first derivative
  double flicker = kNotMeasured;    // root of the mean square of the error's change from frame to frame, over a turn
  uint64_t not_finite = 0;          // values
};

/// Least seconds of a frame on `threads` threads.
struct FrameTime {
  int threads = 1;
  double seconds = kNotMeasured, setup_seconds = kNotMeasured, pixel_seconds = kNotMeasured;
};

struct Cost {
  std::vector<FrameTime> times;                                               // on one thread first, then on all
  double ns_per_pixel = kNotMeasured, ns_per_triangle = kNotMeasured;         // one thread: pixels' half, set-up's half
  double setup_evaluations = kNotMeasured, pixel_evaluations = kNotMeasured;  // of the model: per triangle, per pixel
  double instructions_per_pixel =
      kNotMeasured;  // of the whole frame, one thread; unknown where the machine does not count
  std::optional<Operations> pixel_operations, triangle_operations;  // by the published form
};

/// Of an illumination model, with the coefficients of the scene's first material (illumination/energy.h).
struct Energy {
  double albedo_0 = kNotMeasured, albedo_60 = kNotMeasured,
         albedo_85 = kNotMeasured;          // luminance; seen at that many degrees
  double reciprocity_error = kNotMeasured;  // 0: both ways along a path count the same
};

/// One step of a sweep.
struct GrowthPoint {
  uint64_t triangles = 0, pixels = 0;
  double seconds = kNotMeasured, setup_seconds = kNotMeasured, pixel_seconds = kNotMeasured, rmse = kNotMeasured;
};
struct Growth {
  std::vector<GrowthPoint> over_triangles, over_pixels;
  // Slopes of log-log lines through the points.
  double time_over_triangles = kNotMeasured, error_over_triangles = kNotMeasured, time_over_pixels = kNotMeasured;
};

/// What a paper or the literature says of a method, and what was measured here.
struct ClaimResult {
  enum class Verdict { holds, fails, unknown };
  std::string claim, source;  // key in docs/references.bib
  Verdict verdict = Verdict::unknown;
  std::string measured;
};

/// One run of a method at one of its settings, where a family is compared by runs.
struct StudyRun {
  std::string choice{};     // "hemicube:resolution=64"
  std::string setting{};    // in words, where the choice does not say it
  std::string parameter{};  // what a sweep changes, and its value
  double value = kNotMeasured;
  bool others_least = false;      // all other counts of the method are 1: as it was published
  double size = kNotMeasured;     // patches
  double seconds = kNotMeasured;  // on one thread
  double error = kNotMeasured, rms_error = kNotMeasured, largest_error = kNotMeasured;
  double contact_error = kNotMeasured;    // where surfaces meet
  double off_balance = kNotMeasured;      // distance from the converged solution
  double estimated_error = kNotMeasured;  // by the method itself
  double steps = kNotMeasured, bytes = kNotMeasured;

  std::string name() const { return setting.empty() ? choice : choice + ", " + setting; }
};

struct MethodStudy {
  std::string choice, id, title, summary, cite;
  std::string failure;  // why the method could not draw the scene; then nothing below is known
  Image picture;        // linear, cd/m^2
  Quality quality;
  Cost cost;
  Growth growth;
  Energy energy;  // family "illumination"
  std::vector<StudyRun> runs;
  std::vector<ClaimResult> claims;
  bool best = false;  // on the Pareto front: none of the others is both quicker and nearer to the reference
};

struct Study {
  std::string scene, family, reference;
  Report report;
  Image reference_picture;  // linear, cd/m^2
  float exposure = 1;
  Quality reference_edges;  // edge_jump and mach_band of the reference itself
  uint64_t triangles = 0, covered_pixels = 0;
  bool counts_instructions = false;
  std::string error_name, size_name;  // of runs: what their error and size are; empty: no runs, time in place of size
  std::vector<MethodStudy> methods;
  std::vector<std::string> remarks;  // in plain words
};

/// Stops early where `progress` is cancelled: what is known then is returned, with report.complete = false.
/// @throws Error usage, bad_param, no_such_method, limit, cancelled (before the first method is measured)
Study study(const Scene& scene, const StudyOptions& options, Progress& progress);

}  // namespace aktina
