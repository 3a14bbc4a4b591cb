#include "tests/peers/problems/rows_of_contacts.h"

#include "demos/base/text/errors.h"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pushfactor::tests::problems {

namespace {

using engine::ConstraintRow;
using engine::Matrix3;
using engine::Vector6;
using engine::VectorX;

constexpr int unknowns = 6;  // of a body: three of its centre, three of its turning

[[noreturn]] void refuse(const GlobalProblem& problem, const std::string& what) {
    throw demos::UsageError(
        fmt::format("{}: {}: only problems of rigid bodies can be written as rows", problem.title, what));
}

// Everything outside of the blocks of a rigid body has to be zero.
engine::InverseMass inverse_mass(const GlobalProblem& problem, int body) {
    const int first = unknowns * body;
    Eigen::Matrix<double, unknowns, unknowns> block = Eigen::Matrix<double, unknowns, unknowns>::Zero();
    for (int column = first; column < first + unknowns; ++column) {
        for (SparseMatrix::InnerIterator entry(problem.mass, column); entry; ++entry) {
            const auto row = static_cast<int>(entry.row()) - first;
            if (row >= 0 && row < unknowns)
                block(row, column - first) = entry.value();
            else if (entry.value() != 0.0)
                refuse(problem, fmt::format("M couples row {} with {}", entry.row(), column));
        }
    }
    const double mass = block(0, 0);
    const Matrix3 linear = block.topLeftCorner<3, 3>() - mass * Matrix3::Identity();
    const bool rigid = mass > 0.0 && linear.isZero(1e-12 * mass) && block.topRightCorner<3, 3>().isZero(0.0);
    if (!rigid) refuse(problem, fmt::format("body {} has no single mass", body));
    const Matrix3 inertia = block.bottomRightCorner<3, 3>();
    const Eigen::LLT<Matrix3> factors(inertia);
    if (factors.info() != Eigen::Success)
        refuse(problem, fmt::format("the inertia of body {} is not positive", body));
    // L L^T = I, so the inverse is L^-T L^-1.
    const Matrix3 root = factors.matrixL().solve(Matrix3::Identity()).transpose();
    return {.linear = 1.0 / mass,
            .linear_root = std::sqrt(1.0 / mass),
            .angular = factors.solve(Matrix3::Identity()),
            .angular_root = root};
}

// The bodies that a contact acts on: at most two.
std::vector<int> bodies_of(const GlobalProblem& problem, int contact) {
    std::vector<int> bodies;
    for (int column = 3 * contact; column < 3 * contact + 3; ++column) {
        for (SparseMatrix::InnerIterator entry(problem.axes, column); entry; ++entry) {
            const int body = static_cast<int>(entry.row()) / unknowns;
            if (entry.value() != 0.0 && std::find(bodies.begin(), bodies.end(), body) == bodies.end())
                bodies.push_back(body);
        }
    }
    if (bodies.size() > 2) refuse(problem, fmt::format("contact {} acts on {} bodies", contact, bodies.size()));
    return bodies;
}

Vector6 part_of(const GlobalProblem& problem, int column, int body) {
    Vector6 part = Vector6::Zero();
    for (SparseMatrix::InnerIterator entry(problem.axes, column); entry; ++entry) {
        const auto row = static_cast<int>(entry.row()) - unknowns * body;
        if (row >= 0 && row < unknowns) part[row] = entry.value();
    }
    return part;
}

bool is_contact(std::span<const ConstraintRow> rows, std::size_t j) {
    if (j + 2 >= rows.size()) return false;
    const ConstraintRow &normal = rows[j], &first = rows[j + 1], &second = rows[j + 2];
    const bool same = first.body_a == normal.body_a && first.body_b == normal.body_b;
    return same && normal.bounds.of_row < 0 && normal.bounds.c_min == 0.0 && std::isinf(normal.bounds.c_max) &&
           first.bounds.of_row == static_cast<int>(j) && first.bounds.disc == engine::Disc::first &&
           second.bounds.disc == engine::Disc::second && normal.softness == 0.0;
}

void add_block(const Eigen::Ref<const Eigen::MatrixXd>& block, int row, int column,
               std::vector<Eigen::Triplet<double>>& entries) {
    for (int i = 0; i < block.rows(); ++i) {
        for (int j = 0; j < block.cols(); ++j) {
            if (block(i, j) != 0.0) entries.emplace_back(row + i, column + j, block(i, j));
        }
    }
}

}  // namespace

