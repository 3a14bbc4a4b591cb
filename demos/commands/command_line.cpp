#include "demos/commands/command_line.h"

#include "demos/options/simulation_options.h"
#include "demos/platform/version.h"
#include "demos/scenes/families/family.h"
#include "demos/text/errors.h"
#include "demos/text/suggest.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace pushfactor::demos {

namespace {

const char* const output_group = "Output (FILE - is standard output)";
const char* const exit_statuses =
    "Exit status: 0 done; 1 the run failed; 2 wrong usage or bad input; 3 a check failed;\n"
    "4 an output could not be written; 5 the simulation became non-finite.";

// Adds an option whose text is parsed later, together with those of the config file.
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
    std::string help = "preset that the options start from";
    for (const Preset& preset : presets()) help += fmt::format("; {}: {}", preset.name, preset.description);
    return help;
}

// Parsed command line, before the file of --config has been read.
struct Words {
    Request request;
    std::optional<std::string> config;
};

void add_simulation(CLI::App& app, Words& words) {
    Request& request = words.request;
    add_given(app, request.given, "preset", "NAME",
              preset_help() + "; overrides what files say about them [default]", "Simulation");
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
    app.add_option("--config", words.config, "read options from this JSON file; the command line takes precedence")
        ->type_name("FILE")
        ->group("Simulation");
}

void add_outputs(CLI::App& app, Request& request) {
    const auto add = [&app](const char* name, std::optional<std::string>& path, const char* help) {
        app.add_option(name, path, help)->type_name("FILE")->group(output_group);
    };
    add("--csv", request.files.csv, "one line per step: energies, speeds, penetration, residual, counts");
    add("--trajectory", request.files.trajectory, "one line per body and step (per body and frame with --fps)");
    add("--rows", request.files.rows, "one line per constraint row and step, with its force");
    add("--summary", request.summary, "the summary as JSON [run: standard output]");
    add("--replay", request.replay,
        "a page (.html) that plays the run in a browser; at most 60 frames per second, or --fps");
    app.add_option_function<std::string>(
           "--replay-data",
           [&request](const std::string& text) {
               if (text != "all" && text != "poses") {
                   throw UsageError(fmt::format("--replay-data {}: must be all or poses", text));
               }
               request.replay_poses_only = text == "poses";
           },
           "poses: the replay without velocities and forces, for a smaller file [all]")
        ->type_name("all|poses")
        ->group(output_group);
    add("--glb", request.glb,
        "the run as a glTF file (.glb) for Blender and others; one key per 1/60 s, or per 1/fps");
    add("--save-state", request.files.save_state, "the final state, as a scene file that resumes the run");
    app.add_flag("--timing", request.timing,
                 "CPU time of the steps in the CSV and the summary; the run uses one thread")
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
    app.add_option("--video", request.video, "also write a video (.mp4, .webm or .gif); needs ffmpeg")
        ->type_name("FILE")
        ->group("Frames");
    app.add_option_function<std::string>(
           "--frames", [&request](const std::string& text) { request.png = understand_switch("--frames", text); },
           "off: no PNG files, only the video or the replay [on]")
        ->type_name("on|off")
        ->group("Frames");
}

void add_list(CLI::App& app, Words& words) {
    app.add_flag("--names", words.request.names_only, "only the names, one per line");
}

void add_scene(CLI::App& app, Words& words) {
    app.add_option("SCENE", words.request.scenes, "name of a scene, or a scene file");
    add_simulation(app, words);
}

void add_family(CLI::App& app, Words& words) {
    Request& request = words.request;
    app.add_option("NAME", request.families, "name of a family [all are listed]");
    add_given(app, request.given, "seed", "N", "random seed [1]", "Options");
    std::set<std::string_view> seen;
    for (const families::Family& family : families::families()) {
        for (const families::FamilyParameter& parameter : family.parameters) {
            const Parameter& range = parameter.range;
            if (!seen.insert(range.name).second) continue;
            add_given(app, request.given, range.name, range.placeholder, range.help,
                      "Parameters (see `pushfactor family` for which family has which) [at random]");
        }
    }
}

void add_run(CLI::App& app, Words& words) {
    add_scene(app, words);
    add_outputs(app, words.request);
    for (const FrameOption& option : frame_options()) {
        // Of the trajectory, of --glb and of --replay; a run has no other use for frame options.
        if (option.name != "fps" && option.name != "camera" && option.name != "overlay") continue;
        add_given(app, words.request.given, option.name, option.placeholder, option.help, output_group);
    }
}

