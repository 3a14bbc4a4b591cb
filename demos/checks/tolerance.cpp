#include "demos/checks/tolerance.h"

#include "demos/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::checks {

namespace {

bool keeps(const Limit& limit, const renderer::ImageDifference& difference) {
    return difference.share_above(limit.level) <= limit.share;
}

std::string percent(double share) {
    return fmt::format("{:.3g} %", 100.0 * share);
}

std::optional<Limit> parse_limit(std::string_view text) {
    const std::size_t colon = text.find(':');
    const auto level = parse_integer(text.substr(0, colon));
    if (!level || *level < 0 || *level > 255) return std::nullopt;
    if (colon == std::string_view::npos) return Limit{*level, 0.0};
    std::string_view share = text.substr(colon + 1);
    if (!share.ends_with('%')) return std::nullopt;
    share.remove_suffix(1);
    const auto value = parse_number(share);
    if (!value || *value < 0.0 || *value > 100.0) return std::nullopt;
    return Limit{*level, *value / 100.0};
}

}  // namespace

bool Tolerance::accepts(const renderer::ImageDifference& difference, std::optional<double> mean_flip) const {
    if (flip) return mean_flip && *mean_flip <= *flip;
    return std::all_of(limits.begin(), limits.end(), [&](const Limit& limit) { return keeps(limit, difference); });
}

std::string Tolerance::complaint(const renderer::ImageDifference& difference,
                                 std::optional<double> mean_flip) const {
    const std::string largest = fmt::format("the largest by {} levels", difference.largest());
    if (flip) {
        return fmt::format("mean FLIP error {:.3g} ({} allowed); {} of the pixels differ, {}",
                           mean_flip.value_or(1.0), *flip, percent(difference.share_above(0)), largest);
    }
    const auto broken =
        std::find_if(limits.begin(), limits.end(), [&](const Limit& limit) { return !keeps(limit, difference); });
    const Limit limit = broken == limits.end() ? Limit{} : *broken;
    const std::string more = limit.level > 0 ? fmt::format(" by more than {} levels", limit.level) : "";
    const std::string allowed = limit.share > 0.0 ? fmt::format(" ({} allowed)", percent(limit.share)) : "";
    return fmt::format("{} of the pixels differ{}{}, {}", percent(difference.share_above(limit.level)), more,
                       allowed, largest);
}

std::string Tolerance::text() const {
    if (flip) return fmt::format("mean FLIP error at most {}", *flip);
    std::string text;
    for (const Limit& limit : limits) {
        if (!text.empty()) text += ", ";
        if (limit.level == 0 && limit.share == 0.0) return "to the byte";
        text += limit.share > 0.0
                    ? fmt::format("at most {} of the pixels by more than {}", percent(limit.share), limit.level)
                    : fmt::format("none by more than {}", limit.level);
    }
    return text + " levels of 255";
}

std::optional<std::vector<Limit>> parse_limits(std::string_view text) {
    std::vector<Limit> limits;
    for (const std::string_view part : parts_of(text)) {
        const auto limit = parse_limit(part);
        if (!limit) return std::nullopt;
        limits.push_back(*limit);
    }
    return limits;
}

Tolerance exactly() {
    return {.limits = {{0, 0.0}}};
}

Tolerance usual() {
    return {.limits = {{2, 0.0005}, {16, 0.00005}}};
}

}  // namespace pushfactor::demos::checks
