// Measured motion beside computed motion, each number with the noise of its measurement: tosses of a cube, throws
// of dice, packings, and motions that are known in closed form.
#include "demos/reports/reality/sections.h"
#include "demos/text/suggest.h"

#include <fmt/format.h>

#include <array>

namespace pushfactor::demos::reports {

namespace {

struct Part {
    const char* name;
    void (*add)(StudyRun& run);
};
constexpr std::array parts{Part{"closed-forms", reality::add_closed_forms}, Part{"tosses", reality::add_tosses},
                           Part{"dice", reality::add_dice}, Part{"packings", reality::add_packings}};

void make_reality(StudyRun& run) {
    for (const auto& [name, add] : parts) {
        if (run.request().wants(name)) add(run);
    }
    run.write_page(fmt::format(
        "How far rigid bodies with Coulomb friction and one number for restitution go. What has a solution is "
        "computed to its digits. A tossed cube can be followed through its bounces to about 13 % of its edge, with "
        "one friction and one restitution for all of them; where it ends is right for four of five, because after "
        "some bounces a hair decides. What many throws have in common, shares of dice and volumes of heaps, does "
        "not hang on the hair: there two numbers come near to what is measured, though not everywhere within its "
        "error. What they cannot tell is what a real impact does with an edge: in reality restitution depends on "
        "speed, on the place that is hit, and on which other point touches. Made with {}.{}",
        run.machine(), run.quick() ? " This is the quick report: few tosses, throws and bodies." : ""));
}

}  // namespace

Study reality_study() {
    return {.name = "reality", .title = "beside measured motion", .parts = names_of(parts), .make = make_reality};
}

}  // namespace pushfactor::demos::reports
