#include "demos/runs/pose_reader.h"

#include "demos/text/errors.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace pushfactor::demos {

PoseReader::PoseReader(std::string option, const std::filesystem::path& file)
    : name_(std::move(option) + file.string()), stream_(file) {
    if (!stream_) refuse("cannot be read");
    rewind();
}

void PoseReader::refuse(const std::string& what) const {
    throw UsageError(fmt::format("{}: {}", name_, what));
}

void PoseReader::rewind() {
    stream_.clear();
    stream_.seekg(0);
    if (!std::getline(stream_, text_) || !text_.starts_with(pose_columns)) {
        refuse(fmt::format("line 1: must begin with {}", pose_columns));
    }
    line_ = 1;
}

std::optional<PoseLine> PoseReader::next() {
    if (!std::getline(stream_, text_)) return std::nullopt;
    ++line_;
    std::array<double, 9> values;
    std::string_view rest = text_;
    for (double& value : values) {
        const std::size_t comma = rest.find(',');
        const auto number = parse_number(rest.substr(0, comma));
        if (!number || comma == std::string_view::npos) {
            refuse(fmt::format("line {}: must be numbers, as `--trajectory` writes them", line_));
        }
        value = *number;
        rest.remove_prefix(comma + 1);
    }
    return PoseLine{.time = values[0],
                    .pose = {.body = static_cast<std::size_t>(std::max(values[1], 0.0)),
                             .position = {values[2], values[3], values[4]},
                             .orientation = {values[5], values[6], values[7], values[8]}}};
}

}  // namespace pushfactor::demos
