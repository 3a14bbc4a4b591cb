// peers PROGRAM SCENES OUT [CASE...]: the same scenes in this engine and in others. See tests/compare.
#include "tests/peers/cases.h"
#include "tests/peers/program.h"
#include "tests/peers/ratios.h"
#include "tests/peers/run.h"
#include "tests/peers/sweeps.h"
#include "tests/peers/tosses.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace pushfactor::tests::peers {

namespace {

// The measures of the first run, which are the same in all, and the medians of the cost, which differs.
template <typename Once>
Values measured(const Case& of, const Scene& scene, const Once& once) {
    const std::vector<Run> runs = repeated(once);
    Values result = of.measure(scene, runs.front());
    std::vector<Values> costs;
    for (const Run& run : runs) costs.push_back(of.cost(run));
    for (std::size_t i = 0; i < costs.front().size(); ++i) {
        const auto less = [i](const Values& a, const Values& b) { return a[i].number < b[i].number; };
        std::sort(costs.begin(), costs.end(), less);
        result.push_back(costs[costs.size() / 2][i]);
    }
    return result;
}

bool among(const std::vector<std::string>& names, const std::string& name) {
    return std::count(names.begin(), names.end(), name) > 0;
}

bool meant_for(const Setting& setting, const Case& of) {
    if (setting.cases.empty()) return of.group.empty();
    return among(setting.cases, of.name) || among(setting.cases, of.group);
}

std::vector<Line> compare(const Program& program, const std::vector<Setting>& settings, const Case& of) {
    const std::string arguments = of.family        ? family_file(program, of.name, of.arguments)
                                  : of.pyramid > 0 ? pyramid_file(program, of.name, of.pyramid)
                                                   : of.arguments;
    const Scene scene = scene_of(program, arguments);
    std::vector<Line> lines;
    for (const Ours& ours : of.ours) {
        std::cerr << of.name << ": " << program.version << ", " << ours.name << '\n';
        lines.push_back({program.version.substr(0, program.version.find(',')), ours.name, measured(of, scene, [&] {
                             return run_program(program, arguments + " " + ours.arguments, scene.movable.size(),
                                                of.steps, ours.whole_steps);
                         })});
    }
    for (const Setting& setting : settings) {
        if (!meant_for(setting, of)) continue;
        std::cerr << of.name << ": " << setting.engine << ", " << setting.name << '\n';
        lines.push_back({setting.engine, setting.name,
                         measured(of, scene, [&] { return run_peer(setting, scene, of.steps); }),
                         setting.reference});
    }
    append_ratios(of, lines);
    return lines;
}

// Those whose name or group is among `names`; without names those without a group.
std::vector<Case> chosen(std::vector<Case> all, const std::vector<std::string>& names) {
    std::vector<std::string> known;
    for (const Case& of : all) {
        if (!of.group.empty() && !among(known, of.group)) known.push_back(of.group);
        known.push_back(of.name);
    }
    for (const std::string& name : names) {
        if (!among(known, name))
            throw std::invalid_argument(fmt::format("CASE {}: must be one of {}", name, fmt::join(known, " ")));
    }
    std::erase_if(all, [&](const Case& of) {
        return names.empty() ? !of.group.empty() : !among(names, of.name) && !among(names, of.group);
    });
    return all;
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() < 3) throw std::invalid_argument("usage: peers PROGRAM SCENES OUT [CASE...]");
    const std::string& out = arguments[2];
    std::filesystem::create_directories(out);
    if (arguments.size() == 4 && arguments[3] == "tosses") {
        std::ofstream csv(out + "/others.csv");
        write_tosses("assets/measured", csv);
        csv.close();
        if (!csv) throw std::runtime_error(out + "/others.csv: cannot be written");
        return 0;
    }
    const Program program = find_program(arguments[0], out);
    if (arguments.size() == 4 && arguments[3] == "error") {
        std::ofstream csv(out + "/others.csv");
        write_sweeps(program, csv);
        csv.close();
        if (!csv) throw std::runtime_error(out + "/others.csv: cannot be written");
        return 0;
    }
    const std::vector<Case> wanted = chosen(cases(arguments[1]), {arguments.begin() + 3, arguments.end()});

    std::vector<Setting> settings = bullet_settings();
    for (auto more : {ode_settings(), mujoco_settings(), box3d_settings(), jolt_settings()})
        settings.insert(settings.end(), more.begin(), more.end());
    std::cout << program.version << '\n';
    std::ofstream csv(out + "/compare.csv");
    write_csv_header(csv);
    for (const Case& of : wanted) {
        const std::vector<Line> lines = compare(program, settings, of);
        write_markdown(std::cout, of, lines);
        write_csv(csv, of, lines);
    }
    csv.close();
    if (!csv) throw std::runtime_error(out + "/compare.csv: cannot be written");
    return 0;
}

}  // namespace

}  // namespace pushfactor::tests::peers

int main(int count, char** words) {
    try {
        return pushfactor::tests::peers::run({words + 1, words + count});
    } catch (const std::invalid_argument& problem) {
        std::cerr << problem.what() << '\n';
        return 2;
    } catch (const std::exception& problem) {
        std::cerr << problem.what() << '\n';
        return 1;
    }
}
