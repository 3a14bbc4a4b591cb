#include "demos/reports/reality/tosses.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/median.h"
#include "demos/scenes/random.h"

#include <libdeflate.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>

namespace pushfactor::demos::reports::reality {

namespace {

using engine::Quaternion;
using engine::Vector3;

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
        throw RunError("{}: is damaged", file.string());
    }
    return text;
}

// z is up in the files.
const Quaternion y_up(std::sqrt(0.5), -std::sqrt(0.5), 0.0, 0.0);

Vector3 vector_at(const std::vector<double>& line, std::size_t at) {
    return y_up * Vector3(line[at], line[at + 1], line[at + 2]);
}

Pose pose_at(const std::vector<double>& line, std::size_t at) {
    const Quaternion turned(line[at + 3], line[at + 4], line[at + 5], line[at + 6]);
    return {vector_at(line, at), (y_up * turned).normalized()};
}

constexpr double near_board = 0.003;  // m, of a corner that touches: twice the spread of the height at rest

// The angle of the rotation as a vector.
Vector3 rotation_between(const Quaternion& from, const Quaternion& to) {
    const Eigen::AngleAxisd turn((to * from.conjugate()).normalized());
    return turn.angle() * turn.axis();
}

// Height [m] of the lowest corner above the board.
double clearance(const Pose& pose, double board) {
    return pose.position.y() - board - 0.5 * edge * pose.orientation.toRotationMatrix().row(1).cwiseAbs().sum();
}

PoseError between(const Pose& measured, const Pose& computed) {
    return {(measured.position - computed.position).norm() / edge,
            measured.orientation.angularDistance(computed.orientation) * 180.0 / std::numbers::pi};
}

constexpr std::size_t fewest = 10;  // tosses, of a mean

// The errors at the frames of each toss that `frames_of` gives for it and its contacts, frame by frame, while there
// are enough tosses.
template <typename FramesOf>
std::vector<ErrorsAt> errors_at(const Tosses& tosses, const Judged& judged, const Law& law,
                                const FramesOf& frames_of) {
    std::vector<ErrorsAt> all;
    for (std::size_t t = 0; t < tosses.size(); ++t) {
        const std::vector<std::size_t> frames = frames_of(tosses[t], bounces(tosses[t], law.board));
        all.resize(std::max(all.size(), frames.size()));
        for (std::size_t k = 0; k < frames.size(); ++k)
            all[k].add(between(tosses[t].frames[frames[k]], judged.poses[t][frames[k]]));
    }
    const auto too_few = [](const ErrorsAt& errors) { return errors.position.size() < fewest; };
    all.erase(std::ranges::find_if(all, too_few), all.end());
    return all;
}

// Errors after 0.1 s from measured poses, in flight and with contacts: so far chaos has no say.
std::pair<ErrorsAt, ErrorsAt> windows_of(const Engine& engine, const Tosses& tosses, const Law& law) {
    constexpr std::size_t length = frames_per_second / 10;
    std::pair<ErrorsAt, ErrorsAt> found;
    for (const Toss& toss : tosses) {
        const std::vector<std::size_t> contacts = bounces(toss, law.board);
        const std::size_t first = contacts.empty() ? toss.frames.size() : contacts.front();
        for (std::size_t from = 2; from + length < toss.frames.size(); from += length) {
            const Pose computed = engine(restart(toss, from), law, length + 1).back();
            (from + length < first ? found.first : found.second).add(between(toss.frames[from + length], computed));
        }
    }
    return found;
}

}  // namespace

