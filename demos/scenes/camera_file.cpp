#include "demos/scenes/camera_file.h"

#include "demos/text/json_file.h"

namespace pushfactor::demos {

void describe(Fields& fields, View& view) {
    const auto place = [](const JsonReader& json) {
        const engine::Vector3 point = json.vector();
        if (point.cwiseAbs().maxCoeff() > 1e9) json.refuse("three numbers from -1e9 to 1e9");
        return point;
    };
    fields.must("eye_m", view.eye, place);
    fields.must("target_m", view.target, place);
    fields.may("field_of_view_deg", view.field_of_view, between(1.0, 120.0),
               view.field_of_view != View{}.field_of_view);
    fields.if_any("floor_m", view.floor, between(-1e9, 1e9));
}

View read_camera(const JsonReader& json) {
    const auto view = read_object<View>(json);
    if (view.eye == view.target) json.at("target_m").refuse("another point than eye_m");
    return view;
}

View read_camera_file(const std::filesystem::path& file) {
    const Json json = read_json_file(file, "--camera " + file.string());
    return read_camera(JsonReader(json, file.string()));
}

}  // namespace pushfactor::demos
