// Figure 11, "Sphere resting in a V shaped corner", with the rows of J of section 12.2 as the engine has them.
#include "demos/figures/figure_output.h"
#include "demos/pictures/camera/framing.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/to_glm.h"
#include "demos/runs/session.h"

#include <fmt/format.h>

namespace pushfactor::demos::figures {

namespace {

using engine::Vector3;

const Colour colours[2] = {*find_colour("vermilion"), *find_colour("blue")};

std::string text_of(const Vector3& v) {
    // Avoids "-0.000".
    const auto part = [](double x) { return fmt::format("{:.3f}", std::abs(x) < 5e-4 ? 0.0 : x); };
    return fmt::format("[ {},  {},  {} ]", part(v.x()), part(v.y()), part(v.z()));
}

// The linear part of a row for the ball, which may be body a or b.
Vector3 axis_of(const engine::ConstraintRow& row, int ball) {
    return row.body_a == ball ? row.jacobian.a.head<3>() : row.jacobian.b.head<3>();
}

struct Corner {
    Vector3 axes[2]{};                   // rows of J for the ball
    double lambda[2]{};                  // N
    Vector3 points[2]{};                 // m
    Vector3 velocity = Vector3::Zero();  // m/s
};

Corner look_at(const Simulation& run) {
    const BuiltScene& scene = run.scene();
    const int ball = static_cast<int>(scene.bodies.size()) - 1;
    Corner corner{.velocity = velocity(scene.world.bodies[static_cast<std::size_t>(ball)])};
    const auto sites = scene.contacts->sites();
    for (std::size_t i = 0; i < 2; ++i) {
        corner.axes[i] = axis_of(scene.world.rows()[sites[i].normal_row], ball);
        const auto& lambda = scene.world.lambda();
        corner.lambda[i] = lambda(static_cast<Eigen::Index>(sites[i].normal_row), lambda.cols() - 1);
        corner.points[i] = sites[i].position;
    }
    return corner;
}

// Into the upper left of the sheet.
void draw(FigureOutput& output, const Simulation& run, const Corner& corner, const pictures::Size& size,
          Sheet& sheet) {
    constexpr double arrow = 0.42;  // m, drawn length of a unit vector
    const View view = run.scene().view;
    renderer::Picture picture = pictures::draw_list(run.scene(), view);
    picture.mark_scale = 1.5f;
    for (std::size_t i = 0; i < 2; ++i) {
        const Vector3 tip = corner.points[i] + arrow * corner.axes[i];
        picture.arrows.push_back({.from = pictures::to_glm(corner.points[i]),
                                  .to = pictures::to_glm(tip),
                                  .colour = pictures::to_glm(colours[i])});
        picture.dots.push_back(
            {.position = pictures::to_glm(corner.points[i]), .colour = pictures::to_glm(colours[i])});
    }
    sheet.paste(output.offscreen(), std::move(picture), size, output.samples(), 0, 0);
    const float letters = output.letters(50.0f);
    for (std::size_t i = 0; i < 2; ++i) {
        const Vector3 beside = corner.points[i] - 0.13 * corner.axes[i];
        const Eigen::Vector2d place =
            pictures::place_in_picture(beside, view, static_cast<double>(size.width) / size.height);
        sheet.texts.push_back(
            {i == 0 ? "a" : "b",
             {static_cast<float>(place.x() * size.width), static_cast<float>(place.y() * size.height)},
             letters,
             true});
    }
}

}  // namespace

SectionContent sphere_in_corner(FigureOutput& output, const Figure& figure) {
    const Choices choices = run_of("corner", {});
    Simulation run(choices);
    play(run, before_end);
    const Corner corner = look_at(run);
    const Vector3 sum = corner.lambda[0] * corner.axes[0] + corner.lambda[1] * corner.axes[1];

    // The texts stand beside the picture, or below it where a column of paper is too narrow for both.
    const float letters = output.letters(62.0f);
    const bool beside = static_cast<float>(output.width()) > 60.0f * letters;
    const pictures::Size size = beside ? pictures::Size{output.width() / 2, output.width() * 2 / 5}
                                       : pictures::Size{output.width(), output.width() * 3 / 5};
    const int below = beside ? 0 : static_cast<int>(24.0f * letters);
    Sheet sheet = Sheet::blank(output.width(), size.height + below, output.format());
    draw(output, run, corner, size, sheet);
    glm::vec2 at =
        beside ? glm::vec2(static_cast<float>(size.width) + 2.0f * letters, 0.18f * static_cast<float>(size.height))
               : glm::vec2(0.0f, static_cast<float>(size.height) + 1.5f * letters);
    const auto line = [&](const std::string& text, float space) {
        sheet.texts.push_back({text, at, letters});
        at.y += space * letters;
    };
    line("One row of J for each contact (12.2):", 2.2f);
    line("a = " + text_of(corner.axes[0]), 1.6f);
    line("b = " + text_of(corner.axes[1]), 3.0f);
    line("What each contact gives:", 2.2f);
    line(fmt::format("λ = [ {:.3f},  {:.3f} ] N", corner.lambda[0], corner.lambda[1]), 3.0f);
    line("Together they carry the ball (12.2.2):", 2.2f);
    line("Jᵀ λ = a λ₁ + b λ₂ = " + text_of(sum) + " N", 3.0f);
    line("and it does not move along either (12.2.1):", 2.2f);
    line(fmt::format("J v = [ {:.1e},  {:.1e} ] m/s", corner.axes[0].dot(corner.velocity),
                     corner.axes[1].dot(corner.velocity)),
         1.0f);

    SectionContent content = output.save(sheet, figure);
    content.caption = fmt::format(
        "A ball of 1 kg at rest between walls inclined by 45 and 30 degrees, without friction, after {:.0f} s; the "
        "rows are those of the engine's last step. Gravity is 10 m/s^2, so the contact forces must add up to 10 N "
        "upwards.",
        run.sample().time);
    content.commands = {"pushfactor run assets/scenes/corner.json --rows rows.csv"};
    return content;
}

}  // namespace pushfactor::demos::figures
