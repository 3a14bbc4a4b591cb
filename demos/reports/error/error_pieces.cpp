#include "demos/reports/error/error_pieces.h"

#include "demos/reports/error/other_engines.h"
#include "demos/text/errors.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

namespace pushfactor::demos::reports::error {

namespace {

constexpr int repeats = 5;  // timed runs per point

std::vector<std::string> texts_of(const std::vector<Rational>& values) {
    std::vector<std::string> texts;
    for (const Rational& value : values) texts.push_back(to_text(value));
    return texts;
}

Json json_of_point(const ErrorPoint& point) {
    Json errors = Json::array();
    for (const auto& [name, value] : point.errors) errors.push_back({name, json_number(value)});
    const auto& [min, median, p95, first_two_seconds, last_second] = point.cpu;
    return {{"scene", point.scene},
            {"method", point.method},
            {"differences", point.differences},
            {"knob", point.knob},
            {"value", point.value},
            {"errors", errors},
            {"multiply_adds", json_number(point.multiply_adds)},
            {"moves", json_number(point.moves)},
            {"cpu", json_numbers({min, median, p95, first_two_seconds, last_second})},
            {"outcome", point.outcome},
            {"has_failed", point.failed}};
}

Json json_of_frozen(const FrozenProblem& problem, const std::vector<FrozenPoint>& points) {
    Json lines = Json::array();
    for (const auto& [name, method, iterations, residual, multiply_adds] : points) {
        lines.push_back({name, method, iterations, json_number(residual), json_number(multiply_adds)});
    }
    return {
        {"rows", problem.system().row_count()}, {"columns", problem.system().column_count()}, {"points", lines}};
}

Json json_of_consistency(const std::vector<ConsistencyPoint>& points) {
    Json lines = Json::array();
    for (const auto& [dt, error, size, order] : points) {
        lines.push_back(
            {json_number(dt), json_number(error), json_number(size), order ? json_number(*order) : Json(nullptr)});
    }
    return lines;
}

}  // namespace

ErrorPlan error_plan(const StudyRequest& request) {
    ErrorPlan plan;
    plan.quick = request.quick;
    plan.experiments = error_experiments(request.quick);
    std::erase_if(plan.experiments, [&](const Experiment& sweep) { return !request.wants(sweep.name); });
    if (request.wants(frozen_part)) plan.moments = hard_moments(request.quick);
    if (request.beside) {
        plan.others = read_error_points(*request.beside);
        const auto has_others = [&](const Experiment& sweep) {
            return std::ranges::any_of(plan.others,
                                       [&](const ErrorPoint& one) { return one.scene == sweep.scene; });
        };
        if (std::ranges::none_of(plan.experiments, has_others)) {
            throw UsageError(
                fmt::format("--beside {}: must have points on scenes of the report", request.beside->string()));
        }
    }
    if (request.wants(consistency_part)) plan.consistency = consistency_plan(request.quick);
    return plan;
}

Pieces error_pieces(const StudyRequest& request) {
    using Check = std::function<void()>;
    const auto plan = std::make_shared<const ErrorPlan>(error_plan(request));
    Pieces pieces;
    for (const Experiment& sweep : plan->experiments) {
        for (const Method& method : sweep.methods) {
            for (const std::string& value : method.values) {
                pieces.push_back({key_of(sweep, method, value), [plan, &sweep, &method, value](const Check& check) {
                                      return json_of_point(run_point(sweep, method, value, repeats, check));
                                  }});
            }
        }
    }
    for (const FrozenMoment& moment : plan->moments) {
        pieces.push_back({key_of(moment, plan->quick), [plan, &moment](const Check& check) {
                              const FrozenProblem problem = freeze(moment, check);
                              return json_of_frozen(problem, solve_frozen(problem, plan->quick));
                          }});
    }
    for (const ConsistencyCase& which : plan->consistency.cases) {
        pieces.push_back({key_of(plan->consistency, which), [plan, &which](const Check& check) {
                              return json_of_consistency(check_consistency(plan->consistency, which, check));
                          }});
    }
    return pieces;
}

std::string key_of(const Experiment& sweep, const Method& method, const std::string& value) {
    OptionTexts options{{method.knob, value}};
    options.insert(options.end(), method.differs.begin(), method.differs.end());
    options.insert(options.end(), sweep.common.begin(), sweep.common.end());
    return fmt::format("error: {}, {}: {}; timed {} times{}", sweep.name, method.name,
                       run_key(sweep.scene, options), repeats,
                       sweep.clock_seconds ? fmt::format(" over {} s", *sweep.clock_seconds) : "");
}

ErrorPoint point_in(const Json& json) {
    ErrorPoint point{.scene = json.at("scene"),
                     .method = json.at("method"),
                     .differences = json.at("differences"),
                     .knob = json.at("knob"),
                     .value = json.at("value"),
                     .errors = {},
                     .multiply_adds = number_in(json.at("multiply_adds")),
                     .moves = number_in(json.at("moves")),
                     .cpu = {},
                     .outcome = json.at("outcome"),
                     .failed = json.at("has_failed")};
    for (const Json& error : json.at("errors")) point.errors.push_back({error.at(0), number_in(error.at(1))});
    const std::vector<double> cpu = numbers_in(json.at("cpu"));
    point.cpu = {cpu.at(0), cpu.at(1), cpu.at(2), cpu.at(3), cpu.at(4)};
    return point;
}

std::string key_of(const FrozenMoment& moment, bool quick) {
    return fmt::format("error: frozen, {}: {}{}", moment.name, run_key(moment.scene, moment.options),
                       quick ? "; few iterations" : "");
}

FrozenResult frozen_in(const Json& json) {
    FrozenResult result{.points = {}, .rows = json.at("rows"), .columns = json.at("columns")};
    for (const Json& line : json.at("points")) {
        result.points.push_back({.problem = line.at(0),
                                 .method = line.at(1),
                                 .iterations = line.at(2),
                                 .residual = number_in(line.at(3)),
                                 .multiply_adds = number_in(line.at(4))});
    }
    return result;
}

std::string key_of(const ConsistencyPlan& plan, const ConsistencyCase& which) {
    return fmt::format("error: consistency of {}; steps {}, against {}; windows of {} s from {}",
                       run_key(which.scene, which.options), fmt::join(texts_of(plan.steps), ","),
                       to_text(plan.smallest), to_text(plan.window), fmt::join(texts_of(plan.starts), ","));
}

std::vector<ConsistencyPoint> consistency_in(const Json& json) {
    std::vector<ConsistencyPoint> points;
    for (const Json& line : json) {
        points.push_back(
            {.dt = number_in(line.at(0)), .error = number_in(line.at(1)), .size = number_in(line.at(2))});
        if (!line.at(3).is_null()) points.back().order = number_in(line.at(3));
    }
    return points;
}

}  // namespace pushfactor::demos::reports::error
