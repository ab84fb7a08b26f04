// What a view-factor matrix must satisfy, measured on the matrix itself.
#pragma once

#include "aktina/radiosity/viewfactor/view_factors.h"

namespace aktina {

struct Certificate {
  struct Row {
    uint32_t surface;
    double sum;    // of the row: 1 in a closed enclosure
    double error;  // sum of the estimates in it
  };
  bool closed = false;  // all rows sum to 1 within their estimated errors and 1e-3
  double least_sum = 0, most_sum = 0;
  double mean_closure = 0;       // root mean square of 1 - sum, weighted by area
  double worst_reciprocity = 0;  // largest |A_i F_ij - A_j F_ji| / min(A_i, A_j)
  double least = 0, most = 0;    // of all factors: within [0, 1]
  uint64_t out_of_bounds = 0;    // factors that are not
  double largest_excess = 0;     // of a factor above its unobstructed value, before it was held to that
  uint64_t held = 0;             // pairs that were
  double largest_error = 0;      // estimate of an entry
  uint32_t largest_error_row = 0, largest_error_column = 0;
  std::vector<Row> worst;  // rows farthest from 1 (closed), above 1 or with the largest errors; at most ten
};

/// Sums of rows: of the complete ones.
Certificate certify(const ViewFactors& factors);

/// Makes the rows of a closed enclosure sum to 1 by the least change of the exchange areas A_i F_ij, each weighted by
/// its size: A_i F_ij (1 + l_i + l_j). They stay symmetric (reciprocity is kept), zeros stay zero.
/// @return largest change of a factor
/// @throws Error bad_input (a row that differs from 1 by more than a tenth: that is no enclosure)
/// @cite  R. Loehrke, J. Dolaghan, P. Burns, "Smoothing Monte Carlo Exchange Factors", J. Heat Transfer 117, 1995
double repair(ViewFactors& factors);

}  // namespace aktina
