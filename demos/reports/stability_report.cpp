// The report on the stress list: stability.csv (one line per case, preset and check), thumbnails, the scenes that
// are not in the catalogue, and the summary and last state of each run.
#include "demos/base/platform/output_file.h"
#include "demos/base/text/numbers.h"
#include "demos/base/text/suggest.h"
#include "demos/figures/figure_output.h"
#include "demos/pages/verdict_files.h"
#include "demos/pictures/camera/framing.h"
#include "demos/pictures/camera/layout.h"
#include "demos/pictures/draw_list.h"
#include "demos/reports/stability/stability.h"
#include "renderer/base/renderer_error.h"

#include <fmt/format.h>

#include <memory>

namespace pushfactor::demos::reports {

namespace {

using namespace stability;
using engine::Vector3;

constexpr pictures::Size thumbnail{320, 180};  // pixels
constexpr int columns = 3;
constexpr int samples = 4;
constexpr float letters = 11.0f;  // pixels

// The start of a scene: all finite bodies by their corners, because a ball around a floor or a card is mostly
// empty, and the fixed points of its distances.
std::vector<pictures::Ball> balls_of(const SceneDescription& start) {
    std::vector<pictures::Ball> balls;
    for (const BodyDescription& body : start.bodies) {
        std::ranges::copy(pictures::hull_of(body, body.position, body.orientation), std::back_inserter(balls));
    }
    for (const DistanceDescription& distance : start.distances) {
        if (distance.a.body == "world") balls.push_back({distance.a.point, 0.0});
    }
    return balls;
}

Eigen::AlignedBox3d place_of(const std::vector<pictures::Ball>& balls) {
    Eigen::AlignedBox3d place;
    for (const pictures::Ball& ball : balls) {
        place.extend(ball.centre + Vector3::Constant(ball.radius));
        place.extend(ball.centre - Vector3::Constant(ball.radius));
    }
    return place;
}

// A camera with the start and the end of the run in view, without bodies that ended so far away that nothing else
// would be visible.
View camera(const View& view, std::vector<pictures::Ball> balls, const BuiltScene& end, double aspect) {
    const std::vector<pictures::Ball> ended = pictures::movable_balls(end);
    if (balls.empty()) return pictures::fitted(view, ended, aspect);
    const Eigen::AlignedBox3d place = place_of(balls);
    for (const pictures::Ball& ball : ended) {
        if (place.exteriorDistance(ball.centre) < 2.0 * place.diagonal().norm()) balls.push_back(ball);
    }
    return pictures::fitted(view, balls, aspect);
}

// Blank if the state is beyond single precision.
renderer::Image draw(pictures::OffscreenRenderer& offscreen, const pictures::Size& size, const Trial& trial) {
    BuiltScene scene = build_scene(understand(trial.state().string(), {}));
    View view = trial.start().view;
    std::vector<pictures::Ball> balls = balls_of(trial.start());
    // Pictures have single precision, so scenes far from the origin are drawn shifted.
    const Eigen::AlignedBox3d place = place_of(balls);
    if (!place.isEmpty() && place.center().norm() > 100.0 * place.diagonal().norm()) {
        const Vector3 here = -trial.start().bodies.front().position;
        for (engine::Body& body : scene.world.bodies) body.position += here;
        for (pictures::Ball& ball : balls) ball.centre += here;
        for (Vector3* const point : {&view.eye, &view.target, &scene.view.eye, &scene.view.target}) *point += here;
    }
    const double aspect = static_cast<double>(size.width) / size.height;
    try {
        return offscreen.draw(pictures::draw_list(scene, camera(view, balls, scene, aspect)), size, samples);
    } catch (const renderer::RendererError&) {
        return renderer::blank_image(size.width, size.height, glm::vec3(0.9f));
    }
}

// Thumbnails of the last states of a chapter's runs, on one sheet: writes NAME.png and returns that name; empty if
// no run has a last state. Throws OutputError.
std::string hang(figures::FigureOutput& output, const std::string& name, std::span<const Trial> trials) {
    std::vector<const Trial*> shown;
    for (const Trial& trial : trials) {
        if (std::filesystem::exists(trial.state())) shown.push_back(&trial);
    }
    if (shown.empty()) return {};
    const int count = static_cast<int>(shown.size()), across = std::min(columns, count);
    const int rows = (count + across - 1) / across;
    const pictures::Layout layout =
        pictures::grid({across * thumbnail.width, rows * thumbnail.height}, across, rows);
    std::vector<renderer::Image> images;
    for (const Trial* trial : shown) images.push_back(draw(output.offscreen(), layout.cell, *trial));
    renderer::Image sheet = pictures::assemble(layout, images);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const Trial& trial = *shown[i];
        const std::string label = fmt::format("{}, {}: {}{}", trial.one().name, trial.expected().preset,
                                              trial.outcome(), trial.holds() ? "" : " (not as expected)");
        output.offscreen().lettering().name(sheet, layout.place(i), label, letters);
    }
    return output.save(sheet, name);
}

// "|acceleration_m_per_s2 - 0.4063| / 2"
std::string text_of_measure(const Check& check) {
    std::string text = check.measure;
    if (check.target != 0.0) text = fmt::format("|{} - {}|", text, to_text(check.target));
    if (check.scale != 1.0) text += " / " + to_text(check.scale);
    return text;
}

std::string text_of_bar(const Check& check, double bar) {
    return fmt::format("{} {}", check.at_least ? ">=" : "<=", to_text(bar));
}

std::string text_of_expected(const Trial& trial, const Verdict& verdict) {
    const std::string& outcome = trial.expected().outcome;
    if (!verdict.known) return outcome;
    return fmt::format("{}; {} instead of the bar", outcome, text_of_bar(*verdict.check, *verdict.known));
}

std::vector<Cell> line_of(const Trial& trial, const Verdict& verdict) {
    const Check* const check = verdict.check;
    return {trial.one().name,
            trial.expected().preset,
            trial.outcome(),
            text_of_expected(trial, verdict),
            check ? text_of_measure(*check) : "",
            verdict.value,
            check ? text_of_bar(*check, check->bar) : "",
            !verdict.holds ? "no"
            : verdict.met  ? "yes"
                           : "known miss",
            trial.command()};
}

// Empty if all verdicts hold.
std::string failure_of(const Trial& trial) {
    std::string text;
    for (const Verdict& verdict : trial.verdicts()) {
        if (verdict.holds) continue;
        const std::string measured = verdict.check
                                         ? fmt::format("{} is {}, ", text_of_measure(*verdict.check),
                                                       verdict.value ? to_text(*verdict.value) : "unknown")
                                         : "";
        text += fmt::format("{}{}outcome {}, expected {}", text.empty() ? "" : "; ", measured, trial.outcome(),
                            text_of_expected(trial, verdict));
    }
    return text.empty() ? text : text + "; " + trial.command();
}

std::vector<Chapter> chapters_of(const StudyRequest& request) {
    return request.wanted(chapters(request.quick), &Chapter::name);
}

// They refer to the chapter.
std::vector<Trial> trials_of(const Chapter& chapter, const std::filesystem::path& folder) {
    std::vector<Trial> trials;
    for (const Case& one : chapter.cases) {
        for (const Expected& expected : one.expected) trials.emplace_back(one, expected, folder);
    }
    return trials;
}

// A piece is a trial.
Pieces stability_pieces(const StudyRequest& request) {
    const auto all = std::make_shared<const std::vector<Chapter>>(chapters_of(request));
    if (request.merged.empty()) write_scenes(*all, request.folder);
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    Pieces pieces;
    for (const Chapter& chapter : *all) {
        for (const Trial& trial : trials_of(chapter, request.folder)) {
            pieces.push_back(
                {trial.key(), [all, trial, program](const StopCheck& check) { return trial.run(program, check); }});
        }
    }
    return pieces;
}

class StabilityReport {
  public:
    explicit StabilityReport(StudyRun& run) : run_(run) {
        try {
            pictures_ = std::make_unique<figures::FigureOutput>(
                run.folder(), FigureFormat{.width = columns * thumbnail.width, .samples = samples});
        } catch (const renderer::RendererError& error) {
            no_pictures_ = fmt::format(" There are no pictures: {}", error.what());
        }
    }

