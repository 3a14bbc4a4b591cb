#include "demos/reports/error/plot_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pushfactor::demos::reports::error {

namespace {

constexpr double letter_height = 1.9;  // of a text line, in letter widths
constexpr double mark = 0.9;           // half the width of a point's mark

struct Box {
    double left, right, bottom, top;
};

Box around(const Place& centre, double half_width, double half_height) {
    return {centre.x - half_width, centre.x + half_width, centre.y - half_height, centre.y + half_height};
}

bool overlap(const Box& a, const Box& b) {
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

// Sampled finely enough for the height of a label.
bool crosses(const Segment& line, const Box& box) {
    const double length = std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
    const int samples = static_cast<int>(length / 0.5) + 1;
    for (int k = 0; k <= samples; ++k) {
        const double share = static_cast<double>(k) / samples;
        const Place at{line.from.x + share * (line.to.x - line.from.x),
                       line.from.y + share * (line.to.y - line.from.y)};
        if (overlap(box, around(at, 0.1, 0.1))) return true;
    }
    return false;
}

}  // namespace

std::vector<std::optional<Place>> place_labels(const std::vector<Place>& points,
                                               const std::vector<std::string>& labels,
                                               const std::vector<Segment>& lines, const Place& corner) {
    std::vector<Box> taken;
    for (const Place& point : points) taken.push_back(around(point, mark, mark));
    std::vector<std::optional<Place>> places(points.size());
    const auto place = [&](std::size_t i, bool over_lines) {
        const double half = 0.5 * static_cast<double>(labels[i].size());
        const double aside = half + mark + 0.5;
        const double above = 0.5 * letter_height + mark + 0.1;
        for (const Place& offset :
             {Place{aside, 0}, Place{-aside, 0}, Place{0, above}, Place{0, -above}, Place{aside, above},
              Place{-aside, -above}, Place{-aside, above}, Place{aside, -above}}) {
            const Place centre{points[i].x + offset.x, points[i].y + offset.y};
            const Box box = around(centre, half, 0.5 * letter_height);
            if (box.left < 0 || box.bottom < 0 || box.right > corner.x || box.top > corner.y) continue;
            const auto hit = [&box](const Box& other) { return overlap(box, other); };
            const auto cut = [&box](const Segment& line) { return crosses(line, box); };
            if (std::any_of(taken.begin(), taken.end(), hit)) continue;
            if (!over_lines && std::any_of(lines.begin(), lines.end(), cut)) continue;
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

std::vector<std::size_t> pareto_front(std::span<const Trade> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [points](std::size_t a, std::size_t b) {
        return std::tuple(points[a].error, points[a].work, a) < std::tuple(points[b].error, points[b].work, b);
    });
    // In order of rising error a point is on the front if it takes less work than all before it.
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        if (front.empty() || points[i].work < points[front.back()].work) front.push_back(i);
    }
    return front;
}

}  // namespace pushfactor::demos::reports::error
