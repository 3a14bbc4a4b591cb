#include "demos/command_line.h"

#include "demos/errors.h"
#include "demos/simulation_options.h"
#include "demos/suggest.h"
#include "demos/version.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <iostream>
#include <set>

namespace pushfactor::demos {

namespace {

const char* const output_group = "Output (FILE - is standard output)";
const char* const exit_statuses =
    "Exit status: 0 done; 1 the run failed; 2 wrong usage or bad input; 3 a check failed;\n"
    "4 an output could not be written; 5 the simulation became non-finite.";

// An option whose text is understood later, together with those of the config file.
void add_given(CLI::App& app, GivenOptions& given, std::string_view name, std::string_view placeholder,
               std::string_view help, const char* group) {
    const std::string key(name);
    app.add_option_function<std::string>(
           "--" + key, [&given, key](const std::string& text) { given.add(key, text, "--" + key); },
           std::string(help))
        ->type_name(std::string(placeholder))
        ->group(group);
}

std::string preset_help() {
    std::string help = "where the options start from";
    for (const Preset& preset : presets()) help += fmt::format("; {}: {}", preset.name, preset.description);
    return help;
}

void add_simulation(CLI::App& app, Request& request, std::optional<std::string>& config) {
    add_given(app, request.given, "preset", "NAME", preset_help() + " [default]", "Simulation");
    for (const SimulationOption& option : simulation_options()) {
        add_given(app, request.given, option.name, option.placeholder, option.help, "Simulation");
    }
    std::set<std::string_view> seen;
    for (const SceneEntry& entry : catalogue()) {
        for (const Parameter& parameter : entry.parameters) {
            if (!seen.insert(parameter.name).second) continue;
            add_given(app, request.given, parameter.name, parameter.placeholder, parameter.help,
                      "Scene parameters (see `pushfactor list` for which scene has which)");
        }
    }
    app.add_option("--config", config, "read options from this JSON file; the command line comes first")
        ->type_name("FILE")
        ->group("Simulation");
}

void add_outputs(CLI::App& app, Request& request) {
    const auto add = [&app](const char* name, std::optional<std::string>& path, const char* help) {
        app.add_option(name, path, help)->type_name("FILE")->group(output_group);
    };
    add("--csv", request.csv, "one line a step: energies, speeds, penetration, residual, counts");
    add("--trajectory", request.trajectory, "one line a body and step (a body and frame with --fps)");
    add("--rows", request.rows, "one line a constraint row and step, with its force");
    add("--summary", request.summary, "the summary as JSON [run: standard output]");
    add("--save-state", request.save_state, "the state at the end, as a scene file that goes on from there");
    app.add_flag("--timing", request.timing, "CPU time of the steps in the CSV and the summary")
        ->group(output_group);
}

bool understand_switch(const char* option, const std::string& text) {
    if (text != "on" && text != "off") throw UsageError(fmt::format("{} {}: must be on or off", option, text));
    return text == "on";
}

void add_frames(CLI::App& app, Request& request) {
    for (const FrameOption& option : frame_options()) {
        add_given(app, request.given, option.name, option.placeholder, option.help, "Frames");
    }
    app.add_option("--out", request.out, "folder for the frames [out/SCENE, or out/SCENE for each of several]")
        ->type_name("DIR")
        ->group("Frames");
    app.add_option("--video", request.video,
                   "also a video (.mp4, .webm or .gif), for which ffmpeg must be installed")
        ->type_name("FILE")
        ->group("Frames");
    app.add_option_function<std::string>(
           "--frames", [&request](const std::string& text) { request.png = understand_switch("--frames", text); },
           "off: the video alone, no PNG files [on]")
        ->type_name("on|off")
        ->group("Frames");
}

void add_report(CLI::App& app, Request& request) {
    app.add_option(
           "REPORT", request.reports,
           "error: error against work and run time, of every method and scene; stability: stiff and "
           "extreme cases, each judged; cost: what a step of each scene does and takes; atlas: maps of how runs "
           "end, over two parameters")
        ->type_name("NAME");
    app.add_option("--out", request.out, "folder for the page, its pictures and tables [out/report-NAME]")
        ->type_name("DIR");
    app.add_flag("--quick", request.quick, "few values and short runs: under a minute");
    app.add_option(
           "--only", request.parts,
           "parts of the report; error: scenes, frozen, consistency; stability: its chapters; cost: scenes; "
           "atlas: its maps [all]")
        ->type_name("PART")
        ->delimiter(',');
    app.add_flag("--problems", request.problems,
                 "error: also write the frozen problems as JSON, for other solvers");
}

// CLI11 would list everything that it did not expect; one line with the nearest known name helps more.
void refuse_extras(const CLI::App& app) {
    std::vector<std::string> known;
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
    }
    for (const std::string& extra : app.remaining()) {
        const std::string word = extra.substr(0, extra.find('='));
        if (extra.starts_with('-')) throw UsageError(word + ": unknown option" + suggestion(word, known));
        throw UsageError(extra + ": not expected here");
    }
}

[[noreturn]] void refuse_command(const CLI::App& app) {
    std::vector<std::string> known;
    for (const CLI::App* command : app.get_subcommands({})) known.push_back(command->get_name());
    const std::vector<std::string> words = app.remaining();
    if (words.empty())
        throw UsageError(fmt::format("a command is missing: one of {} (see --help)", fmt::join(known, ", ")));
    throw UsageError(fmt::format("{}: no such command; there are {}{}", words.front(), fmt::join(known, ", "),
                                 suggestion(words.front(), known)));
}

}  // namespace

