#include "demos/pictures/checks/expectation.h"

#include "demos/base/platform/version.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/json_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <functional>
#include <set>

namespace pushfactor::demos::checks {

namespace {

namespace fs = std::filesystem;

std::string text_at(const Json& json, const char* key) {
    return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
}

std::array<int, 3> version_in(const std::string& program) {
    std::array<int, 3> version{};
    std::sscanf(program.c_str(), "%d.%d.%d", &version[0], &version[1], &version[2]);
    return version;
}

std::string program_of(const Json& summary) {
    return summary.is_object() && summary.contains("made_with") ? text_at(summary["made_with"], "program") : "";
}

std::optional<Json> read_summary(const fs::path& folder) {
    const fs::path file = folder / "summary.json";
    if (!fs::exists(file)) return std::nullopt;
    Json summary = read_json_file(file, file.string());
    const std::string program = program_of(summary);
    if (version_in(program) > version_in(version_text())) {
        throw UsageError("{}: made_with.program {}: must not be newer than this program, {}", file.string(),
                         program, version_number());
    }
    return summary;
}

// The summaries of the panels.
std::vector<Json> panels_of(const Json& summary) {
    if (!summary.contains("panels")) return {summary};
    return summary["panels"].get<std::vector<Json>>();
}

// "beta 0.3 instead of 0.2" for each option that differs.
std::string changed_options(const Json& before, const Json& now) {
    std::string text;
    const auto add = [&](const std::string& name, const std::string& value, const std::string& old) {
        text += fmt::format("{}{} {} instead of {}", text.empty() ? "" : ", ", name, value, old);
    };
    for (const auto& [name, value] : now.items()) {
        if (name == "threads") continue;  // results do not depend on it
        if (!before.contains(name))
            add(name, text_of(value), "none");
        else if (before[name] != value)
            add(name, text_of(value), text_of(before[name]));
    }
    for (const auto& [name, value] : before.items()) {
        if (!now.contains(name)) add(name, "none", text_of(value));
    }
    return text;
}

void compare_panel(const Json& before, const Json& now, const std::string& label, bool hash,
                   std::vector<RunVerdict>& verdicts) {
    if (before.contains("options") && now.contains("options")) {
        const std::string changed = changed_options(before["options"], now["options"]);
        verdicts.push_back({.subject = "options" + label, .holds = changed.empty(), .text = changed});
    } else {
        verdicts.push_back(
            {.subject = "options" + label, .text = "summary.json does not say them", .compared = false});
    }
    if (!hash) return;
    const std::string expected = text_at(before, "state_hash"), found = text_at(now, "state_hash");
    const bool same = expected == found;
    verdicts.push_back({.subject = "physics" + label,
                        .holds = same,
                        .text = same ? "" : fmt::format("state hash {} instead of {}", found, expected)});
}

}  // namespace

bool Expectation::was_made_with(const std::string& driver) const {
    if (!summary) return false;
    const std::string program = program_of(*summary);
    if (program != version_text() || program.find("-dirty") != std::string::npos ||
        program.find("unknown") != std::string::npos) {
        return false;
    }
    return text_at((*summary)["made_with"], "driver") == driver;
}

std::vector<std::string> Expectation::unexpected() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        if (is_png(name) && !sequence.frames.front().has(name)) names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
}

std::vector<fs::path> folders_of_pictures(const fs::path& folder) {
    std::set<fs::path> found;
    bool has_config = false;
    for (const fs::path& below : files_below(folder)) {
        const bool is_config = below.filename() == config_file;
        has_config |= is_config;
        if (is_config || is_png(below)) found.insert(below.parent_path());
    }
    if (!has_config) {
        throw UsageError(
            "check {}: must have a config.json, as `render` writes it, in it or below; pictures "
            "without one are compared with --against",
            folder.string());
    }
    return {found.begin(), found.end()};
}

Expectation read_expectation(const fs::path& folder, const GivenOptions& given) {
    Expectation expected{.folder = folder, .given = given, .sequence = {}, .summary = read_summary(folder)};
    const fs::path config = folder / config_file;
    add_config(config, expected.given);
    const auto* const scene = expected.given.find("scene");
    if (!scene) throw UsageError("{}: scene: must be given", config.string());
    expected.sequence = plan_sequence(scene->text, expected.given);
    return expected;
}

bool is_png(const fs::path& file) {
    std::string extension = file.extension();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension == ".png";
}

std::vector<fs::path> files_below(const fs::path& folder) {
    if (!fs::is_directory(folder)) throw UsageError("check {}: must be a folder", folder.string());
    std::vector<fs::path> files;
    std::set<fs::path> seen;  // links may lead in a circle
    const std::function<void(const fs::path&)> look = [&](const fs::path& here) {
        std::error_code error;
        if (!seen.insert(fs::canonical(here, error)).second) return;
        std::vector<fs::path> entries;
        auto at = fs::directory_iterator(here, error);
        for (; !error && at != fs::end(at); at.increment(error)) entries.push_back(at->path());
        if (error) throw UsageError("check {}: {}", here.string(), error.message());
        std::sort(entries.begin(), entries.end());
        for (const fs::path& entry : entries) {
            if (fs::is_directory(entry, error)) {
                look(entry);
            } else {
                files.push_back(entry);
            }
        }
    };
    look(folder);
    return files;
}

std::vector<RunVerdict> compare_runs(const Expectation& expected, const Json& summary, bool hash) {
    if (!expected.summary) {
        const std::string why = "there is no summary.json";
        std::vector<RunVerdict> verdicts{{.subject = "options", .text = why, .compared = false}};
        if (hash) verdicts.push_back({.subject = "physics", .text = why, .compared = false});
        return verdicts;
    }
    const std::vector<Json> before = panels_of(*expected.summary), now = panels_of(summary);
    std::vector<RunVerdict> verdicts;
    if (before.size() != now.size()) {
        return {{.subject = "options",
                 .holds = false,
                 .text = fmt::format("{} panels instead of {}", now.size(), before.size())}};
    }
    for (std::size_t i = 0; i < now.size(); ++i) {
        const std::string label = now.size() > 1 ? " of " + expected.sequence.panels[i].label : "";
        compare_panel(before[i], now[i], label, hash, verdicts);
    }
    return verdicts;
}

}  // namespace pushfactor::demos::checks
