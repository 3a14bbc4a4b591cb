// Packings of spheres and regular solids in a box: poured, and then shaken.
#include "demos/base/platform/assets.h"
#include "demos/base/text/csv.h"
#include "demos/base/text/numbers.h"
#include "demos/reports/reality/sections.h"
#include "demos/scenes/named/platonic.h"
#include "demos/scenes/random.h"
#include "engine/collision/polyhedron.h"

#include <fmt/format.h>

#include <numbers>

namespace pushfactor::demos::reports::reality {

namespace {

using engine::Vector3;

constexpr double radius = 0.5;                        // m, of the ball with the volume of a body
constexpr double volume = std::numbers::pi / 6.0;     // m^3
constexpr double height = 60.0, thickness = 2.0;      // m, of the walls
constexpr double away = 2.0;                          // m, from walls, floor and surface: two diameters
constexpr int across = 5, a_layer = across * across;  // bodies that are poured at once
constexpr double frequency = 3.0, amplitude = 0.1;    // 1/s, m: 3.6 g, so that bodies leave the floor

// The body at the origin; all solids have the same volume.
BodyDescription body_of(const std::string& solid) {
    if (solid == "sphere") return {.shape = SphereShape{radius}, .mass = 1.0};
    if (solid == "cube") return {.shape = BoxShape{Vector3::Constant(std::cbrt(volume))}, .mass = 1.0};
    const auto found = std::ranges::find(scenes::regular_solids(), solid, &scenes::RegularSolid::name);
    std::vector<Vector3> points(found->points.begin(), found->points.end());
    const double scale = std::cbrt(volume / make_polyhedron(points).shape.volume);
    for (Vector3& point : points) point *= scale;
    BodyDescription body{.mass = 1.0};
    give_polyhedron(body, make_polyhedron(points));
    return body;
}

bool is_inside(const BodyDescription& body, const Vector3& point) {
    const Vector3 own = body.orientation.conjugate() * (point - body.position);
    if (const auto* box = std::get_if<BoxShape>(&body.shape)) {
        return (own.cwiseAbs() - 0.5 * box->size).maxCoeff() <= 0.0;
    }
    if (const auto* polyhedron = std::get_if<PolyhedronShape>(&body.shape)) {
        const auto faces = polyhedron->mesh->hull().faces;
        return std::ranges::all_of(
            faces, [&own](const engine::collision::HullFace& face) { return face.normal.dot(own) <= face.offset; });
    }
    return own.squaredNorm() <= radius * radius;
}

class Filling {
  public:
    Filling(const std::string& solid, const Container& container)
        : kind_(body_of(solid)), container_(container), random_(1) {
        scene_.name = "packing of " + solid;
        scene_.contacts = true;
        settings_.threads = 1;
        settings_.friction = container.friction;
        settings_.rest = false;
        const double width = container.width, far = 0.5 * (width + thickness);
        add_wall({0, -0.5 * thickness, 0}, {width + 2 * thickness, thickness, width + 2 * thickness});
        for (const double side : {-far, far}) {
            add_wall({side, 0.5 * height, 0}, {thickness, height, width + 2 * thickness});
            add_wall({0, 0.5 * height, side}, {width, height, thickness});
        }
    }

    // Layer by layer, each from just above what lies there.
    void pour(const StopCheck& check) {
        for (int done = 0; done < container_.bodies; done += a_layer) {
            add_layer(std::min(a_layer, container_.bodies - done));
            run(1.0, check);
        }
        run(3.0, check);
    }

    void shake(const StopCheck& check) {
        for (BodyDescription& body : scene_.bodies) {
            if (!body.mass)
                body.motion = MotionDescription{.kind = ShakingMotion{amplitude, Vector3::UnitY(), frequency}};
        }
        run(container_.shakes / frequency, check);
        for (BodyDescription& body : scene_.bodies) body.motion.reset();
        run(3.0, check);
    }

    // Mean over eight parts of the region.
    Mean share() const {
        constexpr int samples = 20000;
        const std::vector<double> there = heights();
        const double surface = there.empty() ? 0.0 : there[there.size() * 9 / 10] + radius;  // above nine of ten
        const double side = 0.5 * container_.width - away, top = surface - away;
        scenes::Random random(2);
        std::vector<double> parts;
        for (int part = 0; part < 8; ++part) {
            int inside = 0;
            for (int i = 0; i < samples; ++i) {
                Vector3 point(random.in(0, side), 0, 0);
                point.z() = random.in(0, side);
                point.y() = random.in(0, 0.5 * (top - away));
                if (part & 1) point.x() -= side;
                if (part & 2) point.z() -= side;
                point.y() += away + (part & 4 ? 0.5 * (top - away) : 0.0);
                inside += std::ranges::any_of(scene_.bodies, [&](const BodyDescription& body) {
                    return body.mass && (body.position - point).squaredNorm() < 1.0 && is_inside(body, point);
                });
            }
            parts.push_back(static_cast<double>(inside) / samples);
        }
        return mean_of(parts);
    }

    double deepest() const { return deepest_; }

  private:
    void add_wall(const Vector3& position, const Vector3& size) {
        scene_.bodies.push_back(
            {.name = fmt::format("wall {}", scene_.bodies.size()), .shape = BoxShape{size}, .position = position});
    }

