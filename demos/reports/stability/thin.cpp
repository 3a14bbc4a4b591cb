// Thin bodies that lie, stand and lean.
#include "demos/reports/stability/cases.h"
#include "demos/reports/stability/scenes.h"

namespace pushfactor::demos::reports::stability {

namespace {

constexpr double height = 0.6;            // m, of a standing card
constexpr double plank_thickness = 0.02;  // m

// A card on its long edge, leaning by `angle` towards +x (-x if negative): its lower edge is on the ground, and
// `at` [m] is the x coordinate of the farthest point of its upper end.
BodyDescription leaning_card(const std::string& name, double angle, double at) {
    const double sine = elementary::sin(std::abs(angle));
    const double cosine = elementary::cos(angle);
    const double reach = 0.5 * (height * sine + card_thickness * cosine);
    const double middle = 0.5 * (height * cosine + card_thickness * sine);
    BodyDescription card =
        box(name, {card_thickness, height, 1.0}, {angle > 0.0 ? at - reach : at + reach, middle, 0});
    card.orientation = inclined(-angle);
    return card;
}

BodyDescription support() {
    return wall("box", {0.4, 0.4, 1.2}, {0.2, 0.2, 0});
}

// Upright on its long edge, flat against a box.
SceneDescription card_upright() {
    SceneDescription scene =
        touching("card-upright", {ground(), support(), leaning_card("card", 0.0, card_thickness)}, 0.5);
    scene.bodies.back().position.x() = -0.5 * card_thickness;
    return scene;
}

SceneDescription plank_on_supports() {
    const Vector3 size(0.1, 0.3, 0.3);
    return touching("plank-on-supports",
                    {ground(), wall("left", size, {-0.8, 0.15, 0}), wall("right", size, {0.8, 0.15, 0}),
                     box("plank", {2, plank_thickness, 0.2}, {0, 0.3 + 0.5 * plank_thickness, 0})},
                    0.4);
}

SceneDescription lying(const std::string& name, const std::string& body, double width, double angle) {
    BodyDescription thin = box(body, {1, card_thickness, width}, {0, 0.5 * card_thickness, 0});
    thin.orientation = turned(angle);
    return touching(name, {ground(), thin}, 0.5);
}

}  // namespace

SceneDescription card_leaning(double angle) {
    SceneDescription scene = touching("card-leaning", {ground(), support(), leaning_card("card", angle, 0.0)});
    // Moved along x until its face touches the edge of the box.
    BodyDescription& card = scene.bodies.back();
    const Vector3 face = card.orientation * Vector3::UnitX();
    const Vector3 point = card.position + 0.5 * card_thickness * face;
    card.position.x() += face.dot(Vector3(0, 0.4, 0) - point) / face.x();
    scene.view = {.eye = {-6, 5, 14}};
    return scene;
}

SceneDescription card_house(double angle) {
    return touching("card-house", {ground(), leaning_card("left", angle, 0.0), leaning_card("right", -angle, 0.0)},
                    0.4);
}

std::vector<Chapter> thin_chapters() {
    Chapter chapter{"thin", "Cards, a plank and a rod that lie, stand and lean, 20 s: stand"};
    const auto add = [&chapter](const SceneDescription& scene, double thickness, bool quick = false) {
        // Energy bar: a body of 1 kg lowered by a hundredth of its thickness.
        const Checks checks{{"max_penetration_m", 0.002, 0.0, thickness},
                            {"max_off_axis_m", 1e-3},
                            {"energy_change_at_end_j", 0.01, 0.0, usual_gravity * thickness}};
        for (const Steps& steps : both_steps)
            chapter.add(steps, scene.name, scene, "20", "rest", checks, of_both("rest"), quick);
    };
    add(lying("card-lying", "card", height, 0.0), card_thickness);
    add(card_upright(), card_thickness);
    add(card_leaning(0.25), card_thickness);
    add(card_house(0.3), card_thickness, true);
    add(plank_on_supports(), plank_thickness);
    add(lying("rod-lying", "rod", card_thickness, 0.5), card_thickness);
    return {chapter};
}

}  // namespace pushfactor::demos::reports::stability
