// What the page of the error report shows of each of its parts. All draw into `folder`; `machine` stands small
// below each plot.
#pragma once

#include "demos/pages/page.h"
#include "demos/reports/error/consistency.h"
#include "demos/reports/error/frozen_moments.h"
#include "demos/reports/error/points.h"

#include <filesystem>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

// Two: against work, and against CPU time.
std::vector<Section> error_sections(const Experiment& sweep, const std::vector<ErrorPoint>& points,
                                    const std::string& machine, const std::filesystem::path& folder);

Section frozen_section(const FrozenMoment& moment, const FrozenProblem& problem,
                       const std::vector<FrozenPoint>& points, const std::string& machine,
                       const std::filesystem::path& folder);

Section consistency_section(const ConsistencyPlan& plan, const std::vector<ConsistencyPoint>& points,
                            const std::string& machine, const std::filesystem::path& folder);

}  // namespace pushfactor::demos::reports::error
