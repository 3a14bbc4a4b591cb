#include "demos/reports/cost/cases.h"

#include "demos/scenes/catalogue.h"

#include <array>

namespace pushfactor::demos::reports::cost {

namespace {

constexpr double settled = 10.0;  // s
constexpr double falling = 1.0;   // s

struct Size {
    const char* name;
    const char* scene;
    OptionTexts options;
    bool large = false;
};

const std::array sizes{
    Size{"stack of 20, touching", "stack", {{"count", "20"}, {"gap", "0"}}},
    Size{"stack of 40, touching, jittered", "stack", {{"count", "40"}, {"gap", "0"}, {"jitter", "0.01"}}, true},
    Size{"funnel of 200", "funnel", {{"count", "200"}}},
    Size{"funnel of 2000", "funnel", {{"count", "2000"}}, true},
};

}  // namespace

std::string CostCase::file_name() const {
    std::string text;
    for (const char c : name) {
        if (c != ',') text += c == ' ' ? '-' : c;
    }
    return text;
}

std::vector<CostCase> cost_cases(bool quick) {
    std::vector<CostCase> cases;
    for (const SceneEntry& scene : catalogue()) {
        const std::string name(scene.name);
        cases.push_back({name, name, {}, settled});
        if (name == "funnel") cases.push_back({"funnel, falling", name, {}, falling});
        for (const Size& size : sizes) {
            if (name != size.scene || (quick && size.large)) continue;
            cases.push_back({size.name, name, size.options, settled});
            if (name == "funnel")
                cases.push_back({size.name + std::string(", falling"), name, size.options, falling});
        }
    }
    return cases;
}

}  // namespace pushfactor::demos::reports::cost