std::vector<std::vector<double>> numbers_of(const std::filesystem::path& file, const std::string& columns) {
    const auto bytes = read_bytes_of(file);
    if (!bytes) throw RunError("{}: cannot be read", file.string());
    std::string text = *bytes;
    if (file.extension() == ".gz") text = decompressed(file, text);
    if (!text.starts_with(columns + "\n")) throw RunError("{}: must begin with {}", file.string(), columns);
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
                throw RunError("{}: line {}: must be {} numbers", file.string(), lines.size() + 1, cells);
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

Tosses half_of(const Tosses& all, std::size_t first, bool quick) {
    Tosses some;
    for (std::size_t i = first; i < all.size(); i += quick ? 10 : 2) some.push_back(all[i]);
    return some;
}

LawGrid law_grid(const Tosses& tosses, bool quick) {
    // Where the cubes lie at the end: the height of the board is measured there best.
    std::vector<double> heights;
    for (const Toss& toss : tosses) heights.push_back(toss.frames.back().position.y() - 0.5 * edge);
    const auto values = [](double from, double step, int count) {
        std::vector<double> all;
        for (int i = 0; i < count; ++i) all.push_back(from + step * i);
        return all;
    };
    if (quick) return {values(0.14, 0.02, 5), values(0.0, 0.1, 4), mean_of(heights)};
    return {values(0.12, 0.01, 13), values(0.0, 0.05, 9), mean_of(heights)};
}

std::vector<double> errors_with(const Engine& engine, const Tosses& tosses, const LawGrid& grid, double friction,
                                const StopCheck& check) {
    std::vector<double> errors;
    for (const double restitution : grid.restitutions) {
        check();
        const Law law{friction, restitution, grid.board.value};
        for (const Toss& toss : tosses) {
            errors.push_back(mean_error(toss, engine(toss.start, law, toss.frames.size())).position);
        }
    }
    return errors;
}

LawFit::LawFit(LawGrid grid, std::vector<std::vector<double>> errors)
    : grid_(std::move(grid)), errors_(std::move(errors)) {
    whole_.resize(errors_.front().size() / grid_.restitutions.size());
    std::iota(whole_.begin(), whole_.end(), std::size_t{0});
}

double LawFit::error(std::array<std::size_t, 2> at, const std::vector<std::size_t>& of) const {
    const double* const all = errors_[at[0]].data() + at[1] * whole_.size();
    double sum = 0.0;
    for (const std::size_t toss : of) sum += all[toss];
    return sum / static_cast<double>(of.size());
}

Law LawFit::best(const std::vector<std::size_t>& of) const {
    const std::array<const std::vector<double>*, 2> axes{&grid_.frictions, &grid_.restitutions};
    std::array<std::size_t, 2> least{}, at{};
    double lowest = std::numeric_limits<double>::infinity();
    for (at[0] = 0; at[0] < axes[0]->size(); ++at[0]) {
        for (at[1] = 0; at[1] < axes[1]->size(); ++at[1]) {
            const double here = error(at, of);
            if (!(here < lowest)) continue;  // nor where an engine gave up
            lowest = here;
            least = at;
        }
    }
    std::array<double, 2> found{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::vector<double>& value = *axes[axis];
        found[axis] = value[least[axis]];
        if (least[axis] == 0 || least[axis] + 1 >= value.size()) continue;
        auto below = least, above = least;
        --below[axis];
        ++above[axis];
        const double low = error(below, of), high = error(above, of), bend = low - 2.0 * lowest + high;
        if (bend > 0.0) found[axis] += 0.5 * (low - high) / bend * (value[1] - value[0]);
    }
    return {found[0], found[1], grid_.board.value};
}

Law LawFit::spread() const {
    constexpr int draws = 200;
    scenes::Random random(1);
    std::vector<double> frictions, restitutions;
    for (int draw = 0; draw < draws; ++draw) {
        std::vector<std::size_t> of(whole_.size());
        for (std::size_t& one : of) {
            one = static_cast<std::size_t>(random.in(0.0, static_cast<double>(whole_.size())));
        }
        const Law law = best(of);
        frictions.push_back(law.friction);
        restitutions.push_back(law.restitution);
    }
    const auto deviation = [](const std::vector<double>& all) { return mean_of(all).error * std::sqrt(draws); };
    return {deviation(frictions), deviation(restitutions), grid_.board.error};
}

Judged judge(const Engine& engine, const Tosses& tosses, const Law& law) {
    Judged judged;
    for (const Toss& toss : tosses) {
        judged.poses.push_back(engine(toss.start, law, toss.frames.size()));
        const PoseError error = mean_error(toss, judged.poses.back());
        judged.position.push_back(error.position);
        judged.angle.push_back(error.angle);
        judged.right.push_back(upper_face(judged.poses.back().back().orientation) ==
                               upper_face(toss.frames.back().orientation));
    }
    return judged;
}

std::vector<ErrorsAt> errors_over_time(const Tosses& tosses, const Judged& judged, const Law& law) {
    constexpr auto longest = static_cast<std::size_t>(0.6 * frames_per_second);
    const auto frames_of = [](const Toss& toss, const std::vector<std::size_t>& contacts) {
        const std::size_t first = contacts.empty() ? toss.frames.size() : contacts.front();
        std::vector<std::size_t> frames(std::min(toss.frames.size() - first, longest + 1));
        std::iota(frames.begin(), frames.end(), first);
        return frames;
    };
    std::vector<ErrorsAt> all = errors_at(tosses, judged, law, frames_of);
    for (std::size_t i = 0; i < all.size(); ++i) all[i].at = static_cast<double>(i) / frames_per_second;
    return all;
}

std::vector<ErrorsAt> errors_by_bounce(const Tosses& tosses, const Judged& judged, const Law& law) {
    const auto frames_of = [](const Toss& toss, std::vector<std::size_t> contacts) {
        contacts.push_back(toss.frames.size());
        contacts.erase(contacts.begin());
        for (std::size_t& next : contacts) --next;
        return contacts;
    };
    std::vector<ErrorsAt> all = errors_at(tosses, judged, law, frames_of);
    for (std::size_t i = 0; i < all.size(); ++i) all[i].at = static_cast<double>(i + 1);
    return all;
}

std::vector<Result> results_of(const Engine& engine, const LawFit& fit, const Tosses& tosses,
                               const Judged& judged) {
    const Law law = fit.best(), spread = fit.spread();
    std::vector<Result> results;
    const auto add = [&results](const std::string& what, const std::vector<double>& all, double scale) {
        const Mean mean = mean_of(all);
        results.push_back({what, scale * mean.value, scale * mean.error});
    };
    results.push_back({"fitted friction", law.friction, spread.friction});
    results.push_back({"fitted restitution", law.restitution, spread.restitution});
    results.push_back({"height of the board, mm", 1000.0 * law.board, 1000.0 * spread.board});
    add("position, mean over whole tosses, % of an edge", judged.position, 100.0);
    results.push_back({"position, median toss, % of an edge", 100.0 * median(judged.position)});
    add("orientation, mean over whole tosses, degrees", judged.angle, 1.0);
    results.push_back({"orientation, median toss, degrees", median(judged.angle)});
    const auto after = errors_by_bounce(tosses, judged, law);
    if (!after.empty()) {
        add("after the first bounce: position, % of an edge", after.front().position, 100.0);
        add("after the first bounce: orientation, degrees", after.front().angle, 1.0);
    }
    const auto count = static_cast<double>(tosses.size());
    const double share = static_cast<double>(std::ranges::count(judged.right, true)) / count;
    const auto [low, high] = confidence(share, static_cast<int>(tosses.size()));
    results.push_back({"the measured face ends on top, % of tosses", 100.0 * share, 50.0 * (high - low) / 1.96});
    const auto [flight, contact] = windows_of(engine, tosses, law);
    add("restarted in flight: position after 0.1 s, % of an edge", flight.position, 100.0);
    add("restarted in flight: orientation, degrees", flight.angle, 1.0);
    add("restarted with contacts: position after 0.1 s, % of an edge", contact.position, 100.0);
    add("restarted with contacts: orientation, degrees", contact.angle, 1.0);
    return results;
}

}  // namespace pushfactor::demos::reports::reality
