#include "demos/scenes/camera_file.h"

#include "demos/scenes/vector_json.h"
#include "demos/text/json_file.h"

#include <array>

namespace pushfactor::demos {

std::span<const std::string> camera_keys() {
    static const std::array<std::string, 4> keys{"eye_m", "target_m", "field_of_view_deg", "floor_m"};
    return keys;
}

View read_camera(const JsonReader& json) {
    json.require_object(camera_keys());
    const auto place = [&](const char* key) {
        const engine::Vector3 point = json.at(key).vector();
        if (point.cwiseAbs().maxCoeff() > 1e9) json.at(key).refuse("three numbers from -1e9 to 1e9");
        return point;
    };
    View view{.eye = place("eye_m"), .target = place("target_m")};
    if (json.has("field_of_view_deg")) view.field_of_view = json.at("field_of_view_deg").number(1.0, 120.0);
    if (json.has("floor_m")) view.floor = json.at("floor_m").number(-1e9, 1e9);
    if (view.eye == view.target) json.at("target_m").refuse("another point than eye_m");
    return view;
}

View read_camera_file(const std::filesystem::path& file) {
    const Json json = read_json_file(file, "--camera " + file.string());
    return read_camera(JsonReader(json, file.string()));
}

Json camera_json(const View& view) {
    Json json{{"eye_m", to_json(view.eye)}, {"target_m", to_json(view.target)}};
    if (view.field_of_view != View{}.field_of_view) json["field_of_view_deg"] = view.field_of_view;
    if (view.floor) json["floor_m"] = *view.floor;
    return json;
}

}  // namespace pushfactor::demos
