// The numbers of a replay: what is read back, and how far it is from what was written.
#include "demos/pictures/replay/bytes.h"
#include "demos/pictures/replay/page.h"
#include "tests/catch.h"
#include "tests/demos/replay/decoder.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor::demos::pictures;
using namespace pushfactor::demos::pictures::replay;
using namespace pushfactor::tests;
using pushfactor::engine::Quaternion;
using pushfactor::engine::Vector3;

namespace {

Quaternion read_orientation(const std::array<std::int64_t, 4>& units) {
    return Quaternion(static_cast<double>(units[0]), static_cast<double>(units[1]), static_cast<double>(units[2]),
                      static_cast<double>(units[3]))
        .normalized();
}

// The rotation from a to b [rad].
double angle_between(const Quaternion& a, const Quaternion& b) {
    const Quaternion turn = a.conjugate() * b;
    return 2.0 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
}

Vector3 vector_of(const std::array<double, 3>& numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

// The item's vectors are those of `at`, up to the error that forces.h promises.
void check_read(const ReadItem& item, const Acting& at, double position_unit_m) {
    CHECK(item.kind == static_cast<std::int64_t>(at.kind));
    CHECK(item.body == at.body);
    CHECK(item.other == at.other);
    for (int axis = 0; axis < 3; ++axis) {
        const double read = static_cast<double>(item.place[static_cast<std::size_t>(axis)]) * position_unit_m;
        CHECK(std::abs(read - at.place[axis]) <= 0.5001 * position_unit_m);
    }
    const std::array written{at.force, at.correcting, at.lasting};
    for (std::size_t v = 0; v < written.size(); ++v) {
        const double largest = written[v].cwiseAbs().maxCoeff();
        CHECK((vector_of(item.vectors[v]) - written[v]).cwiseAbs().maxCoeff() <= largest / 1024.0);
    }
}

}  // namespace

TEST_CASE("integers of a replay are read back: small ones, the largest, and every sign") {
    Random random(1);
    std::vector<std::int64_t> values{0, -1, 1, 63, 64, -64, -65, 127, 128, (1LL << 48), -(1LL << 48)};
    for (int i = 0; i < 2000; ++i) {
        values.push_back(
            static_cast<std::int64_t>(std::ldexp(random.in(-1, 1), static_cast<int>(random.in(0, 48)))));
    }
    std::string bytes;
    for (const std::int64_t value : values) append_integer(bytes, value);
    IntegerReader reader(bytes);
    for (const std::int64_t value : values) CHECK(reader.next() == value);
    CHECK(reader.is_at_end());
}

TEST_CASE("quantities of a replay are read back, and smooth ones take one byte per frame") {
    Random random(2);
    constexpr std::size_t frames = 200;
    std::vector<std::vector<std::int64_t>> written(6, std::vector<std::int64_t>(frames));
    for (std::size_t i = 0; i < frames; ++i) {
        const auto n = static_cast<std::int64_t>(i);
        written[0][i] = 12345;                                            // at rest
        written[1][i] = 100000 + 700 * n;                                 // uniform motion
        written[2][i] = 500000 - 27 * n * n;                              // falling
        written[3][i] = static_cast<std::int64_t>(random.in(-1e6, 1e6));  // noise
        written[4][i] = i < 100 ? 5 * n : 500;                            // comes to rest
        written[5][i] = (i % 2 == 0 ? 1 : -1) * (1LL << 48);              // the largest jumps
    }
    std::string bytes;
    std::vector<std::size_t> sizes;
    for (const auto& values : written) {
        const std::size_t before = bytes.size();
        append_quantity(bytes, values);
        sizes.push_back(bytes.size() - before);
    }
    CHECK(read_quantities(bytes, written.size(), frames) == written);
    CHECK(sizes[0] <= 4);
    for (const std::size_t smooth : {1u, 2u, 4u}) CHECK(sizes[smooth] <= frames + 12);
    // One frame, and a block that begins anywhere.
    std::string single;
    append_quantity(single, std::vector<std::int64_t>{-7});
    CHECK(read_quantities(single, 1, 1) == std::vector<std::vector<std::int64_t>>{{-7}});
}

TEST_CASE("positions are kept to 1e-4 of a body's radius and orientations to 1e-4 rad, however they turn") {
    Random random(3);
    double worst_place = 0.0, worst_angle = 0.0;
    std::array<std::int64_t, 4> last{};
    for (int i = 0; i < 20000; ++i) {
        const double radius = std::pow(10.0, random.in(-4, 4));
        const Vector3 place = radius * random.vector(-1000, 1000);
        const auto units = vector_in_units(place, position_unit * radius);
        Vector3 read;
        for (int axis = 0; axis < 3; ++axis) {
            read[axis] = static_cast<double>(units[static_cast<std::size_t>(axis)]) * (position_unit * radius);
        }
        worst_place = std::max(worst_place, (read - place).norm() / radius);
        const Quaternion turn = random.rotation();
        last = orientation_in_units(turn, last);
        worst_angle = std::max(worst_angle, angle_between(read_orientation(last), turn));
    }
    CHECK(worst_place <= 1e-4);  // 9.9e-5
    CHECK(worst_place > 8e-5);   // the bound is not idle
    CHECK(worst_angle <= 1e-4);  // 9.6e-5
    CHECK(worst_angle > 7e-5);
}

TEST_CASE("the orientation of a turning body does not jump to the opposite quaternion") {
    const Vector3 axis = Vector3(1, 2, -0.5).normalized();
    std::array<std::int64_t, 4> last = orientation_in_units(Quaternion::Identity(), {});
    for (int i = 1; i <= 400; ++i) {
        Quaternion turn(Eigen::AngleAxisd(0.05 * i, axis));
        if (i % 3 == 0) turn.coeffs() *= -1.0;  // the same rotation
        const auto next = orientation_in_units(turn, last);
        for (std::size_t k = 0; k < 4; ++k)
            CHECK(static_cast<double>(std::abs(next[k] - last[k])) <= 0.03 / orientation_unit);
        last = next;
    }
}

TEST_CASE("forces that appear and vanish are read back to 1/1024, in their order") {
    Random random(4);
    const std::vector<double> units{1e-4, 3e-5, 2e-3};
    ForceBlock block(units);
    for (int round = 0; round < 2; ++round) {  // the second block knows nothing of the first
        std::vector<std::vector<Acting>> written;
        for (int frame = 0; frame < 40; ++frame) {
            std::vector<Acting>& list = written.emplace_back();
            if (frame > 0 && frame % 4 != 0) {
                // The same contacts, with other forces.
                list = written[written.size() - 2];
                for (Acting& at : list) at.force *= random.in(0.5, 1.5);
                continue;
            }
            const int count = frame % 8 == 0 ? 0 : static_cast<int>(random.in(0, 12));
            for (int i = 0; i < count; ++i) {
                const double size = std::pow(10.0, random.in(-3, 6));
                list.push_back({.kind = static_cast<Acting::Kind>(random.in(0, 4.999)),
                                .body = static_cast<int>(random.in(0, 2.999)),
                                .other = static_cast<int>(random.in(0, 2.999)),
                                .place = random.vector(-5, 5),
                                .force = size * random.vector(-1, 1),
                                .correcting = i % 2 == 0 ? Vector3(Vector3::Zero()) : random.vector(-1, 1),
                                .lasting = i % 3 == 0 ? random.vector(-1e-3, 1e-3) : Vector3(Vector3::Zero())});
            }
        }
        for (const auto& list : written) block.add(list, 0.0, 0.0);
        const auto read = read_forces(block.take(), written.size());
        for (std::size_t frame = 0; frame < written.size(); ++frame) {
            REQUIRE(read[frame].size() == written[frame].size());
            for (std::size_t i = 0; i < written[frame].size(); ++i) {
                check_read(read[frame][i], written[frame][i],
                           units[static_cast<std::size_t>(written[frame][i].body)]);
            }
        }
    }
}

TEST_CASE("contacts at rest take no more than a byte per number, and negligible forces are zero") {
    ForceBlock block({1e-4, 1e-4});
    const Acting at{
        .kind = Acting::Kind::touching, .body = 1, .other = 0, .place = {1, 2, 3}, .force = {3, 100, 7}};
    const Acting faint{
        .kind = Acting::Kind::touching, .body = 1, .other = 0, .place = {1, 2, 3}, .force = {0, 1e-6, 0}};
    for (int frame = 0; frame < 100; ++frame) block.add(std::vector{at, faint}, 1e-3, 1e-6);
    const std::string bytes = block.take();
    CHECK(bytes.size() <= 100 * (1 + 2 * 15) + 60);
    const auto lists = read_forces(bytes, 100);
    CHECK(lists.back()[1].vectors[0] == std::array{0.0, 0.0, 0.0});
    CHECK(deflated(bytes).size() < 150);
}

TEST_CASE("base64 is that of RFC 4648") {
    const std::array<std::array<const char*, 2>, 5> known{
        {{"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foobar", "Zm9vYmFy"}}};
    for (const auto& [bytes, text] : known) CHECK(base64(bytes) == text);
}
