#include "demos/base/text/palette.h"
#include "demos/figures/plot.h"
#include "demos/reports/error/error.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>
#include <string_view>
#include <tuple>

namespace pushfactor::demos::reports::error {

namespace {

constexpr double least_error = 1e-16;  // rounding: smaller errors are not distinguished
constexpr double aspect = 1.45;
// Size of the area inside the axes in letter widths of the labels; the script draws them in this size.
const Place area(110.0, 100.0 / aspect);

constexpr double letter_height = 1.9;  // of a text line, in letter widths
constexpr double mark = 0.9;           // half the width of a point's mark

using Box = Eigen::AlignedBox2d;

Box around(const Place& centre, double half_width, double half_height) {
    const Place half(half_width, half_height);
    return {centre - half, centre + half};
}

// Sampled finely enough for the height of a label.
bool crosses(const Segment& line, const Box& box) {
    const int samples = static_cast<int>((line.to - line.from).norm() / 0.5) + 1;
    for (int k = 0; k <= samples; ++k) {
        const double share = static_cast<double>(k) / samples;
        if (box.intersects(around(line.from + share * (line.to - line.from), 0.1, 0.1))) return true;
    }
    return false;
}

// Powers of ten at both ends of an axis.
struct Decades {
    double low = 0.0, high = 1.0;

    // 0 at the low end, 1 at the high end.
    double share(double value) const { return (std::log10(value) - low) / (high - low); }
    double at(double share) const { return std::pow(10.0, low + share * (high - low)); }
};

struct Axes {
    Decades error, work;
    bool failures = false;  // some points failed

    Place place(const WorkPoint& point) const {
        return area.cwiseProduct(Place(error.share(point.error), work.share(point.work)));
    }
};

Decades decades(const std::vector<double>& values) {
    if (values.empty() || std::ranges::max(values) <= 0.0) return {};
    const auto [least, most] = std::ranges::minmax(values);
    // Half decades, with a margin so that no point is on the border.
    const double low = 0.5 * std::floor(2.0 * (std::log10(least) - 0.1));
    const double high = 0.5 * std::ceil(2.0 * (std::log10(most) + 0.1));
    return {low, std::max(high, low + 1.0)};
}

Axes axes_of(const WorkPlot& plot) {
    std::vector<double> errors, works;
    Axes axes;
    for (const WorkLine& line : plot.lines) {
        for (const WorkPoint& point : line.points) {
            works.push_back(point.work);
            axes.failures |= point.failed;
            if (!point.failed) errors.push_back(std::max(point.error, least_error));
        }
    }
    axes.error = decades(errors);
    axes.work = decades(works);
    if (axes.failures) axes.error.high += 1.0;
    return axes;
}

// One block of the data file. Never empty, because gnuplot does not count empty blocks.
std::string block(const std::string& what, const std::string& lines) {
    return fmt::format("# {}\n{}\n\n", what, lines.empty() ? "nan,nan,,0\n" : lines);
}

std::string front_block(const WorkPlot& plot, const Axes& axes) {
    if (!plot.front) return block("no Pareto front", "");
    std::vector<WorkPoint> points;
    for (const WorkLine& line : plot.lines) {
        std::ranges::copy_if(line.points, std::back_inserter(points), std::logical_not(), &WorkPoint::failed);
    }
    std::string lines;
    double above = axes.work.at(1.0);
    for (const std::size_t i : pareto_front(points)) {
        lines += fmt::format("{},{}\n{},{}\n", points[i].error, above, points[i].error, points[i].work);
        above = points[i].work;
    }
    if (!points.empty()) lines += fmt::format("{},{}\n", axes.error.at(1.0), above);
    return block("Pareto front as steps: error, work", lines);
}

// The part inside the axes; the rest would be drawn over the margins.
std::vector<WorkPoint> visible(std::vector<WorkPoint> theory, const Axes& axes) {
    std::erase_if(theory, [&](const WorkPoint& point) {
        const double x = axes.error.share(point.error), y = axes.work.share(point.work);
        return !(x >= 0.0 && x <= 1.0 && y >= 0.0 && y <= 1.0);
    });
    return theory;
}

// Labels of the points and, at their upper ends, of the theory lines.
std::string label_block(const WorkPlot& plot, const Axes& axes) {
    std::vector<Place> points;
    std::vector<std::string> texts;
    std::vector<int> colours;
    std::vector<Segment> lines;
    // Coincident points get one label if they belong to one line or have the same value.
    const auto add = [&](const Place& place, const std::string& text, int colour) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool same_point = (points[i] - place).norm() < 1.0;
            if (same_point && (colours[i] == colour || texts[i] == text)) return;
        }
        points.push_back(place);
        texts.push_back(text);
        colours.push_back(colour);
    };
    for (const WorkLine& line : plot.lines) {
        const WorkPoint* last = nullptr;
        for (const WorkPoint& point : line.points) {
            add(axes.place(point), point.label, number_of(line.colour));
            if (last && !point.failed) lines.push_back({axes.place(*last), axes.place(point)});
            last = point.failed ? nullptr : &point;
        }
    }
    for (const WorkLine& theory : plot.theory) {
        const auto seen = visible(theory.points, axes);
        const auto upper = std::ranges::max_element(seen, {}, &WorkPoint::work);
        if (upper != seen.end()) add(axes.place(*upper), theory.name, 0x888888);
    }
    const auto places = place_labels(points, texts, lines, area);
    std::string text;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i]) continue;
        const Place share = places[i]->cwiseQuotient(area);
        text +=
            fmt::format("{},{},{},{}\n", axes.error.at(share.x()), axes.work.at(share.y()), texts[i], colours[i]);
    }
    return block("labels: error, work, text, colour", text);
}

