#include "demos/reports/pieces/piece.h"

#include "demos/pictures/replay/replay.h"
#include "demos/scenes/scene_file.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <mutex>

namespace pushfactor::demos::reports {

namespace {

// The content of a scene that is a file, with everything that it includes. Read once, as a report has many runs of
// it.
std::string content_of(const std::string& scene) {
    static std::mutex mutex;
    static std::map<std::string, std::string> known;
    const std::lock_guard lock(mutex);
    std::string& content = known[scene];
    if (content.empty()) {
        const Choices choices = run_of(scene, {});
        content =
            fmt::format("{} {:016x}", choices.description.name, text_hash(scene_file_text(spelled_out(choices))));
    }
    return content;
}

}  // namespace

std::string run_key(const std::string& scene, const OptionTexts& options) {
    return command_text("run", find_scene(scene) ? scene : content_of(scene), options);
}

Json json_number(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

double number_in(const Json& json) {
    return json.is_string() ? std::stod(json.get_ref<const std::string&>()) : json.get<double>();
}

Json json_numbers(const std::vector<double>& values) {
    Json json = Json::array();
    for (const double value : values) json.push_back(json_number(value));
    return json;
}

std::vector<double> numbers_in(const Json& json) {
    std::vector<double> values;
    for (const Json& one : json) values.push_back(number_in(one));
    return values;
}

std::string replay_of(const std::string& scene, const OptionTexts& options, const std::function<void()>& check) {
    const StagedFile file(std::filesystem::temp_directory_path() / "replay", ".html");  // removed at the end
    const Choices choices = run_of(scene, options);
    Session session({.panels = {{.label = "", .choices = choices}}, .frames = {pictures::replay_frames(choices)}});
    pictures::Replay replay({.file = file.path(),
                             .poses_only = true,
                             .command = command_text("run", scene, options) + " --replay replay.html"},
                            session);
    try {
        session.play({&replay}, [&](const Simulation&) {
            check();
            return true;
        });
        replay.finish();
    } catch (const NonFiniteError& error) {
        replay.finish(error.what());
    }
    return read_bytes_of(file.path()).value_or("");
}

}  // namespace pushfactor::demos::reports