void add_render(CLI::App& app, Words& words) {
    app.add_option("SCENE", words.request.scenes, "names of scenes, or scene files");
    add_simulation(app, words);
    add_outputs(app, words.request);
    add_frames(app, words.request);
    const char* const shares = "Long films on many machines";
    app.add_option("--shard", words.request.shard, "draw only every N-th frame, from the K-th on")
        ->type_name("K/N")
        ->group(shares);
    app.add_option("--from-trajectory", words.request.from_trajectory,
                   "draw the poses of this file of --trajectory instead of simulating again")
        ->type_name("FILE")
        ->group(shares);
    app.add_option("--join", words.request.joined, "make the --video of the frames in these folders; draws nothing")
        ->type_name("DIR")
        ->group(shares);
}

void add_figures(CLI::App& app, Words& words) {
    Request& request = words.request;
    app.add_option("FIGURE", request.figures, "names of figures [all]");
    app.add_option("--out", request.out, "folder for the page and its pictures [out/figures]")->type_name("DIR");
    app.add_option(
           "--width", request.figure_width,
           "width of a figure: pixels, or for print a length (85mm, 17cm, 3.35in, 240pt), which adds PDF and "
           "LaTeX [1600]")
        ->type_name("N|LENGTH");
    app.add_option("--dpi", request.figure_dpi, "with a length: pixels per inch of pictures [300]")
        ->type_name("N")
        ->check(CLI::Range(72, 1200));
    app.add_option("--font-size", request.figure_letters, "with a length: size of all letters on paper [8pt]")
        ->type_name("LENGTH");
    app.add_option("--theme", request.figure_theme, "light, or dark for talks [light]")->type_name("NAME");
    app.add_option("--background", request.figure_background, "plain, or none: transparent [plain]")
        ->type_name("NAME");
    app.add_option("--samples", request.figure_samples,
                   "renderings averaged per picture: smoother edges, soft shadows [8]")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
}

// Verdicts for CI servers.
void add_verdict_files(CLI::App& app, Request& request) {
    app.add_option("--junit", request.junit, "the verdicts as JUnit XML")->type_name("FILE");
    app.add_option("--markdown", request.markdown, "a summary as Markdown, for the summary of a job")
        ->type_name("FILE");
}

// Of reports that are made of pieces.
void add_pieces(CLI::App& app, Request& request) {
    const char* const pieces = "Shares of a report (error, stability, atlas), which `report merge` joins";
    app.add_option("--shard", request.shard, "make only the K-th of N shares, and no page; what is done is skipped")
        ->type_name("K/N")
        ->group(pieces);
    app.add_option("--jobs", request.report_jobs,
                   "runs at once [one per processor; error, which measures times: 1]")
        ->type_name("N")
        ->check(CLI::Range(1, 1024))
        ->group(pieces);
    const char* const grid = "A map of your own (report atlas)";
    const auto add = [&](const char* name, auto& value, const char* placeholder, const char* help) {
        return app.add_option(name, value, help)->type_name(placeholder)->group(grid);
    };
    GridWords& words = request.grid;
    add("--grid", words.scene, "SCENE", "name of a scene, or a scene file");
    add("--x", words.x, "OPTION=VALUES", "values FROM:TO:STEP, log:FROM:TO:COUNT or A,B,C");
    add("--y", words.y, "OPTION=VALUES", "the same for the other axis");
    add("--measure", words.measure, "NAME", "the number of the summary that cells show [max_penetration_m]");
    add("--set", words.set, "OPTION=VALUE", "an option of all cells; may be repeated");
    add("--replays", words.replays, "X:Y,...|all", "replays of these cells")->delimiter(',');
}

void add_report(CLI::App& app, Words& words) {
    Request& request = words.request;
    app.add_option(
           "REPORT", request.reports,
           "error: error against work and run time, of every method and scene; stability: stiff and "
           "extreme cases, each judged; cost: work and time per step of each scene; atlas: maps of outcomes "
           "over two parameters; merge DIR...: the page of the shards in these folders")
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
    app.add_option("--problems", request.problems,
                   "error: contact problems of FCLib instead of our own frozen ones: a file or a folder (.hdf5)")
        ->type_name("FILE|DIR");
    app.add_option("--beside", request.beside,
                   "error: other engines on the same scenes, a CSV file with the columns of error.csv; with "
                   "--problems other "
                   "solvers on these, with those of problems.csv")
        ->type_name("FILE");
    app.add_option("--export", request.exported,
                   "error: write frozen problems of our scenes there, as JSON, and those of contacts as FCLib")
        ->type_name("DIR");
    add_verdict_files(app, request);
    add_pieces(app, request);
}

