// Command and option texts as given on the command line, not yet interpreted.
#pragma once

#include "demos/options/choices.h"
#include "demos/runs/run_files.h"

#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos {

// Of the command check.
struct CheckRequest {
    std::vector<std::string> folders;
    std::optional<std::string> against;  // folder of pictures that are not rendered
    std::optional<std::string> tolerance, flip;
    std::string physics = "hash";
    bool update = false;
    int jobs = 1;
};

// Of report atlas --grid.
struct GridWords {
    std::optional<std::string> scene, x, y, measure;
    std::vector<std::string> set, replays;
};

struct Request {
    enum class Command { list, scene, family, run, render, figures, report, check, doctor };

    Command command = Command::list;
    std::vector<std::string> scenes;
    std::vector<std::string> families;  // names; all are listed when empty
    GivenOptions given;                 // simulation, parameters of scene or family, and frames
    RunFiles files;
    std::optional<std::string> summary;  // path; "-" is standard output
    std::optional<std::string> out;      // folder for frames, figures or reports; file of doctor
    std::optional<std::string> video;    // path
    std::optional<std::string> glb;      // path
    bool png = true;                     // write frames as PNG files
    std::optional<std::string> replay;   // path
    bool replay_poses_only = false;
    std::string command_line;  // as typed, with quotes where a shell needs them
    bool timing = false;
    bool names_only = false;  // list

    std::vector<std::string> figures;   // names; all when empty
    std::string figure_width = "1600";  // pixels, or a length on paper
    std::optional<int> figure_dpi;
    std::optional<std::string> figure_letters;  // length
    int figure_samples = 32;
    std::string figure_theme = "light", figure_background = "plain";

    std::vector<std::string> reports;  // name; or "merge" and folders
    std::vector<std::string> parts;    // of the report; all when empty
    bool quick = false;
    bool json = false;                           // doctor
    std::optional<std::string> junit, markdown;  // paths; of report stability and check
    CheckRequest check;
    std::optional<std::string> problems;         // file or folder of contact problems
    std::optional<std::string> beside;           // CSV file of other solvers on these
    std::optional<std::string> exported;         // folder for frozen problems
    std::optional<std::string> shard;            // "K/N"; of report and render
    std::optional<int> report_jobs;              // pieces at once
    std::optional<std::string> from_trajectory;  // path; of render
    std::vector<std::string> joined;             // folders of frames; of render
    GridWords grid;
};

}  // namespace pushfactor::demos
