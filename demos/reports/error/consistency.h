// Convergence of each scene to itself at smaller steps. In several windows, runs restart from states of one run
// with the smallest step, so that chaos does not grow beyond a window.
//
//   e_c(h) = sqrt( mean over windows and bodies of |x^h - x^h_min|^2 ) at the end of a window
//   order p = log2( e_c(2h) / e_c(h) )
//
// Symbols: h step [s], h_min the smallest [s], x position [m], e_c [m].
#pragma once

#include "demos/reports/study.h"

namespace pushfactor::demos::reports::error {

Pieces consistency_pieces(bool quick);  // a scene each

// consistency.csv and its section.
void add_consistency(StudyRun& run);

}  // namespace pushfactor::demos::reports::error