FrozenProblem rows_over_bodies(const GlobalProblem& problem) {
    const auto n = static_cast<int>(problem.mass.rows());
    if (n % unknowns != 0) refuse(problem, fmt::format("M has {} rows, which is no multiple of six", n));
    const int count = n / unknowns, world = count;
    engine::SystemEquation system;
    system.dt = 1.0;
    for (int body = 0; body < count; ++body) {
        system.inverse_mass.push_back(inverse_mass(problem, body));
        system.free_acceleration.push_back(
            engine::accelerate(system.inverse_mass.back(), problem.force.segment<unknowns>(unknowns * body)));
    }
    system.inverse_mass.emplace_back();
    system.free_acceleration.emplace_back(Vector6::Zero());
    for (int body = 0; body <= count; ++body) system.awake.push_back(body);

    std::vector<ConstraintRow> rows;
    system.b.resize(problem.given.size(), 1);
    for (int contact = 0; contact < static_cast<int>(problem.contacts()); ++contact) {
        const std::vector<int> bodies = bodies_of(problem, contact);
        for (int axis = 0; axis < 3; ++axis) {
            const int column = 3 * contact + axis;
            ConstraintRow row;
            row.body_a = bodies.size() > 1 ? bodies[1] : world;
            row.body_b = bodies.empty() ? world : bodies[0];
            if (!bodies.empty()) row.jacobian.b = part_of(problem, column, row.body_b);
            if (bodies.size() > 1) row.jacobian.a = part_of(problem, column, row.body_a);
            row.label.kind = axis == 0 ? engine::RowKind::contact : engine::RowKind::friction;
            if (axis == 0) {
                row.bounds.c_min = 0.0;
            } else {
                row.bounds = {.c_min = -problem.mu[contact],
                              .c_max = problem.mu[contact],
                              .of_row = 3 * contact,
                              .disc = axis == 1 ? engine::Disc::first : engine::Disc::second};
            }
            const auto of = [&](int body) { return static_cast<std::size_t>(body); };
            system.b(column, 0) = -problem.given[column] -
                                  row.jacobian.a.dot(system.free_acceleration[of(row.body_a)]) -
                                  row.jacobian.b.dot(system.free_acceleration[of(row.body_b)]);
            rows.push_back(row);
        }
    }
    engine::Columns guess = engine::Columns::Zero(problem.given.size(), 1);
    return {problem.title, std::move(rows), std::move(system), std::move(guess)};
}

std::optional<GlobalProblem> global_form(const FrozenProblem& problem) {
    const engine::SystemEquation& system = problem.system();
    const std::span<const ConstraintRow> rows = system.rows;
    if (rows.size() % 3 != 0) return std::nullopt;
    for (std::size_t j = 0; j < rows.size(); j += 3) {
        if (!is_contact(rows, j)) return std::nullopt;
    }
    // Static bodies have no unknowns.
    std::vector<int> number(system.inverse_mass.size(), -1);
    int count = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (system.inverse_mass[i].linear > 0.0) number[i] = count++;
    }
    const int n = unknowns * count;
    const auto contacts = static_cast<Eigen::Index>(rows.size() / 3);
    GlobalProblem global{.title = problem.name(),
                         .mass = SparseMatrix(n, n),
                         .axes = SparseMatrix(n, 3 * contacts),
                         .force = VectorX(n),
                         .given = VectorX(3 * contacts),
                         .mu = VectorX(contacts)};
    std::vector<Eigen::Triplet<double>> mass, axes;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] < 0) continue;
        const int first = unknowns * number[i];
        const engine::InverseMass& inverse = system.inverse_mass[i];
        const double own = 1.0 / inverse.linear;
        const Matrix3 inertia = inverse.angular.inverse();
        add_block(own * Matrix3::Identity(), first, first, mass);
        add_block(inertia, first + 3, first + 3, mass);
        const Vector6 velocity = system.dt * system.free_acceleration[i];
        global.force.segment<3>(first) = own * velocity.head<3>();
        global.force.segment<3>(first + 3) = inertia * velocity.tail<3>();
    }
    for (std::size_t j = 0; j < rows.size(); ++j) {
        const ConstraintRow& row = rows[j];
        double free = 0.0;
        for (const auto& [body, part] : {std::pair{row.body_a, &row.jacobian.a}, {row.body_b, &row.jacobian.b}}) {
            const int own = number[static_cast<std::size_t>(body)];
            if (own < 0) continue;
            add_block(*part, unknowns * own, static_cast<int>(j), axes);
            free += part->dot(system.dt * system.free_acceleration[static_cast<std::size_t>(body)]);
        }
        const auto index = static_cast<Eigen::Index>(j);
        // b dt = -w - J v_free, so that what a static body, a push or a belt does is in w.
        global.given[index] = -system.dt * system.b(index, 0) - free;
        if (j % 3 == 1) global.mu[index / 3] = row.bounds.c_max;
    }
    global.mass.setFromTriplets(mass.begin(), mass.end());
    global.axes.setFromTriplets(axes.begin(), axes.end());
    return global;
}

engine::VectorX impulses_of(const engine::Columns& lambda) {
    return lambda.col(0);
}

}  // namespace pushfactor::tests::problems
