#include "demos/scenes/motions/pose_reader.h"

#include "demos/base/text/errors.h"
#include "demos/base/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <string_view>

namespace pushfactor::demos {

PoseReader::PoseReader(std::string option, const std::filesystem::path& file)
    : name_(std::move(option) + file.string()), stream_(file) {
    if (!stream_) refuse(fmt::format("cannot be read: {}", std::strerror(errno)));
    rewind();
}

void PoseReader::refuse(const std::string& what) const {
    throw UsageError("{}: {}", name_, what);
}

void PoseReader::rewind() {
    stream_.clear();
    stream_.seekg(0);
    const bool has_line = static_cast<bool>(std::getline(stream_, text_));
    if (text_.starts_with("\xef\xbb\xbf")) text_.erase(0, 3);
    if (!has_line || !text_.starts_with(pose_columns)) {
        refuse(fmt::format("line 1: must begin with {}", pose_columns));
    }
    has_hash_ = text_.ends_with(hash_column);
    line_ = 1;
}

std::optional<PoseLine> PoseReader::next() {
    if (!std::getline(stream_, text_)) return std::nullopt;
    ++line_;
    std::array<double, 9> values;
    std::string_view rest = text_;
    if (rest.ends_with('\r')) rest.remove_suffix(1);
    for (double& value : values) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const auto number = parse_number(rest.substr(0, comma));
        if (!number) refuse(fmt::format("line {}: must be numbers, as `--trajectory` writes them", line_));
        value = *number;
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    if (values[1] < 0.0 || values[1] != std::floor(values[1])) {
        refuse(fmt::format("line {}: body {} must be a whole number from 0", line_, values[1]));
    }
    const engine::Quaternion orientation(values[5], values[6], values[7], values[8]);
    if (std::abs(orientation.norm() - 1.0) > 1e-6) {
        refuse(fmt::format("line {}: the orientation must be a quaternion of length 1", line_));
    }
    return PoseLine{.time = values[0],
                    .pose = {.body = static_cast<std::size_t>(values[1]),
                             .position = {values[2], values[3], values[4]},
                             .orientation = orientation},
                    .hash = has_hash_ ? text_.substr(text_.rfind(',') + 1) : ""};
}

}  // namespace pushfactor::demos