std::optional<Request> parse_command_line(int argc, char** argv) {
    Request request;
    std::optional<std::string> config;

    CLI::App app("Constraint based rigid bodies (Tamis & Maggiore 2015), simulated and rendered offscreen.\n",
                 "pushfactor");
    app.set_version_flag("--version", "pushfactor " + version_text(), "Print the version and the commit");
    app.footer(exit_statuses);
    app.require_subcommand(0, 1);
    app.allow_extras();

    CLI::App& list =
        *app.add_subcommand("list", "the scenes: what happens, their parameters, what each is made of");
    list.add_flag("--names", request.names_only, "only the names, one a line");

    CLI::App& scene = *app.add_subcommand("scene", "prints a scene as a JSON file that run and render accept");
    scene.add_option("SCENE", request.scenes, "name of a scene, or a scene file");
    add_simulation(scene, request, config);

    CLI::App& run = *app.add_subcommand("run", "physics only: CSV files and a summary");
    run.add_option("SCENE", request.scenes, "name of a scene, or a scene file");
    add_simulation(run, request, config);
    add_outputs(run, request);
    for (const FrameOption& option : frame_options()) {
        if (option.name != "fps") continue;  // thins the trajectory; a run has no other use for frames
        add_given(run, request.given, option.name, option.placeholder, option.help, output_group);
    }

    CLI::App& render = *app.add_subcommand("render", "PNG frames or stills, without a display");
    render.add_option("SCENE", request.scenes, "names of scenes, or scene files");
    add_simulation(render, request, config);
    add_outputs(render, request);
    add_frames(render, request);

    CLI::App& figures =
        *app.add_subcommand("figures", "the figures of the paper's sections 8, 10 and 12, and ours, as one page");
    figures.add_option("FIGURE", request.figures, "names of figures [all]");
    figures.add_option("--out", request.out, "folder for the page and its pictures [out/figures]")
        ->type_name("DIR");
    figures.add_option("--width", request.figure_width, "width of a figure in pixels [1600]")
        ->type_name("N")
        ->check(CLI::Range(400, 4096));
    figures.add_option("--samples", request.figure_samples, "drawings that a picture is the mean of [8]")
        ->type_name("N")
        ->check(CLI::Range(1, 256));

    CLI::App& report = *app.add_subcommand("report", "measurements of many runs, as CSV files and a page of plots");
    add_report(report, request);

    for (CLI::App* command : {&list, &scene, &run, &render, &figures, &report}) {
        command->allow_extras();
        command->footer(exit_statuses);
    }

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        app.exit(asked);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    if (app.get_subcommands().empty()) refuse_command(app);
    const CLI::App& chosen = *app.get_subcommands().front();
    refuse_extras(chosen);

    request.command = &chosen == &scene     ? Request::Command::scene
                      : &chosen == &run     ? Request::Command::run
                      : &chosen == &render  ? Request::Command::render
                      : &chosen == &figures ? Request::Command::figures
                      : &chosen == &report  ? Request::Command::report
                                            : Request::Command::list;
    if (config) add_config(*config, request.given);
    if (const auto* named = request.given.find("scene"); named && request.scenes.empty()) {
        request.scenes.push_back(named->text);
    }
    const bool of_a_scene = request.command == Request::Command::scene ||
                            request.command == Request::Command::run || request.command == Request::Command::render;
    if (of_a_scene && request.scenes.empty()) {
        throw UsageError("a scene is missing (see `pushfactor list`)");
    }
    const bool one = request.command == Request::Command::run || request.command == Request::Command::scene;
    if (one && request.scenes.size() > 1) {
        throw UsageError(fmt::format("scene {}: must be one scene at a time", fmt::join(request.scenes, " ")));
    }
    return request;
}

}  // namespace pushfactor::demos
