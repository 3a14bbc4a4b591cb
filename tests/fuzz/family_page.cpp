#include "tests/fuzz/family_page.h"

#include "demos/base/platform/output_file.h"
#include "demos/pages/page.h"
#include "demos/pictures/camera/framing.h"
#include "demos/pictures/camera/layout.h"
#include "demos/pictures/camera/survey.h"
#include "demos/pictures/draw_list.h"
#include "demos/runs/measurements.h"
#include "demos/runs/simulation.h"
#include "renderer/base/renderer_error.h"
#include "renderer/images/png.h"
#include "tests/fuzz/random_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

namespace pushfactor::tests {

namespace {

using demos::families::Ends;
using demos::families::Family;

constexpr demos::pictures::Size strip{1278, 239};  // pixels
constexpr int samples = 4;
constexpr float letters = 12.0f;  // pixels
// The times of a strip's pictures, as shares of the run.
constexpr std::array<double, 3> moments{0.0, 0.2, 1.0};
constexpr double share_left_out = 0.1;  // of the bodies, of a picture
constexpr std::size_t most_listed = 20;

// The worst ratio of a property to its limit.
double beyond(const Judgement& judgement) {
    if (!judgement.error.empty()) return INFINITY;
    double worst = 0.0;
    for (const Measured& measured : judgement.of) {
        if (!measured.asked) continue;
        const double over = measured.at_least ? measured.bar / measured.value : measured.value / measured.bar;
        if (measured.value != measured.bar) worst = std::max(worst, over);
    }
    return worst;
}

std::vector<const JudgedMember*> of_family(const std::vector<JudgedMember>& judged, const Family& family) {
    std::vector<const JudgedMember*> members;
    for (const JudgedMember& one : judged) {
        if (one.member.family == &family) members.push_back(&one);
    }
    return members;
}

// Whether mechanics predicts where it ends and it does not end there.
bool ends_elsewhere(const JudgedMember& one) {
    return one.member.prospect.ends != Ends::rests &&
           (!one.judgement.error.empty() || !one.judgement[Property::ends].holds());
}

// Close enough for all bodies but a few that have flown off.
demos::View camera(const demos::BuiltScene& scene, const demos::View& from, double aspect) {
    std::vector<demos::pictures::Ball> balls = demos::pictures::movable_balls(scene);
    engine::Vector3 middle = engine::Vector3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> along;
        for (const demos::pictures::Ball& ball : balls) along.push_back(ball.centre[axis]);
        middle[axis] = demos::median(along);
    }
    std::sort(balls.begin(), balls.end(), [&](const auto& a, const auto& b) {
        return (a.centre - middle).squaredNorm() < (b.centre - middle).squaredNorm();
    });
    balls.resize(balls.size() - static_cast<std::size_t>(share_left_out * static_cast<double>(balls.size())));
    return demos::pictures::fitted(from, balls, aspect);
}

class Strips {
  public:
    Strips() {
        try {
            offscreen_ = std::make_unique<demos::pictures::OffscreenRenderer>();
        } catch (const renderer::RendererError& error) {
            missing_ = error.what();
        }
    }

    const std::string& missing() const { return missing_; }

    // Writes `file`, as far as the run goes. Returns whether there is anything to see.
    bool draw(const JudgedMember& one, const std::string& preset, const std::filesystem::path& file) const {
        if (!offscreen_) return false;
        const demos::SceneDescription scene = as_judged(one.member, preset);
        const auto layout = demos::pictures::grid(strip, static_cast<int>(moments.size()), 1);
        std::vector<renderer::Image> images;
        std::vector<std::string> names;
        try {
            const demos::Settings settings = settings_of(scene);
            demos::Simulation simulation(build_scene(scene, settings), settings);
            const long steps = whole_steps(settings);
            long step = 0;
            for (const double moment : moments) {
                for (; step < std::lround(moment * static_cast<double>(steps)); ++step) simulation.advance();
                const double aspect = static_cast<double>(layout.cell.width) / layout.cell.height;
                const demos::View view = camera(simulation.scene(), scene.view, aspect);
                images.push_back(
                    offscreen_->draw(demos::pictures::draw_list(simulation.scene(), view), layout.cell, samples));
                names.push_back(fmt::format("{:.2f} s", simulation.sample().time));
            }
        } catch (const std::exception&) {
            if (images.empty()) return false;
        }
        renderer::Image sheet = demos::pictures::assemble(layout, images);
        for (std::size_t i = 0; i < names.size(); ++i) {
            offscreen_->lettering().name(sheet, layout.place(i), names[i], letters);
        }
        const std::vector<std::uint8_t> bytes = renderer::encode_png(sheet);
        demos::write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        return true;
    }

