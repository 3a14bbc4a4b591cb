#include "tests/peers/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace pushfactor::tests::peers {

namespace {

int call(const Program& program, const std::string& arguments) {
    const int status = std::system(fmt::format("'{}' {}", program.path, arguments).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> result;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) result.push_back(cell);
    return result;
}

std::vector<double> column(const std::string& file, const std::string& name) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> names = cells(line);
    const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    std::vector<double> result;
    while (std::getline(in, line)) {
        const std::vector<std::string> row = cells(line);
        if (place < row.size()) result.push_back(std::stod(row[place]));
    }
    return result;
}

State read_state(const std::string& line) {
    const std::vector<std::string> row = cells(line);
    const auto at = [&](std::size_t i) { return std::stod(row.at(i)); };
    return {{at(2), at(3), at(4)},
            Quaternion(at(5), at(6), at(7), at(8)),
            {at(9), at(10), at(11)},
            {at(12), at(13), at(14)}};
}

std::vector<std::vector<State>> read_states(const std::string& file, std::size_t bodies, std::size_t steps) {
    State unknown;
    unknown.position.setConstant(std::numeric_limits<double>::quiet_NaN());
    std::vector<std::vector<State>> result(steps + 1, std::vector<State>(bodies, unknown));
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    for (std::vector<State>& states : result) {
        for (State& state : states) {
            if (std::getline(in, line)) state = read_state(line);
        }
    }
    return result;
}

}  // namespace

Program find_program(const std::string& path, const std::string& folder) {
    Program program{path, folder, {}};
    const std::string file = folder + "/version.txt";
    if (call(program, fmt::format("--version > '{}'", file)) != 0)
        throw std::runtime_error(path + ": does not run; build it with `cmake --build --preset release`");
    std::ifstream in(file);
    std::getline(in, program.version);
    return program;
}

Scene scene_of(const Program& program, const std::string& arguments) {
    const std::string file = program.folder + "/scene.json";
    if (call(program, fmt::format("scene {} > '{}'", arguments, file)) != 0)
        throw std::runtime_error("pushfactor scene " + arguments + ": failed");
    return read_scene(file);
}

Run run_program(const Program& program, const std::string& arguments, std::size_t bodies, std::size_t steps,
                bool whole_steps) {
    const std::string trajectory = program.folder + "/trajectory.csv";
    const std::string steps_file = program.folder + "/steps.csv";
    const int status =
        call(program, fmt::format("run {} --seconds {} --timing --trajectory '{}' --csv '{}' --summary '{}' 2>&1",
                                  arguments, steps / 60, trajectory, steps_file, program.folder + "/summary.json"));
    constexpr int non_finite = 5;
    if (status != 0 && status != non_finite) throw std::runtime_error("pushfactor run " + arguments + ": failed");
    Run run;
    run.states = read_states(trajectory, bodies, steps);
    run.step_us = column(steps_file, "step_us");
    run.velocity_lag.assign(steps + 1, whole_steps ? 0.0 : 0.5);
    const std::vector<double> substeps = column(steps_file, "substeps");
    for (std::size_t n = 0; n < substeps.size() && n < steps; ++n) run.velocity_lag[n + 1] /= substeps[n];
    run.velocity_lag[0] = run.velocity_lag[1];
    return run;
}

}  // namespace pushfactor::tests::peers
