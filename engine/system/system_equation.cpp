#include "engine/system/system_equation.h"

#include "engine/bodies/awake.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pushfactor::engine {

namespace {

// `result` holds the values of the last step, or zero; bodies with equal moments keep them.
void find_inverse_mass(const Body& body, InverseMass& result) {
    const Vector3& moments = body.inverse_inertia;
    const bool turns_alike = moments.x() == moments.y() && moments.y() == moments.z();
    if (turns_alike && result.linear == body.inverse_mass && result.angular.diagonal() == moments) return;
    result.linear = body.inverse_mass;
    result.linear_root = std::sqrt(body.inverse_mass);
    const Matrix3 rotation = turns_alike ? Matrix3(Matrix3::Identity()) : body.orientation.toRotationMatrix();
    result.angular = rotation * moments.asDiagonal() * rotation.transpose();
    result.angular_root = rotation * moments.cwiseSqrt().asDiagonal();
}

// v1/dt + M^-1 f_ext of one body.
void find_free_acceleration(const Body& body, const InverseMass& inverse_mass, double dt, Vector6& result) {
    if (body.is_static()) {
        result.setZero();
        return;
    }
    for (int axis = 0; axis < 3; ++axis) {
        result[axis] = inverse_mass.linear * (body.linear_momentum[axis] / dt + body.force[axis]);
    }
    const Vector3 torque = body.angular_momentum / dt + body.torque;
    const Matrix3& angular = inverse_mass.angular;
    for (int axis = 0; axis < 3; ++axis) {
        result[axis + 3] =
            angular(axis, 0) * torque[0] + angular(axis, 1) * torque[1] + angular(axis, 2) * torque[2];
    }
}

// M^(-1/2)^T j for one body. Scalar access on purpose: a 16-byte load after 8-byte stores stalls store forwarding.
struct WeightedAxis {
    WeightedAxis(const InverseMass& inverse_mass, const Vector6& j)
        : x(inverse_mass.linear_root * j[0]),
          y(inverse_mass.linear_root * j[1]),
          z(inverse_mass.linear_root * j[2]),
          u(turned(inverse_mass.angular_root, 0, j)),
          v(turned(inverse_mass.angular_root, 1, j)),
          w(turned(inverse_mass.angular_root, 2, j)) {}

    static double turned(const Matrix3& root, int axis, const Vector6& j) {
        return root(0, axis) * j[3] + root(1, axis) * j[4] + root(2, axis) * j[5];
    }

    // A static body, or one that is left out.
    WeightedAxis() : x(0), y(0), z(0), u(0), v(0), w(0) {}

    double squared() const { return (x * x + y * y + z * z) + (u * u + v * v + w * w); }
    double dot(const WeightedAxis& other) const {
        return (x * other.x + y * other.y + z * other.z) + (u * other.u + v * other.v + w * other.w);
    }
    void write(double factor, Vector6& axis) const {
        axis[0] = factor * x;
        axis[1] = factor * y;
        axis[2] = factor * z;
        axis[3] = factor * u;
        axis[4] = factor * v;
        axis[5] = factor * w;
    }

    double x, y, z, u, v, w;
};

// Both halves of a row's axis.
struct WeightedRow {
    [[gnu::always_inline]] WeightedRow(const ConstraintRow& row, const SystemEquation& system)
        : a(half(row.body_a, row.jacobian.a, system)), b(half(row.body_b, row.jacobian.b, system)) {}

    [[gnu::always_inline]] static WeightedAxis half(int body, const Vector6& axis, const SystemEquation& system) {
        const InverseMass& inverse_mass = system.inverse_mass[static_cast<std::size_t>(body)];
        return inverse_mass.linear > 0.0 ? WeightedAxis(inverse_mass, axis) : WeightedAxis();
    }
    double squared() const { return a.squared() + b.squared(); }

