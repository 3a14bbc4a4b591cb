#include "demos/base/platform/output_file.h"
#include "demos/base/platform/progress.h"
#include "demos/base/text/errors.h"
#include "demos/commands/commands.h"
#include "demos/pictures/film/video.h"
#include "demos/runs/session.h"
#include "renderer/base/renderer_error.h"
#include "renderer/images/read_png.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>

namespace pushfactor::demos::commands {

namespace {

namespace fs = std::filesystem;

// The film that all folders have frames of, and the mark of its frames.
Sequence film_of(const std::vector<std::string>& folders, std::string& mark) {
    const fs::path first = fs::path(folders.front()) / "config.json";
    for (const std::string& folder : folders) {
        const fs::path config = fs::path(folder) / "config.json";
        if (!fs::exists(config)) {
            throw UsageError("--join {}: must have a config.json, as `render` writes it", folder);
        }
        if (read_bytes_of(config) != read_bytes_of(first)) {
            throw UsageError("--join: must be of one film: {} differs from {}", config.string(), first.string());
        }
    }
    GivenOptions given;
    add_config(first, given);
    const auto* const scene = given.find("scene");
    if (!scene) throw UsageError("{}: scene: must be given", first.string());
    if (given.find("at")) throw UsageError("--join {}: must be a sequence, not stills", folders.front());
    Sequence film = plan_sequence(scene->text, given);
    mark = film_mark(film.panels.front().choices, given);
    return film;
}

// Where each frame is.
std::vector<fs::path> files_of(const Sequence& film, const std::vector<std::string>& folders) {
    std::vector<fs::path> files;
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < film.frame_count(); ++i) {
        const Frame frame = film.frames.front()[i];
        const auto found = std::ranges::find_if(
            folders, [&](const std::string& folder) { return fs::exists(fs::path(folder) / frame.name); });
        if (found == folders.end()) {
            missing.push_back(frame.name);
        } else {
            files.push_back(fs::path(*found) / frame.name);
        }
    }
    if (missing.empty()) return files;
    constexpr std::size_t most = 10;
    const std::size_t all = missing.size();
    missing.resize(std::min(all, most));
    throw RunError("--join: {} of {} frames are missing: {}{}", all, film.frame_count(), fmt::join(missing, ", "),
                   all > most ? ", ..." : "");
}

renderer::Image picture_in(const fs::path& file, const std::string& mark) {
    const std::string bytes = read_bytes_of(file).value_or("");
    const std::span png(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    try {
        renderer::Image image = renderer::decode_png(png);
        if (renderer::film_in_png(png) == mark) return image;
        throw UsageError(
            "--join: must be of one film: {} is of another than config.json, or was not drawn by this "
            "program; draw it again",
            file.string());
    } catch (const renderer::RendererError& error) {
        throw RunError("{}: {}", file.string(), error.what());
    }
}

}  // namespace

void carry_out(const Join& command) {
    pictures::require_ffmpeg(command.video);
    std::string mark;
    const Sequence film = film_of(command.folders, mark);
    const std::vector<fs::path> files = files_of(film, command.folders);
    const FrameChoices& frames = film.panels.front().choices.frames;
    pictures::Video video(command.video, frames.width, frames.height, frames.film_rate());
    ProgressBar bar("join", static_cast<long>(files.size()));
    for (std::size_t i = 0; i < files.size(); ++i) {
        stop_if_interrupted(fmt::format("{} of {} frames were read", i, files.size()));
        const renderer::Image image = picture_in(files[i], mark);
        if (image.width != frames.width || image.height != frames.height) {
            throw RunError("{}: must be {}x{} pixels, not {}x{}", files[i].string(), frames.width, frames.height,
                           image.width, image.height);
        }
        video.add(image);
        bar.show(static_cast<long>(i + 1));
    }
    video.finish();
    print(command.video + "\n");
}

}  // namespace pushfactor::demos::commands
