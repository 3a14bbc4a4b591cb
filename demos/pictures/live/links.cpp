#include "demos/pictures/live/links.h"

#include "demos/base/platform/assets.h"
#include "demos/base/platform/shell_words.h"
#include "demos/base/text/html.h"
#include "demos/base/text/rational.h"
#include "demos/options/frame_options.h"
#include "demos/options/named_run.h"
#include "demos/options/simulation_options.h"
#include "demos/pictures/live/live_run.h"
#include "demos/scenes/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace pushfactor::demos::pictures::live {

namespace {

// Options with a value; those without one show nothing.
OptionTexts options_among(const std::vector<std::string>& words) {
    OptionTexts options;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i].starts_with("--") && !words[i + 1].starts_with("--")) {
            options.emplace_back(words[i].substr(2), words[i + 1]);
        }
    }
    return options;
}

std::string text_of(const OptionTexts& options, std::string_view name, const std::string& fallback = "") {
    const auto found = std::ranges::find(options, name, &OptionTexts::value_type::first);
    return found == options.end() ? fallback : found->second;
}

// The options that decide the run; the page knows no others.
OptionTexts deciding(const SceneEntry& scene, const OptionTexts& options) {
    const std::vector<std::string> known = simulation_option_names();
    OptionTexts kept;
    std::ranges::copy_if(options, std::back_inserter(kept), [&](const auto& option) {
        const std::string& name = option.first;
        return is_on_menu(name) &&
               (std::ranges::find(known, name) != known.end() ||
                std::ranges::find(scene.parameters, name, &Parameter::name) != scene.parameters.end());
    });
    return kept;
}

// That is shown last: of --at, else the end of the run.
long last_step(const OptionTexts& options) {
    const std::string times = text_of(options, "at", text_of(options, "seconds", "10"));
    const auto time = parse_rational(times.substr(times.rfind(',') + 1));
    const auto step = parse_rational(text_of(options, "dt", "1/60"));
    return time && step ? static_cast<long>((*time / *step).value() + 1e-9) : 0;
}

// What the page shows of the overlays, and whether its camera shows all bodies.
std::string shown_by(const OptionTexts& options) {
    std::string kinds;
    for (const OverlayItem& item :
         parse_overlay(text_of(options, "overlay")).value_or(std::vector<OverlayItem>())) {
        if (is_in_replays(item.kind)) kinds += (kinds.empty() ? "" : ",") + std::string(name_of(item.kind));
    }
    return (kinds.empty() ? "" : "&show=" + kinds) + (text_of(options, "camera") == "fit" ? "&fit=on" : "");
}

std::string address_of(const std::string& scene, const OptionTexts& deciding, const OptionTexts& all) {
    std::string address = fmt::format("{}#scenes&scene={}", live_page().filename().string(), scene);
    for (const auto& [name, text] : deciding) address += fmt::format("&{}={}", name, html::link_to(text));
    return address + fmt::format("&step={}", last_step(all)) + shown_by(all);
}

}  // namespace

std::vector<PageLink> page_links(std::string_view command) {
    const std::vector<std::string> words = words_of(command);
    if (words.size() < 3 || words[0] != "pushfactor" || (words[1] != "run" && words[1] != "render")) return {};
    const SceneEntry* const scene = find_scene(words[2]);
    if (!scene) return {};
    const OptionTexts options = options_among(words);
    const OptionTexts own = deciding(*scene, options);
    const auto comparison = parse_comparison(text_of(options, "compare"));
    if (!comparison) return {{address_of(words[2], own, options), ""}};
    std::vector<PageLink> links;
    for (const std::string& value : comparison->values) {
        OptionTexts with = own;
        std::erase_if(with, [&](const auto& option) { return option.first == comparison->option; });
        with.emplace_back(comparison->option, value);
        links.push_back({address_of(words[2], with, options), comparison->option + " " + value});
    }
    return links;
}

}  // namespace pushfactor::demos::pictures::live
