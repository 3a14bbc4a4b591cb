#include "demos/options/comparison.h"

#include "demos/base/text/errors.h"
#include "tests/catch.h"

using namespace pushfactor::demos;

namespace {

std::vector<ComparedRun> panels_of(std::initializer_list<std::pair<const char*, const char*>> options) {
    GivenOptions given;
    for (const auto& [name, text] : options) given.add(name, text, std::string("--") + name);
    return compared_runs("stack", given);
}

}  // namespace

TEST_CASE("panels differ in what is compared and in nothing else") {
    const auto panels = panels_of({{"beta", "0.4"}, {"compare", "push=none,single-frame"}});
    REQUIRE(panels.size() == 2);
    CHECK(panels[0].label == "push none");
    CHECK(panels[0].choices.settings.contacts.kind == pushfactor::engine::PushKind::none);
    CHECK(panels[1].choices.settings.contacts.kind == pushfactor::engine::PushKind::single_frame);
    for (const ComparedRun& panel : panels) CHECK(panel.choices.settings.contacts.beta == 0.4);
}

TEST_CASE("presets and the scene's own parameters can be compared, and come before what a file says") {
    CHECK(panels_of({{"compare", "preset=paper,default"}})[0].choices.settings.preset == "paper");
    GivenOptions given;
    given.add("count", "3", "count in my.json");
    given.add("compare", "count=2,4", "--compare");
    const auto panels = compared_runs("stack", given);
    CHECK(panels[0].choices.description.bodies.size() == 3);
    CHECK(panels[1].choices.description.bodies.size() == 5);
}

TEST_CASE("what cannot be compared is refused with the reason") {
    CHECK_THROWS_WITH(panels_of({{"compare", "pusch=none,persistent"}}), Catch::Contains("did you mean push?"));
    CHECK_THROWS_WITH(panels_of({{"compare", "push=none,sideways"}}),
                      Catch::Contains("--compare push sideways: must be one of none, persistent, single-frame"));
    CHECK_THROWS_AS(panels_of({{"compare", "push=none"}}), UsageError);
    CHECK_THROWS_AS(panels_of({{"compare", "seconds=1,2"}}), UsageError);
    CHECK_THROWS_AS(panels_of({{"compare", "poke=1,2"}}), UsageError);
}

TEST_CASE("a config of compared runs holds what was given, so that it makes the same panels again") {
    GivenOptions given;
    given.add("compare", "preset=paper,default", "--compare");
    given.add("beta", "0.5", "--beta");
    const auto panels = compared_runs("stack", given);
    const std::string config = config_text(panels.front().choices, given);
    CHECK(config ==
          "{\n  \"scene\": \"stack\",\n  \"beta\": 0.5,\n  \"compare\": \"preset=paper,default\",\n  \"camera\": "
          "\"fit\"\n}\n");
}
