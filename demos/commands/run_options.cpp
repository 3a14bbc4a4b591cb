#include "demos/commands/run_options.h"

#include "demos/base/platform/messages.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/numbers.h"
#include "demos/options/simulation_options.h"
#include "demos/runs/simulation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::commands {

namespace {

const char* const output_group = "Output files (- is standard output)";

std::string preset_help() {
    std::string help = "preset that the options start from";
    for (const Preset& preset : presets()) help += fmt::format("; {}: {}", preset.name, preset.description);
    return help + "; overrides the method options of files [default]";
}

}  // namespace

std::vector<Option> simulation_option_table() {
    const std::string group = "Simulation";
    std::vector<Option> table{{"preset", "NAME", preset_help(), group}};
    for (const SimulationOption& option : simulation_options()) {
        table.push_back({option.name, option.placeholder, option.help, group,
                         option.name == measured_option ? OptionKind::reads : OptionKind::value});
    }
    table.push_back({"config", "FILE", "read options from this JSON file; the command line takes precedence", group,
                     OptionKind::reads});
    for (const std::string& name : parameter_names()) table.push_back({name, "N", "", ""});
    return table;
}

std::vector<Option> output_option_table() {
    const auto file = [](const char* name, const char* help) {
        return Option{name, "FILE", help, output_group, OptionKind::writes};
    };
    return {
        file("csv", "one line per step: energies, speeds, penetration, residual, counts"),
        file("trajectory", "one line per body and step (per body and frame with --fps)"),
        file("rows", "one line per constraint row and step, with its force"),
        file("errors", "one line per body with measured motion and step: its distance from that"),
        file("summary", "the summary as JSON [run: standard output]"),
        file("replay", "an HTML page that plays the run in a browser; at most 60 frames per second, or --fps"),
        {"replay-data", "all|poses", "poses: a smaller replay without velocities and forces [all]", output_group},
        file("glb", "the run as a glTF file for Blender and other programs; 60 keys per second, or --fps"),
        {"measure", "NAME",
         "also compute this number of the summary, which takes longer than the run (null without it): "
         "angle_error_rms_deg of pendulum-wave compares with the exact motion; may be repeated",
         output_group, OptionKind::list},
        file("save-state", "the final state, as a scene file that resumes the run"),
        {"timing", "", "CPU time of the steps in the CSV and the summary; the run uses one thread", output_group},
    };
}

std::vector<Option> frame_option_table(unsigned uses, const std::string& group) {
    std::vector<Option> table;
    for (const FrameOption& option : frame_options()) {
        if ((option.uses & uses) == 0) continue;
        table.push_back({option.name, option.placeholder, option.help, group});
    }
    return table;
}

GivenOptions take_simulation(Words& words, std::vector<std::string>& scenes, bool has_threads) {
    GivenOptions given;
    std::vector<std::string> names = simulation_option_names();
    const std::vector<std::string> parameters = parameter_names();
    names.insert(names.end(), parameters.begin(), parameters.end());
    for (const std::string& name : names) {
        const bool counts = has_threads || name != "threads";
        const auto text = words.take(name, counts, "without --timing, which takes one thread");
        if (text) given.add(name, *text, "--" + name);
    }
    for (const FrameOption& option : frame_options()) {
        if (const auto text = words.peek(option.name)) given.add(option.name, *text, "--" + option.name);
    }
    if (const auto config = words.take("config")) add_config(*config, given);
    if (const auto* named = given.find("scene")) {
        if (scenes.empty()) {
            scenes.push_back(named->text);
        } else if (std::ranges::find(scenes, named->text) == scenes.end()) {
            note(fmt::format("{} {}: has no effect, the command names {}", named->field, named->text,
                             scenes.front()));
        }
    }
    if (scenes.empty()) throw UsageError("a scene is missing (see `pushfactor list`)");
    for (const std::string& scene : scenes) {
        if (!find_scene(scene)) words.reads(scene);
        require_parameters(scene, given);
    }
    return given;
}

void take_frames(Words& words, unsigned uses) {
    for (const FrameOption& option : frame_options()) {
        if ((option.uses & uses) != 0 && words.given(option.name)) words.take(option.name);
    }
}

RunFiles take_files(Words& words) {
    RunFiles files;
    files.csv = words.take("csv");
    files.trajectory = words.take("trajectory");
    files.rows = words.take("rows");
    files.errors = words.take("errors");
    files.save_state = words.take("save-state");
    files.measures = words.take_all("measure");
    files.glb = words.take("glb");
    files.replay = words.take("replay");
    words.take("replay-data", files.replay.has_value(), "with --replay");
    files.replay_poses_only = words.take_word("replay-data", {"all", "poses"}) == "poses";
    files.command = words.line();
    return files;
}

void require_shown_overlays(const Words& words, const Shown& outputs) {
    const auto text = words.peek("overlay");
    const auto overlay = text ? parse_overlay(*text) : std::nullopt;
    if (!overlay || outputs.pictures) return;
    for (const OverlayItem& item : *overlay) {
        const bool glb = outputs.glb && !colours_bodies(item.kind) && item.kind != OverlayKind::trails;
        if (glb || (outputs.replay && is_in_replays(item.kind))) continue;
        throw UsageError("--overlay {}: must be of pictures; {} does not show it", name_of(item.kind),
                         outputs.glb      ? "a glTF file"
                         : outputs.replay ? "a replay"
                                          : "a replay with --replay-data poses");
    }
}

void note_cut_time(const Sequence& sequence, const GivenOptions& given) {
    const Settings& settings = sequence.panels.front().choices.settings;
    const long steps = whole_steps(settings);
    const auto* const seconds = given.find("seconds");
    if (sequence.frames.front().are_stills()) {
        const long last = sequence.last_step(0);
        if (last == steps || !seconds || !seconds->is_typed()) return;
        note(fmt::format("{} {}: the run ends with the last of --at, after {} s", seconds->field, seconds->text,
                         to_text(settings.dt * Rational{last, 1})));
        return;
    }
    const double time = static_cast<double>(steps) * settings.dt.value();
    if (std::abs(time - settings.seconds) <= 1e-9 * settings.seconds) return;
    note(fmt::format("seconds {}: cut to {} {} of {} s, {:.6g} s", to_text(settings.seconds), steps,
                     steps == 1 ? "step" : "steps", to_text(settings.dt), time));
}

std::string scene_parameters_help() {
    std::string text = "\nScene parameters:\n";
    for (const SceneEntry& scene : catalogue()) {
        if (scene.parameters.empty()) continue;
        text += fmt::format("  {}\n", scene.name);
        for (const Parameter& parameter : scene.parameters) {
            text += fmt::format("    {:<25} {}\n", fmt::format("--{} {}", parameter.name, parameter.placeholder),
                                parameter.help);
        }
    }
    return text;
}

const std::string& only_scene(const std::vector<std::string>& scenes) {
    if (scenes.size() == 1) return scenes.front();
    throw UsageError("scene {}: must be one scene at a time", fmt::join(scenes, " "));
}

}  // namespace pushfactor::demos::commands
