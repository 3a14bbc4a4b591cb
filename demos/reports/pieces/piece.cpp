#include "demos/reports/pieces/piece.h"

#include "demos/scenes/scene_file.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
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
    auto found = known.find(scene);
    if (found == known.end()) {
        const Choices choices = run_of(scene, {});
        const std::uint64_t hash = text_hash(scene_file_text(spelled_out(choices)));
        found = known.emplace(scene, fmt::format("{} {:016x}", choices.description.name, hash)).first;
    }
    return found->second;
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
    if (!json.is_string()) return json.get<double>();
    const std::string& text = json.get_ref<const std::string&>();
    const double infinity = std::numeric_limits<double>::infinity();
    return text == "inf" ? infinity : text == "-inf" ? -infinity : std::numeric_limits<double>::quiet_NaN();
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

}  // namespace pushfactor::demos::reports
