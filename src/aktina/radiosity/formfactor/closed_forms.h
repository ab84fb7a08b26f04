// Form factors of simple shapes in closed form. Lengths in any one unit, angles in rad; results in [0, 1].
// J. Howell, "A Catalog of Radiation Heat Transfer Configuration Factors"; the numbers in brackets are its own.
#pragma once

#include "aktina/base/vec.h"

namespace aktina {

/// From a differential area at x with unit normal n to the front of a disc, cut by the horizon of x. [B-10, B-13 and
/// their generalisation: the contour integral along the visible arc and its chord]
double point_to_disc(Point3d x, Vec3d n, Point3d centre, Vec3d disc_normal, double radius);

/// From a differential area to a sphere that may be cut by its horizon. [B-43, B-44]
/// @param distance  to the sphere's centre, at least `radius`
/// @param angle     between the normal and the direction of the centre, 0 .. pi
double point_to_sphere(double radius, double distance, double angle);

/// From disc 1 to disc 2, on one axis and facing each other. [C-41]
double coaxial_discs(double radius1, double radius2, double distance);

/// From one a x b rectangle to an equal one opposite to it. [C-11]
double opposed_rectangles(double a, double b, double distance);

/// From a rectangle of depth `from` to one of height `to` that stands on it along their common edge. [C-14]
double perpendicular_rectangles(double edge, double from, double to);

/// From the inside of a sphere to the sphere inside it, around the same centre. [C-121]
double sphere_to_inner_sphere(double inner_radius, double outer_radius);

/// From anywhere on the inside of a sphere to the band between two polar angles: its share of the area.
double sphere_band(double angle1, double angle2);

/// The inside of a spherical cap that is closed by its flat base. Half angle: seen from the sphere's centre, (0, pi).
struct CapFactors {
  double cap_cap, cap_base, base_cap;
};
CapFactors spherical_cap(double half_angle);

}  // namespace aktina
