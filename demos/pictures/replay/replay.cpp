#include "demos/pictures/replay/replay.h"

#include "demos/base/platform/version.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/median.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/lettering.h"
#include "demos/pictures/replay/stage.h"
#include "demos/runs/records.h"
#include "engine/bodies/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::pictures {

namespace {

using namespace replay;

constexpr std::size_t numbers_per_pose = 7;
constexpr std::size_t numbers_per_velocity = 6;

// Below this share of the largest of a frame a force or push is rounding noise, which no arrow shows.
constexpr double negligible = 1e-5;

// Numbers in a block: 16 MB here, and as much in the page.
constexpr long most_numbers = 1L << 21;

std::string quantities_text(std::vector<std::vector<std::int64_t>>& quantities) {
    std::string bytes;
    for (std::vector<std::int64_t>& values : quantities) {
        append_quantity(bytes, values);
        values.clear();
    }
    return bytes;
}

// Each number to the quantity at its place.
template <std::size_t n, typename Quantities>
void append(const std::array<std::int64_t, n>& numbers, Quantities quantity) {
    for (const std::int64_t number : numbers) (quantity++)->push_back(number);
}

}  // namespace

Frames replay_frames(const Choices& choices) {
    const Rational& dt = choices.settings.dt;
    const Rational sixtieth = Rational{1, 60} / dt;
    const long every = choices.frames.fps ? steps_a_frame(*choices.frames.fps, dt, choices.frames.play_speed)
                                          : (sixtieth.numerator + sixtieth.denominator - 1) / sixtieth.denominator;
    return {every, static_cast<std::size_t>(whole_steps(choices.settings) / every) + 1};
}

void check_replay_name(const std::filesystem::path& file) {
    if (file == "-" || file.extension() == ".html") return;
    throw UsageError("--replay {}: must end in .html", file.string());
}

Replay::Replay(const ReplayChoices& choices, const Session& session)
    : choices_(choices),
      frames_(session.choices(0).frames),
      file_(choices.file),
      has_camera_(session.choices(0).description.has_camera || frames_.camera.view) {
    long numbers = 1;
    for (std::size_t panel = 0; panel < session.size(); ++panel) {
        const Simulation& run = session.run(panel);
        const BuiltScene& scene = run.scene();
        require_drawable(scene);
        std::vector<double> units;
        for (std::size_t i = 0; i < scene.world.bodies.size(); ++i) {
            units.push_back(position_unit * size_of(scene, i));
        }
        Track track{.simulation = &run,
                    .start = movable_balls(scene),
                    .extents = Extents(run, frames_.camera.fit),
                    .bodies = recorded_bodies(scene),
                    .forces = ForceBlock(units)};
        track.poses.resize(numbers_per_pose * track.bodies.size());
        track.velocities.resize(choices.poses_only ? 0 : numbers_per_velocity * track.bodies.size());
        track.orientations.resize(track.bodies.size());
        numbers += static_cast<long>(track.poses.size() + track.velocities.size());
        tracks_.push_back(std::move(track));
    }
    block_length_ = std::clamp(most_numbers / numbers, 16L, 256L);
    write_head(session.sequence());
}

// As add_overview() and the film have them, which run the scene once before they draw it: the page gets its cameras
// at the end.
std::vector<View> Replay::views() const {
    std::vector<Ball> reached;
    Outline outline;
    for (const Track& track : tracks_) track.extents.add_to(outline, reached);
    const Subject subject = subject_of(tracks_.back().simulation->scene(), outline);
    std::vector<View> views;
    for (const Track& track : tracks_) {
        View view = frames_.camera.view.value_or(track.simulation->scene().view);
        if (!has_camera_) {
            view = overview(view, tracks_.front().start, reached, least_aspect(frames_, tracks_.size()));
        }
        views.push_back(frames_.camera.fit ? composed(view, subject, frames_.aspect()) : view);
    }
    return views;
}

void Replay::write_head(const Sequence& sequence) {
    const std::vector<ComparedRun>& panels = sequence.panels;
    const Choices& first = panels.front().choices;
    Json about;
    about["scene"] = first.description.name;
    // What the caption says of one run need not be true of the others.
    about["caption"] = panels.size() == 1 || frames_.compare ? caption_of(first) : first.description.name;
    about["command"] = choices_.command;
    about["version"] = version_text();
    about["play_speed"] = frames_.play_speed.value();
    about["seconds_a_frame"] = (first.settings.dt * Rational{sequence.frames.front().every(), 1}).value();
    about["width"] = frames_.width;
    about["height"] = frames_.height;
    about["units"] = {{"position", position_unit}, {"orientation", orientation_unit}, {"velocity", velocity_unit}};
    about["parts"] = choices_.poses_only ? Json{"poses"} : Json{"poses", "velocities", "forces"};
    about["overlay"] = Json::array();
    for (const OverlayItem& item : frames_.overlay) {
        Json shown{{"kind", name_of(item.kind)}};
        if (item.units_a_metre) shown["units_a_metre"] = *item.units_a_metre;
        about["overlay"].push_back(shown);
    }
    about["legend"] = legend_of_arrows();
    about["runs"] = panels.size();
    about["degrees_a_second"] = frames_.camera.degrees_a_second;
    if (frames_.compare) about["compared"] = frames_.compare->option;
    page_ = page_about(about);
    file_.write(page_.before);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const Simulation& run = *tracks_[i].simulation;
        file_.write(data_block(fmt::format("data-part=\"stage\" data-run=\"{}\"", i),
                               json_text(stage_of(panels[i], run), -1, true)));
        const std::string meshes = polyhedra_of(run);
        if (!meshes.empty()) {
            file_.write(data_block(fmt::format("data-part=\"meshes\" data-run=\"{}\"", i), meshes));
        }
    }
}

