#include "aktina/render/study/columns.h"

namespace aktina {
namespace {

using Group = StudyColumn::Group;
using M = const MethodStudy&;

double time(M m, size_t which, double FrameTime::*part) {
  return which < m.cost.times.size() ? m.cost.times[which].*part * 1e3 : kNotMeasured;
}

double operations(const std::optional<Operations>& counted, double Operations::*kind) {
  return counted ? (*counted).*kind : kNotMeasured;
}

constexpr StudyColumn kColumns[] = {
    {Group::quality, "rmse", "1", "RMSE", "root of the mean squared difference of linear values; 1 is white",
     [](M m) { return m.quality.rmse; }},
    {Group::quality, "max_error", "1", "largest", "largest difference of a linear value",
     [](M m) { return m.quality.max_error; }},
    {Group::quality, "psnr", "dB", "PSNR", "peak signal over noise, of what a screen shows",
     [](M m) { return m.quality.psnr; }},
    {Group::quality, "flip", "1", "FLIP", "mean difference that a viewer sees, 0 to 1",
     [](M m) { return m.quality.flip; }},
    {Group::quality, "highlight_rmse", "1", "in highlights", "RMSE where the reference has highlights",
     [](M m) { return m.quality.highlight_rmse; }},
    {Group::quality, "edge_jump", "1", "edge jump", "step of the luminance across edges of smooth surfaces",
     [](M m) { return m.quality.edge_jump; }},
    {Group::quality, "mach_band", "1/px", "Mach band", "change of the first derivative across such edges",
     [](M m) { return m.quality.mach_band; }},
    {Group::quality, "flicker", "1", "flicker", "how the error changes from frame to frame while the camera turns",
     [](M m) { return m.quality.flicker; }},
    {Group::quality, "not_finite", "1", "not finite", "values that are NaN or infinite",
     [](M m) { return double(m.quality.not_finite); }},

    {Group::cost, "frame_1", "ms", "frame, 1 thread", "least time of a whole frame on one thread",
     [](M m) { return time(m, 0, &FrameTime::seconds); }},
    {Group::cost, "setup_1", "ms", "set-up", "its half for vertices and triangles",
     [](M m) { return time(m, 0, &FrameTime::setup_seconds); }},
    {Group::cost, "pixels_1", "ms", "pixels", "its half for pixels: coverage, depth and shading",
     [](M m) { return time(m, 0, &FrameTime::pixel_seconds); }},
    {Group::cost, "frame_all", "ms", "frame, all threads", "least time of a whole frame on all threads",
     [](M m) { return time(m, 1, &FrameTime::seconds); }},
    {Group::cost, "ns_per_pixel", "ns", "a pixel", "pixels' half over the pixels that are covered, one thread",
     [](M m) { return m.cost.ns_per_pixel; }},
    {Group::cost, "ns_per_triangle", "ns", "a triangle", "set-up's half over the triangles in view, one thread",
     [](M m) { return m.cost.ns_per_triangle; }},
    {Group::cost, "instructions_per_pixel", "1", "instructions", "of a whole frame on one thread, over covered pixels",
     [](M m) { return m.cost.instructions_per_pixel; }},

    {Group::operations, "evaluations_per_triangle", "1", "evaluations a triangle",
     "of the illumination model during set-up, counted as the engine does them",
     [](M m) { return m.cost.setup_evaluations; }},
    {Group::operations, "evaluations_per_pixel", "1", "evaluations a pixel",
     "of the illumination model at pixels, counted as the engine does them, SIMD lanes without pixel included",
     [](M m) { return m.cost.pixel_evaluations; }},
    {Group::operations, "additions", "1", "+", "additions a pixel, published form",
     [](M m) { return operations(m.cost.pixel_operations, &Operations::additions); }},
    {Group::operations, "multiplications", "1", "×", "multiplications a pixel, published form",
     [](M m) { return operations(m.cost.pixel_operations, &Operations::multiplications); }},
    {Group::operations, "divisions", "1", "÷", "divisions a pixel, published form",
     [](M m) { return operations(m.cost.pixel_operations, &Operations::divisions); }},
    {Group::operations, "square_roots", "1", "√", "square roots a pixel, published form",
     [](M m) { return operations(m.cost.pixel_operations, &Operations::square_roots); }},
    {Group::operations, "powers", "1", "pow",
     "powers a pixel, published form: one a lamp in an evaluation of Phong's model",
     [](M m) { return operations(m.cost.pixel_operations, &Operations::powers); }},
    {Group::operations, "evaluations", "1", "evaluations", "of the illumination model a pixel, published form",
     [](M m) { return operations(m.cost.pixel_operations, &Operations::evaluations); }},
    {Group::operations, "triangle_additions", "1", "+ a triangle", "additions of a triangle's set-up, published form",
     [](M m) { return operations(m.cost.triangle_operations, &Operations::additions); }},
    {Group::operations, "triangle_multiplications", "1", "× a triangle",
     "multiplications of a triangle's set-up, published form",
     [](M m) { return operations(m.cost.triangle_operations, &Operations::multiplications); }},
    {Group::operations, "triangle_evaluations", "1", "evaluations",
     "of the illumination model a triangle, published form: corners are not shared",
     [](M m) { return operations(m.cost.triangle_operations, &Operations::evaluations); }},

    {Group::growth, "time_over_triangles", "1", "time over triangles", "slope of the log-log line",
     [](M m) { return m.growth.time_over_triangles; }},
    {Group::growth, "error_over_triangles", "1", "RMSE over triangles", "slope of the log-log line",
     [](M m) { return m.growth.error_over_triangles; }},
    {Group::growth, "time_over_pixels", "1", "time over pixels", "slope of the log-log line",
     [](M m) { return m.growth.time_over_pixels; }},

    {Group::energy, "albedo_0", "1", "albedo, 0°", "share of a white furnace's light that is seen, looking straight on",
     [](M m) { return m.energy.albedo_0; }},
    {Group::energy, "albedo_60", "1", "60°", "the same at 60 degrees", [](M m) { return m.energy.albedo_60; }},
    {Group::energy, "albedo_85", "1", "85°", "the same at 85 degrees; above 1 the model makes light",
     [](M m) { return m.energy.albedo_85; }},
    {Group::energy, "reciprocity_error", "1", "reciprocity error",
     "largest relative difference between both ways along a path; 0: Helmholtz reciprocity holds",
     [](M m) { return m.energy.reciprocity_error; }},
};

}  // namespace

std::span<const StudyColumn> study_columns() { return kColumns; }

}  // namespace aktina