    WeightedAxis a, b;
};

// A_jj of row j; for the second row of a disc also that of the first. Both get the largest eigenvalue of their
// block [a c; c b], so that a simultaneous update does not overshoot.
inline void weigh(std::size_t j, SystemEquation& system) {
    const Disc disc = system.rows[j].bounds.disc;
    if (disc == Disc::first) return;
    const WeightedRow row(system.rows[j], system);
    const double b = row.squared();
    const auto index = static_cast<Eigen::Index>(j);
    if (disc == Disc::none) {
        system.diagonal[index] = b + system.rows[j].softness;
        return;
    }
    const WeightedRow first(system.rows[j - 1], system);
    const double a = first.squared();
    const double c = first.a.dot(row.a) + first.b.dot(row.b);
    const double step = 0.5 * (a + b) + std::sqrt(0.25 * (a - b) * (a - b) + c * c);
    system.diagonal[index - 1] = system.diagonal[index] = step;
}

bool corrects(const ConstraintRow& row) {
    return row.push.correcting != 0.0 || !row.bounds.in_momenta;
}

[[gnu::always_inline]] inline RowDigest digest_of(const SystemEquation& system, std::size_t j) {
    const std::span<const ConstraintRow> rows = system.rows;
    const ConstraintRow& row = rows[j];
    const Bounds& bounds = row.bounds;
    int traits = bounds.in_momenta ? 0 : RowDigest::not_in_momenta | RowDigest::limited;
    if (row.softness > 0.0) traits |= RowDigest::soft;
    if (corrects(row)) traits |= RowDigest::corrects;
    if (row.label.kind == RowKind::joint) traits |= RowDigest::joins;
    const bool may_drive = row.label.kind == RowKind::friction || row.label.kind == RowKind::motor;
    if (may_drive && (row.push.lasting != 0.0 || system.carried_by(j) != 0.0)) traits |= RowDigest::drives;
    if (bounds.of_row >= 0) {
        traits |= RowDigest::limited;
        // The rows of a contact point are adjacent.
        const auto leader = static_cast<std::size_t>(bounds.of_row);
        const auto acts_on_same = [&](const ConstraintRow& other) {
            return other.body_a == row.body_a && other.body_b == row.body_b;
        };
        if (j - leader > 2 || !acts_on_same(rows[leader]) || !acts_on_same(rows[j - 1]))
            traits |= RowDigest::follows;
    } else {
        const bool unlimited = bounds.c_min == -infinity && bounds.c_max == infinity;
        const bool touches = row.label.kind == RowKind::contact;
        traits |= unlimited ? RowDigest::acts_both_ways : RowDigest::limited;
        if (touches || (!unlimited && row.label.kind == RowKind::distance)) traits |= RowDigest::opens;
        if (touches && row.push.lasting > 0.0) traits |= RowDigest::rebounds;
    }
    return {row.body_a, row.body_b, row.label.kind, static_cast<std::uint16_t>(traits)};
}

// Keeps existing values.
void size_rows(SystemEquation& system) {
    const auto count = static_cast<Eigen::Index>(system.rows.size());
    system.digests.resize(system.rows.size());
    if (system.diagonal.size() == count) return;  // Eigen would reallocate all the same
    system.diagonal.conservativeResize(count);
}

}  // namespace

void weigh_rows(SystemEquation& system) {
    size_rows(system);
    for (std::size_t j = 0; j < system.rows.size(); ++j) {
        weigh(j, system);
        system.digests[j] = digest_of(system, j);
    }
}

double acceleration_along(const SystemEquation& system, std::size_t j, std::span<const Vector6> forces) {
    const ConstraintRow& row = system.rows[j];
    const auto half = [&](int body, const Vector6& axis) {
        const auto i = static_cast<std::size_t>(body);
        return axis.dot(accelerate(system.inverse_mass[i], forces[i]));
    };
    return half(row.body_a, row.jacobian.a) + half(row.body_b, row.jacobian.b);
}

double diagonal_of(const SystemEquation& system, const ConstraintRow& row) {
    return WeightedRow(row, system).squared() + row.softness;
}

Jacobian unit_axis(const SystemEquation& system, const ConstraintRow& row, double scale) {
    const WeightedRow weighted(row, system);
    const double to_unit = scale > 0.0 ? 1.0 / scale : 0.0;
    Jacobian unit;
    weighted.a.write(to_unit, unit.a);
    weighted.b.write(to_unit, unit.b);
    return unit;
}