    void make() {
        const std::vector<Chapter> all = chapters_of(run_.request());
        write_scenes(all, run_.folder());
        for (const Chapter& chapter : all) add_section(chapter);
        run_.write("stability.csv", csv_text(table_));
        run_.write_page(
            fmt::format("Stiff and extreme cases, each run and judged by the program. The outcome is that of the "
                        "last second; the bar is what is required, and where it is known not to be met the table "
                        "gives under \"expected\" the value that is reached. {} runs, {} numbers beyond their bar, "
                        "{} not as expected. The numbers are in stability.csv. Made with {}.{}{}",
                        trials_, missed_bars_, unexpected_.size(), run_.machine(),
                        run_.quick() ? " This is the quick report: the short cases." : "", no_pictures_));
        const std::string headline =
            unexpected_.empty() ? fmt::format("{} runs are as expected", trials_)
                                : fmt::format("{} of {} runs are not as expected", unexpected_.size(), trials_);
        const StudyRequest& request = run_.request();
        if (request.junit) write_file(*request.junit, junit_xml(suites_, std::time(nullptr)));
        if (request.markdown) write_file(*request.markdown, job_summary(headline, suites_));
        if (unexpected_.empty()) return;
        throw CheckError("{}, the first is {}; see {}", headline, unexpected_.front(),
                         (run_.folder() / "stability.csv").string());
    }