  private:
    std::unique_ptr<demos::pictures::OffscreenRenderer> offscreen_;
    std::string missing_;
};

std::string caption_of(const JudgedMember& worst) {
    const std::string failures = failures_of(worst.judgement);
    return fmt::format("{} {} The worst of them: {}.", worst.member.family->sentence, worst.member.family->why,
                       failures.empty() ? "all holds" : failures);
}

// The table of a campaign with a verdict at the start of each family's line; the last line is that of all.
demos::TextTable marked_lines(const std::vector<JudgedMember>& judged) {
    demos::TextTable lines = family_lines(judged);
    lines.front().insert(lines.front().begin(), demos::verdict_column);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const bool all_hold = lines[i][1] == lines[i][2];  // members, hold
        std::string word(word_of(all_hold ? demos::Mark::holds : demos::Mark::fails));
        lines[i].insert(lines[i].begin(), i + 1 < lines.size() ? std::move(word) : "");
    }
    return lines;
}

demos::Section section_of(const Family& family, const std::vector<const JudgedMember*>& members,
                          const Strips& strips, const std::string& preset, const std::filesystem::path& folder) {
    const JudgedMember& worst = **std::max_element(
        members.begin(), members.end(),
        [](const JudgedMember* a, const JudgedMember* b) { return beyond(a->judgement) < beyond(b->judgement); });
    demos::SectionContent content;
    content.caption = caption_of(worst);
    content.commands = {worst.member.command()};
    const std::string picture = std::string(family.name) + ".png";
    if (strips.draw(worst, preset, folder / picture)) content.pictures.push_back(picture);
    for (const JudgedMember* one : members) {
        if (!ends_elsewhere(*one) || content.table.size() > most_listed) continue;
        if (content.table.empty()) content.table.push_back({"does not end as predicted", demos::command_column});
        content.table.push_back({failures_of(one->judgement), one->member.command()});
    }
    const auto hold = std::count_if(members.begin(), members.end(),
                                    [](const JudgedMember* one) { return one->judgement.holds(); });
    return {std::string(family.name), fmt::format("{}: {} of {} hold", family.name, hold, members.size()), content};
}

}  // namespace

void write_family_page(const std::vector<JudgedMember>& judged, const FamilyRequest& request,
                       const std::filesystem::path& folder) {
    demos::make_folder(folder);
    const Strips strips;
    std::vector<demos::Section> sections{{"table", "The worst of each property", {}}};
    sections.front().content.table = marked_lines(judged);
    for (const Family& family : demos::families::families()) {
        const std::vector<const JudgedMember*> members = of_family(judged, family);
        if (!members.empty()) sections.push_back(section_of(family, members, strips, request.preset, folder));
    }
    const std::string opening = fmt::format(
        "{} random members of the families under the preset {}, compared with mechanics; of each family the member "
        "that is farthest beyond a limit. Lengths are in edges of the smallest body, speeds in sqrt(g L), energy "
        "in m g L; the properties are defined in tests/fuzz/structures.h.{}",
        judged.size(), request.preset,
        strips.missing().empty() ? "" : " There are no pictures: " + strips.missing());
    demos::write_file(folder / "index.html", demos::page_text("Pushfactor: families", opening, sections));
}

}  // namespace pushfactor::tests
