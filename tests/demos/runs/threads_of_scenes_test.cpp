// Every scene and a member of every family: the bits do not depend on the number of threads.
#include "demos/options/named_run.h"
#include "demos/scenes/catalogue.h"
#include "tests/catch.h"
#include "tests/fuzz/members.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

using namespace pushfactor;
using namespace pushfactor::demos;

namespace {

std::uint64_t hash_of(const SceneDescription& scene, const Settings& settings, int threads, int steps) {
    Settings with = settings;
    with.threads = threads;
    Simulation simulation(build_scene(scene, with), with);
    for (int i = 0; i < steps; ++i) simulation.advance();
    return engine::state_hash(simulation.scene().world.bodies);
}

}  // namespace

TEST_CASE("every scene has the same bits with one thread and with more", "[threads]") {
    for (const SceneEntry& entry : catalogue()) {
        for (const char* const preset : {"default", "exact"}) {
            INFO(entry.name << ", preset " << preset);
            const Choices choices = run_of(std::string(entry.name), {{"preset", preset}});
            const std::uint64_t one = hash_of(choices.description, choices.settings, 1, 60);
            CHECK(hash_of(choices.description, choices.settings, 2, 60) == one);
        }
    }
    // Large enough that threads share an island.
    const Choices heap = run_of("funnel", {{"count", "700"}, {"rest", "on"}});
    CHECK(hash_of(heap.description, heap.settings, 2, 120) == hash_of(heap.description, heap.settings, 1, 120));
}

TEST_CASE("members of all families have the same bits with one thread and with more", "[threads]") {
    for (const families::Family& family : families::families()) {
        const families::Member member = tests::draw_bounded_member(family, {.seed = 3, .small = true});
        INFO(member.command());
        const Settings settings = tests::awake_settings("default");
        const std::uint64_t one = hash_of(member.prospect.scene, settings, 1, 60);
        CHECK(hash_of(member.prospect.scene, settings, 2, 60) == one);
    }
}
