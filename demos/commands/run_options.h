// The options that run, render and scene have in common.
#pragma once

#include "demos/commands/words.h"
#include "demos/options/choices.h"
#include "demos/runs/recorder.h"
#include "demos/runs/session.h"

#include <string>
#include <vector>

namespace pushfactor::demos::commands {

// --preset, the table of simulation options, parameters of scenes and --config.
std::vector<Option> simulation_option_table();

// --csv and the other files of a run.
std::vector<Option> output_option_table();

// The frame options that serve one of these outputs (FrameUse), under a heading.
std::vector<Option> frame_option_table(unsigned uses, const std::string& group);

// Takes the simulation options and reads --config. `scenes` is that of the config file if it was empty;
// `has_threads` is false for runs on one thread. Frame options are in the result, but not yet taken.
GivenOptions take_simulation(Words& words, std::vector<std::string>& scenes, bool has_threads);

// Takes the frame options that serve one of these outputs (FrameUse).
void take_frames(Words& words, unsigned uses);

// Takes --csv, --trajectory and the other files that are made step by step.
RunFiles take_files(Words& words);

struct Shown {
    bool pictures = false, glb = false, replay = false;
};

// Throws UsageError for an overlay of the command line that none of the outputs shows.
void require_shown_overlays(const Words& words, const Shown& outputs);

// Says how long the run is if --seconds is no whole number of steps, or if it ends before with the last still.
void note_cut_time(const Sequence& sequence, const GivenOptions& given);

// Parameters of each scene, for help texts.
std::string scene_parameters_help();

// Throws UsageError unless there is one scene.
const std::string& only_scene(const std::vector<std::string>& scenes);

}  // namespace pushfactor::demos::commands
