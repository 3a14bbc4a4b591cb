#include "demos/scenes/families/family.h"

#include "demos/commands/commands.h"
#include "demos/platform/output_file.h"
#include "demos/scenes/scene_file.h"
#include "demos/text/errors.h"
#include "demos/text/numbers.h"
#include "demos/text/suggest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pushfactor::demos::commands {

namespace {

using families::Family;

std::string range_of(const families::FamilyParameter& parameter) {
    return fmt::format("{} to {}", to_text(parameter.range.low), to_text(parameter.range.high));
}

void print_all() {
    for (const Family& family : families::families()) {
        fmt::print("{}\n    {}\n    {}\n", family.name, family.sentence, family.why);
        for (const families::FamilyParameter& parameter : family.parameters) {
            fmt::print("    {:<20} {} [{}]\n",
                       fmt::format("--{} {}", parameter.range.name, parameter.range.placeholder),
                       parameter.range.help, range_of(parameter));
        }
        fmt::print("\n");
    }
}

const Family& family_of(const std::string& name) {
    if (const Family* const family = families::find_family(name)) return *family;
    std::vector<std::string> names;
    for (const Family& family : families::families()) names.emplace_back(family.name);
    throw UsageError(
        fmt::format("family {}: must be one of {}{}", name, fmt::join(names, ", "), suggestion(name, names)));
}

int seed_of(const GivenOptions::Given& given) {
    const Parameter seed{.name = "seed", .placeholder = "N", .help = "", .low = 0, .high = 1e9, .whole = true};
    ParameterValues values{std::span<const Parameter>()};
    if (!values.set(seed, given.text)) {
        throw UsageError(fmt::format("{} {}: must be {}", given.field, given.text, seed.allowed()));
    }
    return values.whole("seed");
}

void add_value(const Family& family, const std::string& name, const GivenOptions::Given& given,
               families::Choice& choice) {
    const auto found = std::find_if(family.parameters.begin(), family.parameters.end(),
                                    [&](const auto& parameter) { return parameter.range.name == name; });
    if (found == family.parameters.end()) {
        std::vector<std::string> own;
        for (const auto& parameter : family.parameters) own.push_back("--" + std::string(parameter.range.name));
        throw UsageError(fmt::format("{} {}: family {} has no such parameter; it has {}", given.field, given.text,
                                     family.name, fmt::join(own, ", ")));
    }
    if (!ParameterValues(std::span<const Parameter>()).set(found->range, given.text)) {
        throw UsageError(fmt::format("{} {}: must be {}", given.field, given.text, found->range.allowed()));
    }
    choice.given.emplace_back(name, given.text);
}

}  // namespace

void family(const Request& request) {
    if (request.families.empty()) return print_all();
    const Family& family = family_of(request.families.front());
    families::Choice choice;
    for (const auto& [name, given] : request.given.all()) {
        if (name == "seed") {
            choice.seed = seed_of(given);
        } else {
            add_value(family, name, given, choice);
        }
    }
    write_file("-", scene_file_text(draw_member(family, choice).prospect.scene));
}

}  // namespace pushfactor::demos::commands
