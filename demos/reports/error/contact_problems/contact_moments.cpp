#include "demos/reports/error/contact_problems/contact_moments.h"

#include "demos/options/named_run.h"
#include "demos/reports/study.h"
#include "demos/scenes/families/family.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::error {

namespace {

// While things fall or meet, and later, when most of them lie.
constexpr double early = 0.5, late = 2.0;  // s

// A whole step is one system; the cone is Coulomb's law.
void freeze_whole_steps(Settings& settings, double seconds) {
    settings.scheme = Scheme::whole;
    settings.friction_model = FrictionModel::cone;
    settings.seconds = seconds;
}

ContactMoment moment_of(const std::string& name, Choices choices, double seconds) {
    freeze_whole_steps(choices.settings, seconds);
    return {fmt::format("{}_at_{}s", name, seconds), std::move(choices)};
}

Choices member_of(const std::string& family, int seed, const families::GivenValues& values) {
    Choices choices;
    choices.settings = preset_settings("default");
    choices.settings.rest = false;
    choices.description =
        draw_member(*families::find_family(family), {.seed = seed, .given = values}).prospect.scene;
    return choices;
}

}  // namespace

std::vector<ContactMoment> contact_moments(bool quick) {
    std::vector<ContactMoment> moments;
    for (int i = 1; i <= (quick ? 1 : 5); ++i) {
        const std::string number = std::to_string(i);
        for (const double seconds : quick ? std::vector{early} : std::vector{early, late}) {
            const auto add = [&](const std::string& kind, Choices choices) {
                moments.push_back(moment_of(kind + "_" + number, std::move(choices), seconds));
            };
            add("stack", run_of("stack", {{"count", std::to_string(5 * i)}, {"jitter", "0.01"}, {"seed", number}}));
            add("heap", member_of("mixed", i, {{"count", std::to_string(20 * i)}}));
            add("wall",
                member_of("wall", i, {{"rows", std::to_string(2 + i)}, {"columns", std::to_string(3 + i)}}));
            add("cards", member_of("card-house", i, {{"storeys", number}}));
            add("arch", run_of("arch", {{"voussoirs", std::to_string(5 + 4 * i)}}));
        }
    }
    return moments;
}

FrozenProblem freeze_contacts(const ContactMoment& moment, const std::function<void()>& check) {
    Simulation run(moment.choices);
    play(run, [&](const Simulation& now) {
        check();
        return before_end(now);
    });
    return {moment.name, run.scene().world};
}

}  // namespace pushfactor::demos::reports::error
