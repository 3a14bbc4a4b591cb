#include "demos/figures/plot.h"

#include "demos/pages/short_numbers.h"
#include "demos/reports/atlas/atlas.h"
#include "demos/text/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pushfactor::demos::reports::atlas {

namespace {

// Edges of the cells of an axis, halfway between their numbers: one more than there are cells.
std::vector<double> edges_of(const AtlasAxis& axis) {
    std::vector<double> places;
    for (const std::string& value : axis.values)
        places.push_back(axis.logarithmic ? std::log(axis.shown(value)) : axis.shown(value));
    std::vector<double> edges{places[0] - 0.5 * (places[1] - places[0])};
    for (std::size_t i = 1; i < places.size(); ++i) edges.push_back(0.5 * (places[i - 1] + places[i]));
    const std::size_t last = places.size() - 1;
    edges.push_back(places[last] + 0.5 * (places[last] - places[last - 1]));
    if (axis.logarithmic)
        std::ranges::transform(edges, edges.begin(), [](double place) { return std::exp(place); });
    return edges;
}

// For `set xtics (...)`: all values, or about as many as have room.
std::string ticks_of(const AtlasAxis& axis) {
    constexpr std::size_t most = 16;
    const std::size_t every = (axis.values.size() + most - 1) / most;
    std::string text;
    for (std::size_t i = 0; i < axis.values.size(); i += every) {
        const std::string& value = axis.values[i];
        text += fmt::format("{}\"{}\" {}", text.empty() ? "" : ", ", axis.tick(value), axis.shown(value));
    }
    return text;
}

// The number of a cell; a blank where cells are too small or there is none.
std::string text_in_cell(const AtlasMap& map, double value) {
    constexpr std::size_t across = 16, up = 24;
    if (map.x.values.size() > across || map.y.values.size() > up || std::isnan(value)) return " ";
    return short_number(value);
}

// 0xRRGGBB of a name in the palette or of "#RRGGBB".
int number_of(std::string_view colour) {
    if (const auto found = find_colour(colour)) return number_of(*found);
    int number = 0;
    std::from_chars(colour.data() + 1, colour.data() + colour.size(), number, 16);
    return number;
}

// Two blocks, the cells and the theory. Never empty, because gnuplot does not count empty blocks.
std::string data_of(const AtlasMap& map, const std::vector<CellResult>& results, const std::vector<double>& xs,
                    const std::vector<double>& ys) {
    std::string text = "# x,y,x_low,x_high,y_low,y_high,colour,number,ink\n";
    const std::size_t width = map.x.values.size();
    for (std::size_t i = 0; i < results.size(); ++i) {
        const std::size_t column = i % width, row = i / width;
        const OutcomeLook& look = *std::ranges::find(outcome_looks, results[i].outcome, &OutcomeLook::outcome);
        text += fmt::format("{},{},{},{},{},{},{},{},{}\n", map.x.shown(map.x.values[column]),
                            map.y.shown(map.y.values[row]), xs[column], xs[column + 1], ys[row], ys[row + 1],
                            number_of(look.colour), text_in_cell(map, results[i].value), number_of(look.ink));
    }
    text += "\n\n# theory: x,y\n";
    constexpr int points = 400;
    for (int i = 0; i <= points; ++i) {
        const double share = static_cast<double>(i) / points;
        const double x = map.x.logarithmic ? xs.front() * std::pow(xs.back() / xs.front(), share)
                                           : xs.front() + share * (xs.back() - xs.front());
        const double y = map.theory ? map.theory->y(x) : std::nan("");
        text += y >= ys.front() && y <= ys.back() ? fmt::format("{},{}\n", x, y) : "nan,nan\n";
    }
    return text;
}

// Legend of the outcomes on the map: words and colours for gnuplot's word().
std::pair<std::string, std::string> legend_of(const AtlasMap& map, const std::vector<CellResult>& results) {
    std::string words, colours;
    for (const OutcomeLook& look : outcome_looks) {
        if (std::ranges::find(results, look.outcome, &CellResult::outcome) == results.end()) continue;
        words += fmt::format("\"{}\" ", look.outcome == name_of(Outcome::moving) ? map.moving : look.words);
        colours += fmt::format("#{:06x} ", number_of(look.colour));
    }
    return {words, colours};
}

}  // namespace

std::string short_number(double value) {
    if (value == 0.0) return "0";
    const double size = std::abs(value);
    if (size >= 1e-3 && size < 9.95) return fmt::format("{:.2g}", value);
    if (size >= 9.95 && size < 9999.5) return fmt::format("{:.0f}", value);
    return short_cell(fmt::format("{:.0e}", value));
}

Section atlas_section(const AtlasMap& map, const std::vector<CellResult>& results,
                      const std::filesystem::path& folder) {
    const std::string command = command_of(cell_at(map, "X", "Y"));  // of all cells, with X and Y for the values
    Section section{map.name, map.title};
    section.content.caption = fmt::format("{} The numbers: {} of the summary.", map.caption, map.measure.key);
    section.content.commands = {command};
    const std::vector<double> xs = edges_of(map.x), ys = edges_of(map.y);
    const auto [words, colours] = legend_of(map, results);
    const Plot plot{.script = "atlas",
                    .data = map.name + ".dat",
                    .name = map.name,
                    .aspect = 1.5,
                    .variables = {{"heading", map.title},
                                  {"x_axis", map.x.label},
                                  {"y_axis", map.y.label},
                                  {"x_ticks", ticks_of(map.x)},
                                  {"y_ticks", ticks_of(map.y)},
                                  {"x_low", xs.front()},
                                  {"x_high", xs.back()},
                                  {"y_low", ys.front()},
                                  {"y_high", ys.back()},
                                  {"x_logarithmic", map.x.logarithmic ? 1.0 : 0.0},
                                  {"y_logarithmic", map.y.logarithmic ? 1.0 : 0.0},
                                  {"outcomes", words},
                                  {"colours", colours},
                                  {"number_words", map.measure.words},
                                  {"theory", map.theory ? map.theory->label : ""},
                                  {"command", command}}};
    add_plot(plot, data_of(map, results, xs, ys), folder, section.content);
    return section;
}

}  // namespace pushfactor::demos::reports::atlas
