// Form factors from a differential area to polygons, in closed form.
#pragma once

#include "aktina/radiosity/formfactor/faces.h"

namespace aktina {

/// Lambert's contour formula:
///
///     F = 1/(2 pi)  sum_k  theta_k  n . (r_{k+1} x r_k) / |r_{k+1} x r_k|          [dimensionless]
///
/// where r_k runs from x to vertex k and theta_k is the angle between r_k and r_{k+1}. Where the contour is smaller
/// than a hundredth of its distance that sum cancels; a quadrature of the kernel takes over (relative error 1e-11).
/// @param x  receiving point, m;  @param n  unit normal at x
/// @param contour  planar, every vertex on or above the plane (x, n): clip() first
/// @return F; no visibility. Negative where x is behind the contour, 0 where x lies in its plane.
/// @error  absolute below 1e-15 near and relative 1e-11 far away
/// @cite   J. Lambert, Photometria, 1760; D. Baum, H. Rushmeier, J. Winget, "Improving Radiosity Solutions Through the
///         Use of Analytically Determined Form-Factors", SIGGRAPH '89
double point_to_contour(Point3d x, Vec3d n, std::span<const Point3d> contour);

/// F from a differential area at x to the front of a face, clipped by the horizon; no visibility. In [0, 1].
double point_to_polygon(Point3d x, Vec3d n, const Face& face);

/// The same past occluders, which hide on both sides: what they shade is cut away from the face exactly.
double point_to_polygon(Point3d x, Vec3d n, const Face& face, std::span<const Face* const> occluders);

/// To each surface of a scene. @throws Error as checked_normal()
FormFactorRow point_to_polygons(Point3d x, Vec3d n, const Faces& faces);

}  // namespace aktina
