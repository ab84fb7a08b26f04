// Form factors between two polygons in closed form, without occlusion.
#pragma once

#include "aktina/radiosity/formfactor/face.h"

namespace aktina {

/// A_1 F_12 = A_2 F_21 of two contours, each in front of the other's plane (touching it is allowed), m^2. By Stokes'
/// theorem twice:
///
///     4 pi A_1 F_12 = sum_{edges i of 1, j of 2} (d_i . d_j) int_i int_j ln r^2 ds dt
///
/// with both integrals of each pair of edges in closed form but for one smooth remainder (int rho theta dt, where rho
/// is the distance to the line of the other edge and theta the angle at which the edge is seen), which is integrated
/// adaptively. Edges may touch, cross, coincide or be parallel. Where one contour is small against the distance the sum
/// cancels; there the smaller contour is integrated by Gauss points over Lambert's formula for the larger.
/// @error  1e-13 of the smaller area near by, relative 1e-11 far away
/// @cite   P. Schroeder, P. Hanrahan, "On the Form Factor between Two Polygons", SIGGRAPH '93
double exchange_area(const Face& a, const Face& b, std::span<const Point3d> part_of_a,
                     std::span<const Point3d> part_of_b);

/// The parts of two faces that are in front of each other; both empty where they do not face each other.
struct FacingParts {
  Contour a, b;
  bool empty() const { return a.empty() || b.empty(); }
};
FacingParts facing_parts(const Face& a, const Face& b);

/// A_a F_ab of the fronts of two faces, m^2, parts behind each other's planes cut away; no occlusion.
double exchange_area(const Face& a, const Face& b);

/// int over edge 0 int over edge 1 of ln (r^2 / unit^2), m^2.
/// @param from, to  ends of the edges, m;  @param unit  any length of the size of the distances, m
double log_integral(Point3d from0, Point3d to0, Point3d from1, Point3d to1, double unit);

}  // namespace aktina
