// The step of paper sections 5 to 7 in numbers: the rows of the last step, A and b of 6.2.9, and what each sweep of
// Gauss-Seidel (7.1.1) makes of lambda.
#pragma once

#include "demos/base/text/json.h"
#include "demos/runs/simulation.h"

namespace pushfactor::demos::pictures::live {

// Rows that can be shown.
inline constexpr long most_rows = 120;

// "rows": kind, bodies, "jacobian" (six numbers for each body), the push in its two parts [m/s], bounds [N, or a
// factor of row "of_row"; null for none], "disc" (0 none, 1 and 2 the rows of one); "A" [1/kg], "diagonal" and "b"
// [m/s^2] per column: with the push, and without it if some row has a push for this step only; "lambda" [N] per
// column, at the start and after each sweep; "bodies" before and after the step; "contacts": where the rows of
// points act. The last sweep's lambda is that of the step, bit for bit. Throws UsageError unless the run has taken
// a step, whole with --solver pgs and friction rows that are bounded one by one, that has rows and not more than
// `most_rows`.
Json microscope(const Simulation& simulation);

}  // namespace pushfactor::demos::pictures::live
