// The commands of the program: a type for each with what it reads, one file each. Reading a command takes its
// options from the words and refuses what has no effect in their combination, with UsageError; carry_out() does the
// work and throws the exceptions of errors.h.
#pragma once

#include "demos/commands/words.h"
#include "demos/options/choices.h"
#include "demos/reports/study.h"
#include "demos/runs/recorder.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pushfactor::demos::commands {

struct List {
    bool names_only = false;

    bool operator==(const List&) const = default;
};

struct Scene {
    std::string scene;
    GivenOptions given;

    bool operator==(const Scene&) const = default;
};

struct Family {
    std::string name;    // all families are listed when empty
    GivenOptions given;  // seed and parameters

    bool operator==(const Family&) const = default;
};

struct Run {
    std::string scene;
    GivenOptions given;
    RunFiles files;
    std::optional<std::string> summary;  // path; "-" is standard output
    bool timing = false;

    bool operator==(const Run&) const = default;
};

struct Render {
    std::vector<std::string> scenes;
    GivenOptions given;
    RunFiles files;
    std::optional<std::string> summary, video, out, from_trajectory;
    std::optional<Shard> shard;
    bool timing = false;
    bool png = true;

    bool operator==(const Render&) const = default;
};

// render --join
struct Join {
    std::vector<std::string> folders;
    std::string video;

    bool operator==(const Join&) const = default;
};

struct Figures {
    std::vector<std::string> names;  // all when empty
    std::optional<std::string> out, width, letters, theme, background;
    std::optional<int> dpi, samples;

    bool operator==(const Figures&) const = default;
};

struct Report {
    std::string name;
    std::optional<std::string> out;
    reports::StudyRequest request{};  // without folders and note

    bool operator==(const Report&) const = default;
};

// report merge
struct Merge {
    std::vector<std::string> folders;
    std::optional<std::string> out, junit, markdown;

    bool operator==(const Merge&) const = default;
};

struct Check {
    std::vector<std::string> folders;
    std::optional<std::string> against;  // folder of pictures that are not rendered
    std::optional<std::string> tolerance, flip, physics, out, junit, markdown;
    std::optional<int> jobs;
    bool update = false;
    bool allow_not_compared = false;
    GivenOptions given;  // gl

    bool operator==(const Check&) const = default;
};

struct Doctor {
    std::optional<std::string> out;
    bool json = false;

    bool operator==(const Doctor&) const = default;
};

void carry_out(const List& command);
void carry_out(const Scene& command);
void carry_out(const Family& command);
void carry_out(const Run& command);
void carry_out(const Render& command);
void carry_out(const Join& command);
void carry_out(const Figures& command);
void carry_out(const Report& command);
void carry_out(const Merge& command);
void carry_out(const Check& command);
void carry_out(const Doctor& command);

using AnyCommand = std::variant<List, Scene, Family, Run, Render, Join, Figures, Report, Merge, Check, Doctor>;

// What the command line offers under one word.
struct Entry {
    std::string name, names, description;  // names: of what is no option, in the usage line
    std::vector<Option> (*options)();
    AnyCommand (*read)(Words& words);
    std::string (*appendix)() = nullptr;  // of the help text
};

extern const Entry list_entry, scene_entry, family_entry, run_entry, render_entry, figures_entry, report_entry,
    check_entry, doctor_entry;

}  // namespace pushfactor::demos::commands
