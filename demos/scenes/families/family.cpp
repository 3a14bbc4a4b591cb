#include "demos/scenes/families/family.h"

#include "demos/base/text/numbers.h"
#include "demos/base/text/text_hash.h"
#include "demos/scenes/families/pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pushfactor::demos::families {

namespace {

// A separate seed for each parameter of each family, so that drawn values are independent of
// each other.
int seed_of(int seed, std::string_view family, std::string_view parameter, int attempt) {
    const std::uint64_t draw = static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15U +
                               static_cast<std::uint64_t>(attempt) * 0xaf251af3b0f025b5U;
    return static_cast<int>(mixed_bits(fnv_hash(parameter, fnv_hash(family)) + draw) & 0x7fffffffU);
}

// To three digits, for readability.
double rounded(double value) {
    return parse_number(fmt::format("{:.3g}", value)).value_or(value);
}

}  // namespace

std::span<const Family> families() {
    static const std::vector<Family> all{cubes,         boxes,    mixed,        rods,     funnel,   round_tower,
                                         square_tower,  crossed,  wall,         wall_hit, pyramid,  card_house,
                                         ball_on_cubes, dominoes, leaning_slab, stacks,   overhang, seesaw,
                                         taken_out,     plates,   cut_column,   arch,     net};
    return all;
}

const Family* find_family(std::string_view name) {
    const auto all = families();
    const auto found = std::ranges::find(all, name, &Family::name);
    return found == all.end() ? nullptr : &*found;
}

std::string Member::command() const {
    std::string text = "pushfactor family " + std::string(family->name);
    for (const auto& [name, value] : values) text += " --" + name + " " + value;
    return text + " --seed " + std::to_string(seed);
}

std::string drawn_value(const Family& family, const FamilyParameter& parameter, int seed, int attempt) {
    const auto& [range, draw] = parameter;
    Random random(seed_of(seed, family.name, range.name, attempt));
    const double share = random.in(0.0, 1.0);
    if (range.whole && draw == Draw::evenly) {
        return to_text(std::floor(range.low + share * (range.high - range.low + 1.0)));
    }
    double value = range.low + share * (range.high - range.low);
    if (draw == Draw::by_decades)
        value = range.low * elementary::exp(share * elementary::log(range.high / range.low));
    return to_text(std::clamp(range.whole ? std::round(value) : rounded(value), range.low, range.high));
}

Member draw_member(const Family& family, const Choice& choice) {
    Member member{.family = &family, .seed = choice.seed, .values = {}, .prospect = {}};
    ParameterValues values{std::span<const Parameter>()};
    for (const FamilyParameter& parameter : family.parameters) {
        const auto given = std::ranges::find(choice.given, parameter.range.name, &GivenValues::value_type::first);
        const std::string text =
            given != choice.given.end() ? given->second : drawn_value(family, parameter, choice.seed);
        if (!values.set(parameter.range, text)) {
            throw std::invalid_argument(std::string(parameter.range.name) + " " + text + ": must be " +
                                        parameter.range.allowed());
        }
        member.values.emplace_back(parameter.range.name, to_text(values.number(parameter.range.name)));
    }
    Random random(seed_of(choice.seed, family.name, "", 0));
    member.prospect = family.describe(values, random);
    member.prospect.scene.name = std::string(family.name) + "-" + std::to_string(choice.seed);
    member.prospect.scene.contacts = true;
    member.prospect.scene.options["seconds"] = to_text(member.prospect.rest_by + 1.0);
    return member;
}

}  // namespace pushfactor::demos::families
