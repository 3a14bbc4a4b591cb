#include "demos/commands/command_line.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/platform/version.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/suggest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace pushfactor::demos {

namespace {

using commands::Entry;

const char* const exit_statuses =
    "\nExit status: 0 done; 1 the run failed; 2 wrong usage or bad input; 3 a check failed;\n"
    "4 an output could not be written; 5 the simulation became non-finite.\n";

std::string help_of_program(const std::vector<Entry>& entries) {
    std::string text =
        "Constraint based rigid bodies (Tamis & Maggiore 2015), simulated and rendered offscreen.\n\n"
        "Usage: pushfactor COMMAND [OPTIONS]; pushfactor COMMAND --help\n\nCommands:\n";
    for (const Entry& entry : entries) {
        text += fmt::format("  {:<12}{}\n", entry.name, entry.description.substr(0, entry.description.find(". ")));
    }
    return text +
           "\nOptions:\n  --help       Print this text\n  --version    Print the version and the commit\n"
           "  --reference  Print all commands and options as a page in Markdown\n" +
           exit_statuses;
}

std::string usage_of(const Entry& entry) {
    return fmt::format("pushfactor {}{} [OPTIONS]", entry.name, entry.names.empty() ? "" : " " + entry.names);
}

std::string help_of_command(const Entry& entry) {
    return fmt::format("{}\n\nUsage: {}\n{}{}{}", entry.description, usage_of(entry), help_of(entry.options()),
                       entry.appendix ? entry.appendix() : "", exit_statuses);
}

// An Entry has these texts in common with others.
struct SharedPart {
    std::string title, text;
    std::vector<std::string> commands;
};

// The options of a command by group, and its appendix.
std::vector<SharedPart> parts_of(const Entry& entry) {
    std::vector<SharedPart> parts;
    for (const auto& [group, rows] : markdown_of(entry.options())) parts.push_back({group, rows, {entry.name}});
    if (entry.appendix) {
        const std::string text = entry.appendix();  // "\nTitle:\n  lines\n"
        const std::size_t colon = text.find(":\n");
        parts.push_back({text.substr(1, colon - 1), "```\n" + text.substr(colon + 2) + "```\n", {entry.name}});
    }
    return parts;
}

// As GitHub makes it of a heading.
std::string anchor_of(const std::string& title) {
    std::string anchor;
    for (const char c : title) {
        if (c == ' ') anchor += '-';
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_') {
            anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    return anchor;
}

bool asks_for_help(const std::string& word) {
    return word == "--help" || word == "-h";
}

const Entry& find_entry(const std::vector<Entry>& entries, const std::string& word) {
    const std::vector<std::string> names = names_of(entries);
    if (word.starts_with('-')) {
        throw UsageError("{}: must come after the command, one of {}", word, fmt::join(names, ", "));
    }
    const auto found = std::ranges::find(entries, word, &Entry::name);
    if (found != entries.end()) return *found;
    throw UsageError("{}: no such command; there are {}{}", word, fmt::join(names, ", "), suggestion(word, names));
}

}  // namespace

std::vector<Entry> command_entries() {
    using namespace commands;
    return {list_entry,    scene_entry,  family_entry, run_entry,   render_entry,
            figures_entry, report_entry, check_entry,  doctor_entry};
}

std::string reference_text() {
    const std::vector<Entry> entries = command_entries();
    std::vector<SharedPart> parts;  // equal ones are one
    for (const Entry& entry : entries) {
        for (SharedPart& part : parts_of(entry)) {
            const auto same = std::ranges::find_if(parts, [&](const SharedPart& other) {
                return other.title == part.title && other.text == part.text;
            });
            if (same == parts.end()) {
                parts.push_back(std::move(part));
            } else {
                same->commands.push_back(entry.name);
            }
        }
    }
    std::string text =
        "# Commands and options\n\nPrinted by `pushfactor --reference`, from the same tables as `pushfactor "
        "COMMAND --help`. Defaults are in\nbrackets; of options without one the preset decides "
        "([table](README.md#presets)). Files and exit statuses are\nin [FORMATS.md](FORMATS.md), examples in the "
        "[guide](README.md).\n";
    std::vector<std::string> headings = names_of(entries);
    for (const SharedPart& part : parts) {
        if (part.commands.size() > 1) headings.push_back(part.title);
    }
    for (std::string& heading : headings) heading = fmt::format("[{}](#{})", heading, anchor_of(heading));
    text += fmt::format("\n{}\n", fmt::join(headings, " -\n"));
    for (const Entry& entry : entries) {
        text += fmt::format("\n## {}\n\n`{}`: {}.\n", entry.name, usage_of(entry), entry.description);
        std::vector<std::string> links;
        for (const SharedPart& part : parts) {
            if (std::ranges::find(part.commands, entry.name) == part.commands.end()) continue;
            if (part.commands.size() > 1) {
                links.push_back(fmt::format("[{}](#{})", part.title, anchor_of(part.title)));
            } else {
                text += (part.title == "Options" ? "\n" : fmt::format("\n{}:\n\n", part.title)) + part.text;
            }
        }
        if (!links.empty()) text += fmt::format("\nAlso: {}.\n", fmt::join(links, ", "));
    }
    for (const SharedPart& part : parts) {
        if (part.commands.size() == 1) continue;
        text += fmt::format("\n## {}\n\nOf {}.\n\n{}", part.title, fmt::join(part.commands, ", "), part.text);
    }
    return text;
}

std::optional<CommandLine> parse_command_line(const std::vector<std::string>& words) {
    const std::vector<Entry> entries = command_entries();
    if (words.empty()) {
        throw UsageError("a command is missing: one of {} (see --help)", fmt::join(names_of(entries), ", "));
    }
    const auto only_print = [](const std::string& text) {
        print(text);
        return std::nullopt;
    };
    if (asks_for_help(words.front())) return only_print(help_of_program(entries));
    if (words.front() == "--version") return only_print("pushfactor " + version_text() + "\n");
    if (words.front() == "--reference") return only_print(reference_text());
    const Entry& entry = find_entry(entries, words.front());
    if (std::any_of(words.begin(), std::ranges::find(words, "--"), asks_for_help)) {
        return only_print(help_of_command(entry));
    }
    Words given(entry.name, entry.options(), {words.begin() + 1, words.end()});
    commands::AnyCommand command = entry.read(given);
    given.refuse_rest(entry.name);
    return CommandLine{std::move(command), given.outputs(), given.folders()};
}

}  // namespace pushfactor::demos
