#include "tests/peers/program.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <filesystem>
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

// time, body, then the numbers of a state. Not by cells(): a long run of a pile has millions of lines.
State read_state(const std::string& line) {
    constexpr std::size_t skipped = 2;
    std::array<double, skipped + 13> row{};
    const char* at = line.data();
    const char* const end = at + line.size();
    for (double& number : row) {
        const auto [next, problem] = std::from_chars(at, end, number);
        if (problem != std::errc()) throw std::runtime_error("trajectory: a line cannot be read: " + line);
        at = next + (next < end ? 1 : 0);
    }
    const auto vector = [&](std::size_t i) { return Vector3(row[i], row[i + 1], row[i + 2]); };
    return {vector(2), Quaternion(row[5], row[6], row[7], row[8]), vector(9), vector(12)};
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

std::string family_file(const Program& program, const std::string& name, const std::string& arguments) {
    const std::string file = fmt::format("'{}/{}.json'", program.folder, name);
    if (call(program, fmt::format("family {} > {}", arguments, file)) != 0)
        throw std::runtime_error("pushfactor family " + arguments + ": failed");
    return file;
}

std::string pyramid_file(const Program& program, const std::string& name, int rows) {
    using Json = nlohmann::json;
    constexpr double friction = 0.6;
    Json bodies{{{"name", "ground"}, {"shape", "plane"}, {"position_m", {0.0, 0.0, 0.0}}, {"friction", friction}}};
    for (int row = 0; row < rows; ++row) {
        for (int k = 0; k < rows - row; ++k) {
            bodies.push_back({{"name", fmt::format("row {}, cube {}", row + 1, k + 1)},
                              {"shape", "box"},
                              {"size_m", {1.0, 1.0, 1.0}},
                              {"mass_kg", 100.0},
                              {"position_m", {k - 0.5 * (rows - row - 1), 0.5 + row, 0.0}},
                              {"friction", friction}});
        }
    }
    const std::string file = fmt::format("{}/{}.json", program.folder, name);
    std::ofstream(file) << Json{{"version", 1},
                                {"name", name},
                                {"gravity_m_per_s2", {0.0, -10.0, 0.0}},
                                {"contacts", true},
                                {"bodies", bodies}};
    return fmt::format("'{}'", file);
}

Run run_program(const Program& program, const std::string& arguments, std::size_t bodies, std::size_t steps,
                bool whole_steps) {
    const std::string trajectory = program.folder + "/trajectory.csv";
    const std::string steps_file = program.folder + "/steps.csv";
    const int status = call(
        program,
        fmt::format("run {} --rest off --seconds {} --timing --trajectory '{}' --csv '{}' --summary '{}' 2>'{}'",
                    arguments, steps / 60, trajectory, steps_file, program.folder + "/summary.json",
                    program.folder + "/warnings.txt"));
    constexpr int non_finite = 5;
    if (status != 0 && status != non_finite)
        throw std::runtime_error(
            fmt::format("pushfactor run {}: failed, see {}/warnings.txt", arguments, program.folder));
    Run run;
    run.states = read_states(trajectory, bodies, steps);
    std::filesystem::remove(trajectory);  // of a pile: hundreds of megabytes
    run.step_us = column(steps_file, "step_us");
    run.velocity_lag.assign(steps + 1, whole_steps ? 0.0 : 0.5);
    const std::vector<double> substeps = column(steps_file, "substeps");
    for (std::size_t n = 0; n < substeps.size() && n < steps; ++n) run.velocity_lag[n + 1] /= substeps[n];
    run.velocity_lag[0] = run.velocity_lag[1];
    return run;
}

}  // namespace pushfactor::tests::peers
