// A scene: a world of the parts that it needs, and what one has to know to look at it. Engine types only, so that
// tests and reports use the same scenes as the program.
#pragma once

#include "demos/settings.h"
#include "engine/contact_stage.h"
#include "engine/world.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

// What is drawn for a body.
struct Drawn {
    enum class Form { box, ground };

    int body = 0;
    Form form = Form::box;
    engine::Vector3 half_size = engine::Vector3::Zero();  // m, boxes
    int colour = 0;                                       // index into the palette
};

// Where one looks from, and at what [m].
struct View {
    engine::Vector3 eye = engine::Vector3(0, 5, 10);
    engine::Vector3 target = engine::Vector3::Zero();
};

// A scene whose bodies should come to stand one on the other.
struct Standing {
    double side = 0.0;                 // m, edge of a body
    std::vector<double> rest_heights;  // m, of the centres, one a movable body
};

struct Scene {
    std::string name;
    engine::World world;
    engine::Vector3 gravity = engine::Vector3(0, -10, 0);  // m/s^2, what the world's force source applies
    const engine::ContactStage* contacts = nullptr;        // part of the world; null when bodies never touch

    std::vector<Drawn> drawn;
    View view;
    std::optional<Standing> standing;
};

}  // namespace pushfactor::demos