std::string data_text(const WorkPlot& plot, const Axes& axes, const std::string& machine) {
    std::string text = fmt::format("# {}\n", machine), failures;
    for (const WorkLine& line : plot.lines) {
        std::string lines;
        for (const WorkPoint& point : line.points) {
            std::string& where = point.failed ? failures : lines;
            where += fmt::format("{},{},{},{}\n", point.error, point.work, point.label, number_of(line.colour));
        }
        text += block(line.name + ": error, work, knob, colour", lines);
    }
    text += front_block(plot, axes);
    text += label_block(plot, axes);
    text += block("failed, at the border: error, work, knob, colour", failures);
    for (const WorkLine& theory : plot.theory) {
        std::string lines;
        for (const WorkPoint& point : visible(theory.points, axes))
            lines += fmt::format("{},{}\n", point.error, point.work);
        text += block(theory.name + ": error, work", lines);
    }
    return text;
}

}  // namespace

std::pair<const WorkLine*, const WorkPoint*> cheapest(std::span<const WorkLine> lines, double error) {
    std::pair<const WorkLine*, const WorkPoint*> best;
    for (const WorkLine& line : lines) {
        for (const WorkPoint& point : line.points) {
            if (point.failed || !(point.error <= error)) continue;
            if (!best.second || point.work < best.second->work) best = {&line, &point};
        }
    }
    return best;
}

std::string colour_of_solver(const std::string& method) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> colours{
        {{"pgs", "blue"}, {"nncg", "green"}, {"jacobi", "orange"}, {"direct", "violet"}, {"auto", "vermilion"}}};
    for (const auto& [solver, colour] : colours) {
        if (method.substr(0, method.find(',')) == solver) return std::string(colour);
    }
    return "grey";
}

void draw_work_plot(WorkPlot plot, const StudyRun& run, SectionContent& plate) {
    // Zero work has no place on a logarithmic axis.
    for (WorkLine& line : plot.lines) {
        std::erase_if(line.points, [](const WorkPoint& point) {
            return !(point.work > 0.0 && (point.failed || std::isfinite(point.error)));
        });
    }
    const Axes axes = axes_of(plot);
    for (WorkLine& line : plot.lines) {
        for (WorkPoint& point : line.points)
            point.error = point.failed ? axes.error.at(1.0) : std::max(point.error, axes.error.at(0.0));
    }
    std::string names, colours, dashes, marks;
    for (const WorkLine& line : plot.lines) {
        names += "\"" + line.name + "\" ";
        colours += line.colour + " ";
        dashes += fmt::format("{} ", line.dash);
        marks += fmt::format("{} ", line.mark);
    }
    const Plot drawing{.script = "error_against_work",
                       .data = plot.name + ".dat",
                       .name = plot.name,
                       .aspect = aspect,
                       .variables = {{"names", names},
                                     {"colours", colours},
                                     {"dashes", dashes},
                                     {"marks", marks},
                                     {"theories", static_cast<double>(plot.theory.size())},
                                     {"failures", axes.failures ? 1.0 : 0.0},
                                     {"front", plot.front ? 1.0 : 0.0},
                                     {"error_axis", plot.error_axis},
                                     {"work_axis", plot.work_axis},
                                     {"machine", run.machine()},
                                     {"error_low", axes.error.at(0.0)},
                                     {"error_high", axes.error.at(1.0)},
                                     {"work_low", axes.work.at(0.0)},
                                     {"work_high", axes.work.at(1.0)}}};
    add_plot(drawing, data_text(plot, axes, run.machine()), run.folder(), plate);
}

Section work_section(const WorkPlot& plot, const std::string& heading, const std::string& caption,
                     const StudyRun& run, SectionContent plate) {
    plate.caption = caption;
    draw_work_plot(plot, run, plate);
    return {plot.name, heading, std::move(plate)};
}

std::vector<std::optional<Place>> place_labels(const std::vector<Place>& points,
                                               const std::vector<std::string>& labels,
                                               const std::vector<Segment>& lines, const Place& corner) {
    const Box area(Place(0, 0), corner);
    std::vector<Box> taken;
    for (const Place& point : points) taken.push_back(around(point, mark, mark));
    std::vector<std::optional<Place>> places(points.size());
    const auto place = [&](std::size_t i, bool over_lines) {
        const double half = 0.5 * static_cast<double>(labels[i].size());
        const double aside = half + mark + 0.5;
        const double above = 0.5 * letter_height + mark + 0.1;
        for (const Place& offset :
             {Place(aside, 0), Place(-aside, 0), Place(0, above), Place(0, -above), Place(aside, above),
              Place(-aside, -above), Place(-aside, above), Place(aside, -above)}) {
            const Place centre = points[i] + offset;
            const Box box = around(centre, half, 0.5 * letter_height);
            const auto hit = [&box](const Box& other) { return box.intersects(other); };
            const auto cut = [&box](const Segment& line) { return crosses(line, box); };
            if (!area.contains(box) || std::ranges::any_of(taken, hit)) continue;
            if (!over_lines && std::ranges::any_of(lines, cut)) continue;
            places[i] = centre;
            taken.push_back(box);
            return;
        }
    };
    for (const bool over_lines : {false, true}) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!places[i]) place(i, over_lines);
        }
    }
    return places;
}

std::vector<std::size_t> pareto_front(std::span<const WorkPoint> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {},
                      [points](std::size_t i) { return std::tuple(points[i].error, points[i].work, i); });
    // In order of rising error a point is on the front if it takes less work than all before it.
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        if (front.empty() || points[i].work < points[front.back()].work) front.push_back(i);
    }
    return front;
}

}  // namespace pushfactor::demos::reports::error
