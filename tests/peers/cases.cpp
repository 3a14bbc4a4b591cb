#include "tests/peers/cases.h"

namespace pushfactor::tests::peers {

namespace {

std::vector<Case> narrow_cases(const std::string& scenes) {
    const auto file = [&](const std::string& name) { return "'" + scenes + "/" + name + ".json'"; };
    const Ours shipped{"as shipped", "", false};
    const Ours original{"--preset paper", "--preset paper", false};
    const Ours divided{"--substeps auto", "--substeps auto", false};
    const Ours four{"--substeps 4", "--substeps 4", false};
    const Ours rattle{"--scheme rattle", "--scheme rattle", true};
    return {
        {"stack",
         "Five cubes fall onto each other, up to 2 cm off, 60 s",
         "stack --jitter 0.02",
         3600,
         standing,
         {shipped, original}},
        {"tower",
         "Twenty cubes that touch, up to 2 cm off, 60 s",
         "stack --count 20 --gap 0 --jitter 0.02",
         3600,
         standing,
         {shipped, original}},
        {"heavy",
         "A cube of 1000 kg on one of 1 kg, 10 s",
         "heavy-on-light --mass-ratio 1000",
         600,
         standing,
         {shipped, original}},
        {"chain-light",
         "Twenty links of 1 m with balls of 1 kg, from the horizontal, 10 s",
         "chain",
         600,
         chain,
         {shipped, four, divided, rattle}},
        {"chain",
         "Twenty links of 1 m, 1000 kg at the end, from the horizontal, 10 s",
         "chain --end-mass 1000",
         600,
         chain,
         {shipped, four, divided, rattle}},
        {"wave",
         "Fifty pendulums against the exact pendulum, 60 s",
         "pendulum-wave",
         3600,
         wave,
         {shipped, rattle}},
        {"free-box",
         "A box of 1 x 0.4 x 0.2 m turns freely at (5, 0, 4.5) rad/s, 60 s",
         file("free-box"),
         3600,
         turning,
         {shipped, divided}},
        {"free-rod",
         "A rod of 0.1 x 2 x 0.1 m turns freely at (3, 30, 0) rad/s, 60 s",
         file("free-rod"),
         3600,
         turning,
         {shipped, divided}},
        {"parting",
         "Five cubes inside each other, half in the ground, 10 s",
         "intersecting-stack",
         600,
         parting,
         {shipped, original}},
        {"plate-50",
         "Balls of 0.5 m against a plate of 0.1 m at 50 m/s, eight phases of the step",
         file("plate-50"),
         60,
         through,
         {shipped}},
        {"plate-200", "The same at 200 m/s", file("plate-200"), 60, through, {shipped}},
        {"funnel", "Twenty balls in a funnel, 20 s", "funnel", 1200, heap, {shipped}, last_seconds},
    };
}

}  // namespace

std::vector<Case> cases(const std::string& scenes) {
    std::vector<Case> all = narrow_cases(scenes);
    for (const Case& pile : pile_cases()) all.push_back(pile);
    return all;
}

}  // namespace pushfactor::tests::peers
