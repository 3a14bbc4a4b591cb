// A push that is not solved well works against gravity (paper 8.1).
#include "demos/runs/simulation.h"
#include "demos/scenes/families/family.h"
#include "tests/catch.h"

#include <algorithm>

using namespace pushfactor::demos;

namespace {

struct Energy {
    double rise = 0.0;  // J, the largest above the start
    double gain = 0.0;  // J, the largest beyond the work done from outside
};

Energy energy_of_wall(Settings settings) {
    const auto member =
        families::draw_member(*families::find_family("wall"),
                              {.given = {{"rows", "16"}, {"columns", "12"}, {"gap", "0"}, {"friction", "0.5"}}});
    Simulation run(build_scene(member.prospect.scene, settings), settings);
    const auto sum = [&] { return run.sample().kinetic_energy + run.sample().potential_energy; };
    const double start = sum();
    Energy seen;
    for (int step = 0; step < 120; ++step) {
        run.advance();
        seen.rise = std::max(seen.rise, sum() - start);
        seen.gain = std::max(seen.gain, run.sample().energy_gain);
    }
    return seen;
}

Settings with(pushfactor::engine::PushKind push) {
    Settings settings;
    settings.contacts.kind = push;
    settings.scheme = Scheme::whole;
    settings.solver = "pgs";
    settings.iterations = 16;
    return settings;
}

}  // namespace

TEST_CASE("8.1: a push that too few sweeps have solved makes energy of a wall, without one there is none") {
    using pushfactor::engine::PushKind;
    CHECK(energy_of_wall(with(PushKind::none)).rise < 0.01);
    CHECK(energy_of_wall(with(PushKind::persistent)).rise > 10.0);
    CHECK(energy_of_wall(with(PushKind::single_frame)).rise > 10.0);
}

TEST_CASE("8.1: the energy account books what an under-solved push lifts beyond the overlap as a gain") {
    using pushfactor::engine::PushKind;
    CHECK(energy_of_wall(with(PushKind::single_frame)).gain > 10.0);
}

TEST_CASE("8.1: pushed apart from the velocities, in small steps, the same wall gains nothing") {
    CHECK(energy_of_wall({}).gain < 0.01);
}
