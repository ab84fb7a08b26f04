// Form factors between two polygons past occluders.
#pragma once

#include "aktina/radiosity/formfactor/face.h"

namespace aktina {

struct Estimate {
  double value, error;  // the error is an estimate, too
};

/// A_a F_ab past occluders, which hide on both sides, m^2. What is hidden is cut out exactly at each point
/// (visible_part) and integrated over one of the faces: that face is first cut along the lines where the view of the
/// other one changes its structure (through edges of one and corners of another polygon), so that the integrand is
/// smooth in each cell, then each cell adaptively. The lines are complete for a single convex occluder; where shadows
/// of several overlap there are curves as well, and only the adaption deals with those.
/// @param tolerance  of F_ab: wanted absolute error; more work than kMostPoints points is not done
/// @cite  F. Durand, G. Drettakis, C. Puech, "The Visibility Skeleton", SIGGRAPH '97 (the critical lines)
Estimate exchange_area(const Face& a, const Face& b, std::span<const Face* const> occluders, double tolerance);

/// Whether an occluder may stand between two faces: false only where it certainly does not.
bool may_hide(const Face& occluder, const Face& a, const Face& b);

/// How near occluders come to a face, by their corners and the circle about it: shadows on the nearer of two faces have
/// the sharper edges, so integrals are better taken over the other one. m
double clearance(const Face& face, std::span<const Contour> occluders);

}  // namespace aktina
