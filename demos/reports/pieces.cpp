#include "demos/reports/pieces.h"

#include "demos/pictures/replay/replay.h"
#include "demos/platform/output_file.h"
#include "demos/platform/plain_name.h"
#include "demos/platform/version.h"
#include "demos/scenes/scene_file.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <mutex>

namespace pushfactor::demos::reports {

namespace {

namespace fs = std::filesystem;

std::string version_of_pieces() {
    static const std::string version = version_text();
    const bool exact = version.find("-dirty") == std::string::npos && version.find("unknown") == std::string::npos;
    // Content, because another build of modified sources has the same version.
    static const std::string content =
        exact ? "" : fmt::format(", program {:016x}", text_hash(read_bytes_of("/proc/self/exe").value_or("")));
    return version + content;
}

fs::path folder_of_version(const fs::path& folder) {
    return folder / "pieces" / PieceStore::version_folder();
}

fs::path note_in(const fs::path& folder) {
    return folder_of_version(folder) / "report.json";
}

fs::path place_of(const fs::path& folder, const std::string& key) {
    const std::string name = fmt::format("{:016x}", text_hash(key));
    return folder_of_version(folder) / name.substr(0, 2) / (name.substr(2) + ".json");
}

void write_into_folder(const fs::path& path, const std::string& text) {
    make_folder_of(path);
    write_file(path, text);
}

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

std::string replay_of(const std::string& scene, const OptionTexts& options, const StopCheck& check) {
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

std::optional<StoredPiece> PieceStore::find(const std::string& key) const {
    for (const fs::path& folder : folders_) {
        const auto text = read_bytes_of(place_of(folder, key));
        if (!text) continue;
        Json json = json_or_null(*text);
        const bool whole = json.is_object() && json.value("key", "") == key && json.contains("result") &&
                           json.value("made_with", "") == version_of_pieces();
        if (whole) return StoredPiece{json.value("machine", ""), std::move(json["result"])};
    }
    return std::nullopt;
}

void PieceStore::put(const std::string& key, const Json& result) const {
    const Json json{{"key", key}, {"made_with", version_of_pieces()}, {"machine", machine_}, {"result", result}};
    write_into_folder(place_of(folders_.front(), key), json_text(json, -1) + "\n");
}

void PieceStore::put_note(const std::string& text) const {
    const fs::path path = note_in(folders_.front());
    if (read_bytes_of(path) != text) write_into_folder(path, text);
}

std::optional<std::string> PieceStore::note_of(const fs::path& folder) {
    return read_bytes_of(note_in(folder));
}

std::string PieceStore::version_folder() {
    return plain_name(version_of_pieces(), '-', ".");  // "0.1.0-commit-0123456789ab"
}

std::set<std::string> PieceStore::versions_in(const fs::path& folder) {
    std::set<std::string> versions;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder / "pieces", error)) {
        if (entry.is_directory()) versions.insert(entry.path().filename());
    }
    return versions;
}

}  // namespace pushfactor::demos::reports