void Replay::frame(std::size_t) {
    std::map<OverlayKind, double> largest;
    for (Track& track : tracks_) record(track, largest);
    for (const auto& [kind, value] : largest) {
        if (value > 0.0) maxima_[kind].push_back(value);
    }
    ++recorded_;
    if (++in_block_ == block_length_) write_blocks();
}

void Replay::record(Track& track, std::map<OverlayKind, double>& largest) {
    record_poses(track);
    track.extents.add_places();
    track.extents.add_outline();
    const Sample& sample = track.simulation->sample();
    const std::array measured{sample.kinetic_energy, sample.potential_energy, sample.penetration.max,
                              sample.max_speed, sample.residual};
    for (std::size_t i = 0; i < measured.size(); ++i) track.measures[i].push_back(static_cast<float>(measured[i]));
    if (choices_.poses_only) return;
    double& speed = largest[OverlayKind::velocities];
    for (const engine::Body& body : track.simulation->scene().world.bodies) {
        speed = std::max(speed, velocity(body).norm());
    }
    record_forces(track, largest);
}

void Replay::record_poses(Track& track) const {
    const BuiltScene& scene = track.simulation->scene();
    for (std::size_t i = 0; i < track.bodies.size(); ++i) {
        const engine::Body& body = scene.world.bodies[track.bodies[i]];
        const double size = size_of(scene, track.bodies[i]);
        track.orientations[i] = orientation_in_units(body.orientation, track.orientations[i]);
        const auto pose = track.poses.begin() + static_cast<std::ptrdiff_t>(numbers_per_pose * i);
        append(vector_in_units(body.position, position_unit * size), pose);
        append(track.orientations[i], pose + 3);
        if (choices_.poses_only) continue;
        const auto motion = track.velocities.begin() + static_cast<std::ptrdiff_t>(numbers_per_velocity * i);
        append(vector_in_units(velocity(body), velocity_unit * size), motion);
        append(vector_in_units(angular_velocity(body), velocity_unit), motion + 3);
    }
}

void Replay::record_forces(Track& track, std::map<OverlayKind, double>& largest) const {
    const std::vector<Acting> acting = all_acting_in(track.simulation->scene());
    double force = 0.0, push = 0.0;
    for (const Acting& at : acting) {
        force = std::max(force, at.force.norm());
        push = std::max({push, at.correcting.norm(), at.lasting.norm()});
    }
    track.forces.add(acting, negligible * force, negligible * push);
    largest[OverlayKind::forces] = std::max(largest[OverlayKind::forces], force);
    largest[OverlayKind::push] = std::max(largest[OverlayKind::push], push);
}

void Replay::write_blocks() {
    if (in_block_ == 0) return;
    for (std::size_t run = 0; run < tracks_.size(); ++run) {
        Track& track = tracks_[run];
        const auto write = [&](const char* part, const std::string& bytes) {
            file_.write(
                data_block(fmt::format("data-part=\"{}\" data-run=\"{}\" data-first=\"{}\" data-count=\"{}\"", part,
                                       run, recorded_ - in_block_, in_block_),
                           bytes));
        };
        write("poses", quantities_text(track.poses));
        std::string measures;
        for (std::vector<float>& values : track.measures) {
            for (const float value : values) append_raw(measures, value);
            values.clear();
        }
        write("measures", measures);
        if (choices_.poses_only) continue;
        write("velocities", quantities_text(track.velocities));
        write("forces", track.forces.take());
    }
    in_block_ = 0;
}

void Replay::finish(const std::string& note) {
    write_blocks();
    Json end;
    end["frames"] = recorded_;
    end["note"] = note;
    for (const auto& [kind, values] : maxima_) end["typical"][std::string(name_of(kind))] = median(values);
    const std::vector<View> seen = views();
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        const Track& track = tracks_[i];
        const Sample& sample = track.simulation->sample();
        end["cameras"].push_back(camera_of(seen[i], track.start));
        end["runs"].push_back(
            {{"steps", sample.step},
             {"time", sample.time},
             {"state_hash", fmt::format("{:016x}", engine::state_hash(track.simulation->scene().world.bodies))}});
    }
    file_.write(end_block(end));
    file_.write(page_.after);
    file_.commit();
}

std::string Replay::keep(const std::string& why) {
    return kept(file_.name(), fmt::format("frame {}", recorded_ - 1), [&] { finish(why); });
}

}  // namespace pushfactor::demos::pictures
