// What the command line asks for, before it is understood.
#pragma once

#include "demos/choices.h"

#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos {

struct Request {
    enum class Command { list, scene, run, render };

    Command command = Command::list;
    std::vector<std::string> scenes;
    GivenOptions given;                                         // simulation, scene parameters and frames
    std::optional<std::string> csv, trajectory, rows, summary;  // paths, "-" is standard output
    std::optional<std::string> out;                             // folder for frames
    bool timing = false;
    bool names_only = false;  // list
};

}  // namespace pushfactor::demos
