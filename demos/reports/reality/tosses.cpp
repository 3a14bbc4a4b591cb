#include "demos/reports/reality/tosses.h"

#include "demos/platform/output_file.h"
#include "demos/text/errors.h"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <numbers>

namespace pushfactor::demos::reports::reality {

namespace {

using engine::Quaternion;
using engine::Vector3;

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
    throw RunError(fmt::format("{}: {}", file.string(), what));
}

std::string decompressed(const std::filesystem::path& file, const std::string& bytes) {
    // The size before compression is in the last four bytes, the lowest first (RFC 1952).
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4 && bytes.size() > 4; ++i) {
        size |= std::size_t{static_cast<unsigned char>(bytes[bytes.size() - 4 + i])} << (8 * i);
    }
    constexpr std::size_t most = 100'000'000;
    std::string text(std::min(size, most), '\0');
    const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> gzip(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    if (libdeflate_gzip_decompress(gzip.get(), bytes.data(), bytes.size(), text.data(), text.size(), nullptr) !=
        LIBDEFLATE_SUCCESS) {
        refuse(file, "is damaged");
    }
    return text;
}

constexpr double near_board =
    0.003;  // m, of a corner that touches: twice the spread of the measured height at rest

// z is up in the files.
const Quaternion y_up(std::sqrt(0.5), -std::sqrt(0.5), 0.0, 0.0);

Vector3 vector_at(const std::vector<double>& line, std::size_t at) {
    return y_up * Vector3(line[at], line[at + 1], line[at + 2]);
}

Pose pose_at(const std::vector<double>& line, std::size_t at) {
    const Quaternion turned(line[at + 3], line[at + 4], line[at + 5], line[at + 6]);
    return {vector_at(line, at), (y_up * turned).normalized()};
}

// The angle of the rotation as a vector.
Vector3 rotation_between(const Quaternion& from, const Quaternion& to) {
    const Eigen::AngleAxisd turn((to * from.conjugate()).normalized());
    const double angle = turn.angle() > std::numbers::pi ? turn.angle() - 2.0 * std::numbers::pi : turn.angle();
    return angle * turn.axis();
}

// Height [m] of the lowest corner above the board.
double clearance(const Pose& pose, double board) {
    return pose.position.y() - board - 0.5 * edge * pose.orientation.toRotationMatrix().row(1).cwiseAbs().sum();
}

}  // namespace

std::vector<std::vector<double>> numbers_of(const std::filesystem::path& file, const std::string& columns) {
    const auto bytes = read_bytes_of(file);
    if (!bytes) refuse(file, "cannot be read");
    std::string text = *bytes;
    if (file.extension() == ".gz") text = decompressed(file, text);
    if (!text.starts_with(columns + "\n")) refuse(file, "must begin with " + columns);
    std::vector<std::vector<double>> lines;
    const auto cells = static_cast<std::size_t>(std::ranges::count(columns, ',')) + 1;
    const char* at = text.data() + columns.size() + 1;
    const char* const end = text.data() + text.size();
    while (at < end) {
        std::vector<double>& line = lines.emplace_back(cells);
        for (double& number : line) {
            const auto [next, error] = std::from_chars(at, end, number);
            const char after = &number == &line.back() ? '\n' : ',';
            if (error != std::errc() || next == end || *next != after) {
                refuse(file, fmt::format("line {}: must be {} numbers", lines.size() + 1, cells));
            }
            at = next + 1;
        }
    }
    return lines;
}

std::vector<Toss> read_tosses(const std::filesystem::path& folder) {
    std::vector<Toss> tosses;
    for (const auto& line : numbers_of(folder / "cube-tosses.csv.gz", "toss,frame,x_m,y_m,z_m,qw,qx,qy,qz")) {
        tosses.resize(static_cast<std::size_t>(line[0]) + 1);
        tosses.back().frames.push_back(pose_at(line, 2));
    }
    for (const auto& line : numbers_of(folder / "cube-toss-starts.csv",
                                       "toss,frames,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_per_s,vy_m_per_s,vz_m_per_s,"
                                       "wx_rad_per_s,wy_rad_per_s,wz_rad_per_s")) {
        Toss& toss = tosses.at(static_cast<std::size_t>(line[0]));
        toss.start = {toss.frames.front(), vector_at(line, 9), vector_at(line, 12)};
    }
    return tosses;
}

PoseError between(const Pose& measured, const Pose& computed) {
    return {(measured.position - computed.position).norm() / edge,
            measured.orientation.angularDistance(computed.orientation) * 180.0 / std::numbers::pi};
}

PoseError mean_error(const Toss& toss, const std::vector<Pose>& poses) {
    PoseError sum;
    for (std::size_t i = 1; i < toss.frames.size(); ++i) {
        const PoseError now = between(toss.frames[i], poses[i]);
        sum.position += now.position;
        sum.angle += now.angle;
    }
    const auto frames = static_cast<double>(toss.frames.size() - 1);
    return {sum.position / frames, sum.angle / frames};
}

std::vector<std::size_t> bounces(const Toss& toss, double board) {
    std::vector<std::size_t> found;
    bool touched = false;
    for (std::size_t i = 0; i < toss.frames.size(); ++i) {
        const bool touches = clearance(toss.frames[i], board) < near_board;
        if (touches && !touched) found.push_back(i);
        touched = touches;
    }
    return found;
}

int upper_face(const Quaternion& orientation) {
    const Vector3 up = orientation.conjugate() * Vector3::UnitY();
    Eigen::Index axis = 0;
    up.cwiseAbs().maxCoeff(&axis);
    return static_cast<int>(axis + 1) * (up[axis] > 0.0 ? 1 : -1);
}

Restart restart(const Toss& toss, std::size_t at) {
    const Pose& pose = toss.frames[at];
    const std::size_t first = at < 2 ? 0 : at - 2, last = std::min(at + 2, toss.frames.size() - 1);
    double squares = 0.0;
    Vector3 moved = Vector3::Zero(), turned = Vector3::Zero();
    const double middle = 0.5 * static_cast<double>(first + last);
    for (std::size_t i = first; i <= last; ++i) {
        const double time = (static_cast<double>(i) - middle) / frames_per_second;
        squares += time * time;
        moved += time * toss.frames[i].position;
        turned += time * rotation_between(pose.orientation, toss.frames[i].orientation);
    }
    return {pose, moved / squares, turned / squares};
}

}  // namespace pushfactor::demos::reports::reality