    // Of the bodies, the lowest first.
    std::vector<double> heights() const {
        std::vector<double> all;
        for (const BodyDescription& body : scene_.bodies) {
            if (body.mass) all.push_back(body.position.y());
        }
        std::ranges::sort(all);
        return all;
    }

    void add_layer(int count) {
        const std::vector<double> there = heights();
        const double top = there.empty() ? 0.0 : std::max(0.0, there.back());
        const double spacing = container_.width / across;
        for (int i = 0; i < count; ++i) {
            BodyDescription body = kind_;
            body.name = fmt::format("body {}", scene_.bodies.size());
            body.orientation = scenes::random_orientation(random_);
            // Off the grid, or balls would make columns.
            const double x = random_.in(-0.2, 0.2), z = random_.in(-0.2, 0.2);
            body.position = Vector3((i % across - 0.5 * (across - 1)) * spacing + x, top + 2.0,
                                    (i / across - 0.5 * (across - 1)) * spacing + z);
            scene_.bodies.push_back(body);
        }
    }

    void run(double seconds, const StopCheck& check) {
        Simulation simulation(build_scene(scene_, settings_), settings_);
        play_steps(simulation, std::lround(seconds / settings_.dt.value()), check);
        deepest_ = simulation.sample().penetration.max;
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
            take_state(simulation.scene().world.bodies[i], scene_.bodies[i]);
    }

    BodyDescription kind_;
    Container container_;
    scenes::Random random_;
    SceneDescription scene_;
    Settings settings_ = preset_settings("default");
    double deepest_ = 0.0;
};

// How many measured values are within 0.02 of what is computed for the frictions, or between.
struct Met {
    int met = 0, all = 0;

    void add(const std::optional<double>& measured, const std::vector<double>& computed) {
        if (!measured) return;
        const auto [low, high] = std::ranges::minmax(computed);
        ++all;
        met += *measured > low - 0.02 && *measured < high + 0.02 ? 1 : 0;
    }
};

}  // namespace

std::vector<MeasuredPacking> read_packings() {
    std::vector<MeasuredPacking> packings;
    const auto file = asset_folder("measured") / "packings.csv";
    for (const auto& cells : read_csv("packings", file, {"solid", "loose", "dense"})) {
        packings.push_back({cells[0], parse_number(cells[1]), parse_number(cells[2])});
    }
    return packings;
}

Packing packed(const std::string& solid, const Container& container, const StopCheck& check) {
    Filling filling(solid, container);
    filling.pour(check);
    Packing packing{.loose = filling.share()};
    filling.shake(check);
    packing.dense = filling.share();
    packing.deepest = filling.deepest();
    return packing;
}

void add_packings(StudyRun& run) {
    const std::vector<double> frictions = run.quick() ? std::vector{0.5} : std::vector{0.2, 0.8};
    const double width = run.quick() ? 6.0 : 8.0;
    const int bodies = run.quick() ? 300 : 600, shakes = run.quick() ? 10 : 40;
    const auto key = [&](const std::string& solid, double friction) {
        return fmt::format("reality: {} of {} with friction {}, shaken {} times", bodies, solid, friction, shakes);
    };
    Pieces pieces;
    std::vector<MeasuredPacking> wanted = read_packings();
    if (run.quick()) wanted = {wanted[0], wanted[2]};
    for (const MeasuredPacking& one : wanted) {
        for (const double friction : frictions) {
            const Container container{width, bodies, friction, shakes};
            pieces.push_back({key(one.solid, friction), [=, solid = one.solid](const StopCheck& check) {
                                  const Packing found = packed(solid, container, check);
                                  return json_numbers({found.loose.value, found.loose.error, found.dense.value,
                                                       found.dense.error, found.deepest});
                              }});
        }
    }
    run.gather(pieces);
    Table table{{"solid", "friction", "poured", "poured_error", "measured_loose", "shaken", "shaken_error",
                 "measured_dense", "deepest_overlap_m"}};
    Met loose, dense;
    for (const MeasuredPacking& one : wanted) {
        std::vector<double> poured, shaken;
        for (const double friction : frictions) {
            const std::vector<double> found = numbers_in(run.result(key(one.solid, friction)));
            table.rows.push_back(
                {one.solid, friction, found[0], found[1], one.loose, found[2], found[3], one.dense, found[4]});
            poured.push_back(found[0]);
            shaken.push_back(found[2]);
        }
        loose.add(one.loose, poured);
        dense.add(one.dense, shaken);
    }
    const std::string caption = fmt::format(
        "Share of the volume that {} equal bodies fill in a box {} m wide, 2 m and more from walls and surface; "
        "all have the volume of a ball of 1 m. They are poured in layers of 25, each from just above the heap, "
        "then shaken up and down {} times at 3 Hz by 0.1 m (3.6 g). Errors: one standard deviation of the mean "
        "over eight parts of the region. Measured: Baker and Kudrolli (2010, arXiv 1008.1728), +-0.01. Their "
        "friction is not known, and it decides how loose a heap is: {} of {} loose and {} of {} dense values are "
        "between those that are computed, or within 0.02 of one.",
        bodies, width, shakes, loose.met, loose.all, dense.met, dense.all);
    run.sections.push_back(
        {"packings", "Heaps of spheres and regular solids", run.tabulated("packings.csv", table, caption)});
}

}  // namespace pushfactor::demos::reports::reality
