// Families of scenes: their members are ordinary scenes, and the random choices depend only on the seed.
#include "demos/base/text/numbers.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/scene_file.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/fuzz/members.h"
#include "tests/settings.h"

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::demos::families;
using namespace pushfactor::tests;

namespace {

Member small_member(const Family& family, int seed) {
    return tests::draw_bounded_member(family, {.seed = seed, .small = true});
}

double value_of(const Member& member, std::string_view name) {
    const auto found = std::find_if(member.values.begin(), member.values.end(),
                                    [&](const auto& pair) { return pair.first == name; });
    return parse_number(found->second).value();
}

}  // namespace

TEST_CASE("every member is a scene file that is accepted and read back as it was written") {
    const Folder folder;
    for (const Family& family : families::families()) {
        for (const int seed : {1, 2, 3}) {
            const Member member = small_member(family, seed);
            const SceneDescription& scene = member.prospect.scene;
            INFO(member.command());
            folder.write("member.json", scene_file_text(scene));
            const SceneDescription read = read_scene_file(folder / "member.json");
            CHECK(scene_file_text(read) == scene_file_text(scene));
            const Settings settings = tests::awake_settings("default");
            Simulation simulation(build_scene(read, settings), settings);
            const std::size_t world = scene.distances.empty() ? 0 : 1;  // what bars are fixed to
            CHECK(simulation.scene().world.bodies.size() == scene.bodies.size() + world);
            // No bodies overlap at the start, up to rounding.
            CHECK(simulation.sample().penetration.max < 1e-12);
        }
    }
}

TEST_CASE("a seed gives one member, another seed another one") {
    for (const Family& family : families::families()) {
        const std::string first = scene_file_text(small_member(family, 7).prospect.scene);
        INFO(family.name);
        CHECK(first == scene_file_text(small_member(family, 7).prospect.scene));
        CHECK(small_member(family, 7).values != small_member(family, 8).values);
    }
}

TEST_CASE("what is drawn lies in its range, and fills it") {
    for (const Family& family : families::families()) {
        for (const FamilyParameter& parameter : family.parameters) {
            double lowest = parameter.range.high, highest = parameter.range.low;
            double small_highest = parameter.range.low;
            for (int seed = 0; seed < 30; ++seed) {
                const MemberChoice choice{.seed = seed, .most_bodies = 200};
                const double value = value_of(tests::draw_bounded_member(family, choice), parameter.range.name);
                const double small = value_of(small_member(family, seed), parameter.range.name);
                lowest = std::min(lowest, value);
                highest = std::max(highest, value);
                small_highest = std::max(small_highest, small);
                CHECK(small >= parameter.range.low);
            }
            INFO(family.name << " " << parameter.range.name << ": " << lowest << " to " << highest);
            CHECK(lowest >= parameter.range.low);
            CHECK(highest <= parameter.range.high);
            CHECK(small_highest <= small_range(family, parameter.range).high);
            CHECK(lowest < highest);
        }
    }
}

TEST_CASE("members are drawn again until they have no more bodies than asked for") {
    for (const Family& family : families::families()) {
        for (int seed = 0; seed < 10; ++seed) {
            const Member member = tests::draw_bounded_member(family, {.seed = seed, .most_bodies = 60});
            INFO(member.command());
            CHECK(member.prospect.scene.bodies.size() <= 60);
        }
    }
}

TEST_CASE("a value that is given holds, and changes no other value") {
    const Family& wall = *find_family("wall");
    const Member any = draw_member(wall, {.seed = 5});
    const Member wanted = draw_member(wall, {.seed = 5, .given = {{"rows", "3"}, {"gap", "0"}}});
    CHECK(value_of(wanted, "rows") == 3);
    CHECK(value_of(wanted, "gap") == 0);
    CHECK(value_of(wanted, "columns") == value_of(any, "columns"));
    CHECK(value_of(wanted, "friction") == value_of(any, "friction"));
    CHECK_THROWS_AS(draw_member(wall, {.given = {{"rows", "many"}}}), std::invalid_argument);
}

TEST_CASE("the command of a member prints its scene, which runs") {
    const Folder folder;
    for (const char* const name : {"wall", "rods", "stacks", "funnel"}) {
        const Member member = small_member(*find_family(name), 3);
        const Ended ended = shell(folder, member.command() + " > member.json && pushfactor run member.json");
        INFO(member.command() << "\n" << ended.err);
        CHECK(ended.status == 0);
        CHECK(folder.read("member.json") == scene_file_text(member.prospect.scene));
    }
}

TEST_CASE("without a name the command lists every family and its parameters") {
    const std::string list = run_program("family").out;
    for (const Family& family : families::families()) {
        CHECK(list.find(std::string(family.name) + "\n") != std::string::npos);
        CHECK(list.find(std::string(family.why)) != std::string::npos);
        for (const FamilyParameter& parameter : family.parameters) {
            CHECK(list.find("--" + std::string(parameter.range.name)) != std::string::npos);
        }
    }
}

TEST_CASE("a family, a parameter or a value that there is not is refused in one line") {
    check_refused("family wal", "family wal: must be one of cubes");
    check_refused("family wal", "did you mean wall?");
    check_refused("family wall cubes", "family wall cubes: must be one family at a time");
    check_refused("family wall --rows 2.5", "--rows 2.5: must be a whole number from 2 to 40");
    check_refused("family wall --gap 1", "--gap 1: must be a number from 0 to 0.02");
    check_refused("family wall --planks 3", "--planks 3: family wall has no such parameter; it has --rows");
    check_refused("family wall --row 3", "--row: unknown option; did you mean --rows?");
    check_refused("family wall --seed -1", "--seed -1: must be a whole number from 0 to 1000000000");
}

// What touches carries and sticks, so that the first factorisation finds the forces of all layers.
TEST_CASE("the first step of walls and towers, whose forces are unknown, takes one factorisation") {
    for (const std::string_view family : {"wall", "round-tower", "square-tower", "crossed", "stacks"}) {
        for (const int seed : {1, 2, 3, 4, 5}) {
            const Member member = draw_member(*find_family(family), {.seed = seed});
            INFO(member.command());
            const Settings settings = tests::awake_settings("default");
            Simulation simulation(build_scene(member.prospect.scene, settings), settings);
            const Sample& first = simulation.advance();
            CHECK(first.count.sweeps == 1);  // 12 to 18 from contacts that begin open
            CHECK(first.count.islands_exact == first.count.islands);
            CHECK(first.residual < 1e-12);
        }
    }
}