void add_check(CLI::App& app, Words& words) {
    Request& request = words.request;
    CheckRequest& check = request.check;
    app.add_option("FOLDER", check.folders,
                   "folders of `render`, or folders of such: each is rendered again as its config.json says");
    app.add_option("--against", check.against,
                   "compare the PNG files of FOLDER with those of this folder instead; nothing is rendered")
        ->type_name("DIR");
    app.add_option("--tolerance", check.tolerance,
                   "LEVELS[:SHARE%],...: how many pixels may differ by more than so many levels of 255 "
                   "[equal where program and driver are the same, else 2:0.05%,16:0.005%]")
        ->type_name("LIST");
    app.add_option("--flip", check.flip, "largest mean FLIP error instead: what a person would see, 0 to 1")
        ->type_name("N");
    app.add_option("--physics", check.physics,
                   "hash: the state at the end is equal to the bit; M: poses are within M metres and radians of "
                   "trajectory.csv in the folder; off [hash]")
        ->type_name("hash|M|off");
    app.add_flag("--update", check.update,
                 "accept the new pictures and summaries: prints what differs and replaces it");
    app.add_option("--jobs", check.jobs, "folders that are checked at once [1]")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
    add_given(app, request.given, "gl", "osmesa|egl", "OpenGL back end [as in the config.json]", "Options");
    app.add_option("--out", request.out, "folder for the page and its pictures [out/check]")->type_name("DIR");
    add_verdict_files(app, request);
}

void add_doctor(CLI::App& app, Words& words) {
    app.add_option("--out", words.request.out, "write the test picture to this file (.png)")->type_name("FILE");
    app.add_flag("--json", words.request.json, "print JSON: for each finding whether it is ok, and the line");
}

struct CommandWords {
    Request::Command command;
    const char* name;
    const char* description;
    void (*add_options)(CLI::App&, Words&);
};

constexpr std::array command_table{
    CommandWords{Request::Command::list, "list", "the scenes: what happens, their parameters, what each is made of",
                 add_list},
    CommandWords{Request::Command::scene, "scene", "prints a scene as a JSON file that run and render accept",
                 add_scene},
    CommandWords{Request::Command::family, "family",
                 "families of scenes; with a name prints a member, drawn at random, as a scene file", add_family},
    CommandWords{Request::Command::run, "run", "physics only: CSV files and a summary", add_run},
    CommandWords{Request::Command::render, "render", "PNG frames or stills, without a display", add_render},
    CommandWords{Request::Command::figures, "figures",
                 "the figures of the paper's sections 8, 10 and 12, and ours, as one page", add_figures},
    CommandWords{Request::Command::report, "report", "measurements of many runs, as CSV files and a page of plots",
                 add_report},
    CommandWords{Request::Command::check, "check", "renders folders of pictures again and says what differs",
                 add_check},
    CommandWords{Request::Command::doctor, "doctor",
                 "what is installed here: libraries, programs, font; whether pictures can be rendered", add_doctor},
};

// CLI11 would list all unexpected arguments; one line with the nearest known name helps more.
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

Request::Command command_of(const CLI::App& app) {
    const auto named = [&](const CommandWords& words) { return app.get_name() == words.name; };
    return std::ranges::find_if(command_table, named)->command;
}

void check_scenes(const Request& request) {
    using enum Request::Command;
    const bool one = request.command == run || request.command == scene;
    if (request.families.size() > 1) {
        throw UsageError(fmt::format("family {}: must be one family at a time", fmt::join(request.families, " ")));
    }
    if ((one || (request.command == render && request.joined.empty())) && request.scenes.empty()) {
        throw UsageError("a scene is missing (see `pushfactor list`)");
    }
    if (one && request.scenes.size() > 1) {
        throw UsageError(fmt::format("scene {}: must be one scene at a time", fmt::join(request.scenes, " ")));
    }
}

}  // namespace

std::string quoted(const std::string& word) {
    const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::optional<Request> parse_command_line(int argc, char** argv) {
    Words words;
    CLI::App app("Constraint based rigid bodies (Tamis & Maggiore 2015), simulated and rendered offscreen.\n",
                 "pushfactor");
    app.set_version_flag("--version", "pushfactor " + version_text(), "Print the version and the commit");
    app.footer(exit_statuses);
    app.require_subcommand(0, 1);
    app.allow_extras();
    for (const CommandWords& command : command_table) {
        CLI::App& added = *app.add_subcommand(command.name, command.description);
        command.add_options(added, words);
        added.allow_extras();
        added.footer(exit_statuses);
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

    Request& request = words.request;
    request.command = command_of(chosen);
    request.command_line = "pushfactor";
    for (int i = 1; i < argc; ++i) request.command_line += " " + quoted(argv[i]);
    if (words.config) add_config(*words.config, request.given);
    if (const auto* named = request.given.find("scene"); named && request.scenes.empty()) {
        request.scenes.push_back(named->text);
    }
    check_scenes(request);
    return request;
}

}  // namespace pushfactor::demos
