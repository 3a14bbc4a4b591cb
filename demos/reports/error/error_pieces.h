// The error report as pieces: a point of a sweep, a frozen moment, a scene's consistency.
#pragma once

#include "demos/reports/error/consistency.h"
#include "demos/reports/error/experiments.h"
#include "demos/reports/error/frozen_moments.h"
#include "demos/reports/error/points.h"
#include "demos/reports/study.h"

#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

inline constexpr const char* frozen_part = "frozen";
inline constexpr const char* consistency_part = "consistency";

// What a request asks for, in the order of the page.
struct ErrorPlan {
    std::vector<ErrorPoint> others{};  // of other engines
    std::vector<Experiment> experiments;
    std::vector<FrozenMoment> moments;
    ConsistencyPlan consistency;
    bool quick = false;
};

// Throws UsageError for points of other engines that cannot be read or that are on no scene of the plan.
ErrorPlan error_plan(const StudyRequest& request);
Pieces error_pieces(const StudyRequest& request);

// Keys of the pieces and what their results say.
std::string key_of(const Experiment& sweep, const Method& method, const std::string& value);
ErrorPoint point_in(const Json& json);

struct FrozenResult {
    std::vector<FrozenPoint> points;
    long rows = 0, columns = 0;  // of the system
};
std::string key_of(const FrozenMoment& moment, bool quick);
FrozenResult frozen_in(const Json& json);

std::string key_of(const ConsistencyPlan& plan, const ConsistencyCase& which);
std::vector<ConsistencyPoint> consistency_in(const Json& json);

}  // namespace pushfactor::demos::reports::error