  private:
    void add_section(const Chapter& chapter) {
        std::vector<Trial> trials = trials_of(chapter, run_.folder());
        trials_ += trials.size();
        SuiteVerdict& suite = suites_.emplace_back(SuiteVerdict{.name = "stability/" + chapter.name});
        SectionContent content;
        Table own{table_.columns};
        own.columns.emplace_back(verdict_column);
        for (Trial& trial : trials) {
            trial.judge(run_.result(trial.key()));
            suite.cases.push_back({.name = trial.name(), .failure = failure_of(trial)});
            for (const Verdict& verdict : trial.verdicts()) {
                missed_bars_ += verdict.met ? 0 : 1;
                table_.rows.push_back(line_of(trial, verdict));
                own.rows.push_back(table_.rows.back());
                own.rows.back().emplace_back(word_of(!verdict.holds ? Mark::fails
                                                     : verdict.met  ? Mark::holds
                                                                    : Mark::known_miss));
            }
            if (!trial.holds()) {
                unexpected_.push_back(
                    fmt::format("{} ({}): {}", trial.one().name, trial.expected().preset, trial.outcome()));
            }
            if (std::filesystem::exists(run_.folder() / trial.replay())) content.replays.push_back(trial.replay());
        }
        // The verdict says on the page what the column `holds` says in the file.
        content.table = page_lines(
            own, {verdict_column, "case", "preset", "outcome", "expected", "measure", "value", "bar", "command"});
        const std::string picture = pictures_ ? hang(*pictures_, chapter.name, trials) : "";
        if (!picture.empty()) content.pictures.push_back(picture);
        run_.sections.push_back({chapter.name, chapter.heading, content});
    }

    StudyRun& run_;
    std::unique_ptr<figures::FigureOutput> pictures_;  // none without an offscreen context
    std::string no_pictures_;                          // says why
    Table table_{{"case", "preset", "outcome", "expected", "measure", "value", "bar", "holds", "command"}};
    std::vector<SuiteVerdict> suites_;  // one per chapter, with a case per run
    std::size_t trials_ = 0;
    int missed_bars_ = 0;
    std::vector<std::string> unexpected_;
};

}  // namespace

Study stability_study() {
    return {.name = "stability",
            .title = "stability",
            .parts = [] { return names_of(chapters(false)); },
            .make = [](StudyRun& run) { StabilityReport(run).make(); },
            .judges = true,
            .pieces = stability_pieces};
}

}  // namespace pushfactor::demos::reports
