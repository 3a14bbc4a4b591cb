#include "demos/commands/commands.h"
#include "demos/draw_list.h"
#include "demos/errors.h"
#include "demos/observed_run.h"
#include "demos/output_file.h"
#include "demos/progress.h"
#include "renderer/png.h"
#include "renderer/renderer.h"

#include <fmt/format.h>

#include <future>

namespace pushfactor::demos::commands {

namespace {

namespace fs = std::filesystem;

std::string_view as_text(const std::vector<std::uint8_t>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Frames of an earlier, longer run would be taken for this one's; they are not ours to delete.
void warn_of_strangers(const fs::path& folder, const std::vector<Frame>& frames) {
    long strangers = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        const bool ours = std::any_of(frames.begin(), frames.end(), [&](const Frame& f) { return f.name == name; });
        if (entry.path().extension() == ".png" && !ours) ++strangers;
    }
    if (strangers > 0) {
        fmt::print(stderr, "pushfactor: note: {} holds {} other PNG files that this run does not touch\n",
                   folder.string(), strangers);
    }
}

// Encodes and writes one frame while the next one is simulated and drawn. Frames keep their order, at most one
// waits, and what goes wrong is thrown by the next call.
class FrameWriter {
  public:
    explicit FrameWriter(fs::path folder) : folder_(std::move(folder)) {}

    void write(const std::string& name, renderer::Image image) {
        finish();
        writing_ = std::async(std::launch::async, [path = folder_ / name, image = std::move(image)] {
            write_file(path, as_text(renderer::encode_png(image)));
        });
    }
    void finish() {
        if (writing_.valid()) writing_.get();
    }

  private:
    fs::path folder_;
    std::future<void> writing_;
};

void render_scene(const Choices& choices, const Request& request, const fs::path& folder,
                  renderer::Renderer& renderer) {
    ObservedRun observed(choices, request);
    const Simulation& simulation = observed.simulation();
    const long steps = whole_steps(choices.settings);
    const std::vector<Frame> frames = plan_frames(choices.frames, choices.settings.dt, steps);
    warn_of_strangers(folder, frames);
    write_file(folder / "config.json", config_text(choices, request.given));

    FrameWriter writer(folder);
    ProgressBar bar(choices.description.name, static_cast<long>(frames.size()));
    std::size_t done = 0;
    const auto advance_to = [&](long step) {
        while (simulation.sample().step < step) {
            stop_if_interrupted(fmt::format("{} of {} frames are in {}", done, frames.size(), folder.string()));
            observed.advance();
        }
    };
    for (const Frame& frame : frames) {
        advance_to(frame.step);
        writer.write(frame.name, renderer.render(draw_list(simulation.scene())));
        bar.show(static_cast<long>(++done));
    }
    writer.finish();
    advance_to(steps);
    write_file(request.summary ? fs::path(*request.summary) : folder / "summary.json", observed.finish());
}

}  // namespace

void render(const Request& request) {
    const bool several = request.scenes.size() > 1;
    for (const auto& [option, path] :
         {std::pair{"--csv", request.csv}, std::pair{"--trajectory", request.trajectory},
          std::pair{"--rows", request.rows}, std::pair{"--summary", request.summary}}) {
        if (several && path) throw UsageError(fmt::format("{} {}: must be for one scene at a time", option, *path));
    }

    // All input is understood and every folder made before the first frame is drawn.
    std::vector<std::pair<Choices, fs::path>> runs;
    for (const std::string& scene : request.scenes) {
        const Choices choices = understand(scene, request.given);
        // Planned here already for what it refuses.
        plan_frames(choices.frames, choices.settings.dt, whole_steps(choices.settings));
        const fs::path base = request.out.value_or("out");
        const fs::path folder = several || !request.out ? base / choices.description.name : base;
        const bool taken =
            std::any_of(runs.begin(), runs.end(), [&](const auto& run) { return run.second == folder; });
        if (taken) throw UsageError(fmt::format("scene {}: must not share its folder {}", scene, folder.string()));
        runs.emplace_back(choices, folder);
    }
    for (const auto& [choices, folder] : runs) make_folder(folder);

    const auto context = renderer::open_offscreen_context();
    const FrameChoices& frames = runs.front().first.frames;
    renderer::Renderer renderer(*context, frames.width, frames.height, fs::path(PUSHFACTOR_ASSET_DIR) / "shaders");
    for (const auto& [choices, folder] : runs) render_scene(choices, request, folder, renderer);
}

}  // namespace pushfactor::demos::commands