namespace {

// Diagonals, digests and right-hand sides of the rows from `first` on; those before have theirs.
void append_to_system(std::span<const ConstraintRow> rows, std::size_t first, SystemEquation& system,
                      Threads* threads) {
    system.rows = rows;
    size_rows(system);
    const bool had_one = first > 0 && system.column_count() == 1;
    const bool two_columns =
        (first > 0 && !had_one) || !system.detours.empty() || std::ranges::any_of(rows.subspan(first), corrects);
    system.b.conservativeResize(static_cast<Eigen::Index>(rows.size()), two_columns ? 2 : 1);
    if (had_one && two_columns) system.b.col(1) = system.b.col(0);
    share(threads, rows.size() - first, rows_of_a_part, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = first + begin; j < first + end; ++j) {
            const ConstraintRow& row = rows[j];
            weigh(j, system);
            system.digests[j] = digest_of(system, j);
            const double free = unconstrained(system, j);
            const auto index = static_cast<Eigen::Index>(j);
            system.b(index, 0) = (row.push.correcting + row.push.lasting) / system.dt - free;
            if (two_columns && !system.detours.empty())
                system.b(index, 0) -= acceleration_along(system, j, system.detours);
            if (two_columns) system.b(index, 1) = row.push.lasting / system.dt - free;
        }
    });
}

}  // namespace

void build_system(std::span<const Body> bodies, std::span<const ConstraintRow> rows, double dt,
                  SystemEquation& system) {
    build_system(bodies, Awake(bodies.size()).members(), rows, dt, system);
}

void build_system(std::span<const Body> bodies, std::span<const int> awake, std::span<const ConstraintRow> rows,
                  double dt, SystemEquation& system, Threads* threads) {
    system.dt = dt;
    std::vector<Vector6>& free = system.free_acceleration;
    if (awake.size() < bodies.size() && !std::ranges::equal(system.awake, awake)) {
        // Bodies that are left out count as static.
        system.inverse_mass.clear();
        free.clear();
    }
    system.awake.assign(awake.begin(), awake.end());
    system.inverse_mass.resize(bodies.size());
    free.resize(bodies.size(), Vector6::Zero());
    share_each(threads, awake, bodies_of_a_part, [&](int index) {
        const auto i = static_cast<std::size_t>(index);
        find_inverse_mass(bodies[i], system.inverse_mass[i]);
        find_free_acceleration(bodies[i], system.inverse_mass[i], dt, free[i]);
    });
    append_to_system(rows, 0, system, threads);
}

void extend_system(std::span<const ConstraintRow> rows, SystemEquation& system) {
    append_to_system(rows, system.rows.size(), system, nullptr);
}

void constraint_forces(const SystemEquation& system, const Columns& lambda, Eigen::Index column,
                       std::vector<Vector6>& forces) {
    forces.assign(system.inverse_mass.size(), Vector6::Zero());
    for (Eigen::Index begin = 0, end = 0; begin < system.row_count(); begin = end) {
        const ConstraintRow& first = system.rows[static_cast<std::size_t>(begin)];
        const auto acts_on_these = [&](Eigen::Index j) {
            const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
            return row.body_a == first.body_a && row.body_b == first.body_b;
        };
        while (end < system.row_count() && acts_on_these(end)) ++end;
        add_forces_of_rows(system, lambda, column, begin, end, forces[static_cast<std::size_t>(first.body_a)],
                           forces[static_cast<std::size_t>(first.body_b)]);
    }
}

double natural_residual(const SystemEquation& system, const Columns& lambda) {
    double largest = 0.0;
    std::vector<Vector6> forces;
    for (Eigen::Index column = 0; column < system.column_count(); ++column) {
        constraint_forces(system, lambda, column, forces);
        for (std::size_t i = 0; i < forces.size(); ++i) {
            forces[i] = accelerate(system.inverse_mass[i], forces[i]);
        }
        RowResiduals residuals(system, lambda, column);
        for (Eigen::Index j = 0; j < system.row_count(); ++j) {
            const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
            const double w = row.jacobian.a.dot(forces[static_cast<std::size_t>(row.body_a)]) +
                             row.jacobian.b.dot(forces[static_cast<std::size_t>(row.body_b)]) -
                             system.b(j, column) + soft_part(row, lambda, j, column);
            largest = std::max(largest, residuals.next(j, w));
        }
    }
    return largest;
}

}  // namespace pushfactor::engine
