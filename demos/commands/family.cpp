#include "demos/scenes/families/family.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/numbers.h"
#include "demos/base/text/suggest.h"
#include "demos/commands/commands.h"
#include "demos/scenes/scene_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pushfactor::demos::commands {

namespace {

using Kind = families::Family;

void print_all() {
    for (const Kind& family : families::families()) {
        std::string text = fmt::format("{}\n    {}\n    {}\n", family.name, family.sentence, family.why);
        for (const families::FamilyParameter& parameter : family.parameters) {
            const Parameter& range = parameter.range;
            text += fmt::format("    {:<20} {} [{} to {}]\n", fmt::format("--{} {}", range.name, range.placeholder),
                                range.help, to_text(range.low), to_text(range.high));
        }
        print(text + "\n");
    }
}

const Kind& family_named(const std::string& name) {
    require_known("family", name, names_of(families::families()));
    return *families::find_family(name);
}

const Parameter seed_range{.name = "seed", .placeholder = "N", .help = "", .low = 0, .high = 1e9, .whole = true};

// Throws UsageError for a parameter of another family.
const Parameter& range_of(const Kind& family, const std::string& name, const GivenOptions::Given& given) {
    if (name == seed_range.name) return seed_range;
    std::vector<std::string> own;
    for (const families::FamilyParameter& parameter : family.parameters) {
        if (parameter.range.name == name) return parameter.range;
        own.push_back("--" + std::string(parameter.range.name));
    }
    throw UsageError("{} {}: family {} has no such parameter; it has {}", given.field, given.text, family.name,
                     fmt::join(own, ", "));
}

// Throws UsageError, also for a value that is not allowed.
families::Choice choice_of(const Family& command) {
    const Kind& family = family_named(command.name);
    families::Choice choice;
    for (const auto& [name, given] : command.given.all()) {
        const Parameter& range = range_of(family, name, given);
        ParameterValues values{std::span<const Parameter>()};
        if (!values.set(range, given.text)) {
            throw UsageError("{} {}: must be {}", given.field, given.text, range.allowed());
        }
        if (&range == &seed_range) {
            choice.seed = values.whole(name);
        } else {
            choice.given.emplace_back(name, given.text);
        }
    }
    return choice;
}

std::vector<Option> family_options() {
    std::vector<Option> table{{"seed", "N", "random seed [1]"}};
    for (const Kind& family : families::families()) {
        for (const families::FamilyParameter& parameter : family.parameters) {
            const std::string name(parameter.range.name);
            if (std::ranges::find(table, name, &Option::name) == table.end()) table.push_back({name, "N", "", ""});
        }
    }
    return table;
}

AnyCommand read_family(Words& words) {
    const std::vector<std::string> names = words.take_names();
    if (names.size() > 1) throw UsageError("family {}: must be one family at a time", fmt::join(names, " "));
    Family command;
    if (names.empty()) return command;
    command.name = names.front();
    family_named(command.name);
    for (const Option& option : family_options()) {
        if (const auto text = words.take(option.name)) command.given.add(option.name, *text, "--" + option.name);
    }
    choice_of(command);
    return command;
}

}  // namespace

void carry_out(const Family& command) {
    if (command.name.empty()) return print_all();
    write_file("-", scene_file_text(draw_member(family_named(command.name), choice_of(command)).prospect.scene));
}

const Entry family_entry{
    "family", "[NAME]",
    "lists the families of random scenes and their parameters; with a name prints a member as a scene "
    "file. Parameters are options, drawn at random where they are not given",
    family_options, read_family};

}  // namespace pushfactor::demos::commands
