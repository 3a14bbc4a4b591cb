#include "tests/peers/tosses.h"

#include "demos/reports/reality/tosses.h"
#include "tests/peers/engine.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <iostream>

namespace pushfactor::tests::peers {

namespace {

namespace reality = demos::reports::reality;

Scene scene_of(const reality::Restart& start, const reality::Law& law) {
    Scene scene;
    scene.name = "toss";
    scene.gravity = Vector3(0, -9.81, 0);
    scene.contacts = true;
    scene.step = 1.0 / reality::frames_per_second;
    Body board;
    board.shape = Shape::plane;
    board.friction = law.friction;
    board.restitution = law.restitution;
    board.start.position.y() = law.board;
    scene.fixed.push_back(board);
    scene.movable.push_back(
        {.shape = Shape::box,
         .size = Vector3::Constant(reality::edge),
         .mass = reality::mass,
         .moments = Vector3::Constant(reality::moment_of_inertia),
         .friction = law.friction,
         .restitution = law.restitution,
         .start = {start.pose.position, start.pose.orientation, start.velocity, start.angular_velocity}});
    return scene;
}

reality::Engine engine_of(const Setting& setting) {
    return [&setting](const reality::Restart& start, const reality::Law& law, std::size_t frames) {
        const std::unique_ptr<World> world = setting.build(scene_of(start, law));
        std::vector<reality::Pose> poses{start.pose};
        while (poses.size() < frames) {
            world->step();
            const State now = world->states().front();
            poses.push_back({now.position, now.orientation});
        }
        return poses;
    };
}

void write(const Setting& setting, const reality::Tosses& all, std::ostream& csv) {
    const reality::Engine engine = engine_of(setting);
    const reality::Tosses fitted = reality::half_of(all, 0, false), others = reality::half_of(all, 1, false);
    const reality::LawGrid grid = reality::law_grid(fitted, false);
    std::vector<std::vector<double>> errors;
    for (const double friction : grid.frictions) {
        errors.push_back(reality::errors_with(engine, fitted, grid, friction, [] {}));
        std::cerr << '.';
    }
    std::cerr << '\n';
    const reality::LawFit fit(grid, errors);
    const reality::Judged judged = reality::judge(engine, others, fit.best());
    const std::string name = setting.engine + ", " + setting.name;
    for (const reality::Result& result : reality::results_of(engine, fit, others, judged)) {
        fmt::print(csv, "\"{}\",\"{}\",,{},", name, result.what, result.value);
        if (result.error) fmt::print(csv, "{}", *result.error);
        csv << '\n';
    }
    for (const reality::ErrorsAt& at : reality::errors_over_time(others, judged, fit.best())) {
        const reality::Mean mean = reality::mean_of(at.position);
        fmt::print(csv, "\"{}\",position,{},{},{}\n", name, at.at, mean.value, mean.error);
    }
}

}  // namespace

void write_tosses(const std::string& measured, std::ostream& csv) {
    const reality::Tosses all = reality::read_tosses(measured);
    csv << "engine,what,at_s,value,error\n";
    for (const auto& settings :
         {bullet_settings(), ode_settings(), mujoco_settings(), box3d_settings(), jolt_settings()}) {
        for (const Setting& setting : settings) {
            if (std::ranges::find(setting.cases, "tosses") == setting.cases.end()) continue;
            std::cerr << "tosses: " << setting.engine << ", " << setting.name << ' ';
            write(setting, all, csv);
        }
    }
}

}  // namespace pushfactor::tests::peers
