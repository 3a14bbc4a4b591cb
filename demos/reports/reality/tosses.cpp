#include "demos/reports/reality/tosses.h"

#include <cmath>
#include <numbers>

namespace pushfactor::demos::reports::reality {

namespace {

using engine::Quaternion;
using engine::Vector3;

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
        toss.velocity = vector_at(line, 9);
        toss.angular_velocity = vector_at(line, 12);
    }
    return tosses;
}

Restart start_of(const Toss& toss) {
    return {toss.frames.front(), toss.velocity, toss.angular_velocity};
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
