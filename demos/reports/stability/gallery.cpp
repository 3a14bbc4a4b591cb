#include "demos/reports/stability/gallery.h"

#include "demos/output_file.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/framing.h"
#include "demos/pictures/layout.h"
#include "demos/pictures/studio.h"
#include "demos/pictures/survey.h"
#include "renderer/png.h"
#include "renderer/renderer_error.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::stability {

namespace {

namespace fs = std::filesystem;

constexpr pictures::Size thumbnail{320, 180};  // pixels
constexpr int columns = 3;
constexpr int samples = 4;
constexpr float letters = 11.0f;  // pixels

// Blank where the state lies beyond what a picture can hold.
renderer::Image draw(pictures::Studio& studio, const pictures::Size& size, const fs::path& state) {
    const Choices choices = understand(state.string(), {});
    const Scene scene = choices.build();
    const double aspect = static_cast<double>(size.width) / size.height;
    const View view = pictures::fitted(choices.description.view, pictures::movable_balls(scene), aspect);
    try {
        return studio.draw(pictures::draw_list(scene, view), size, samples);
    } catch (const renderer::RendererError&) {
        return renderer::blank_image(size.width, size.height, glm::vec3(0.9f));
    }
}

std::string label_of(const Trial& trial) {
    return fmt::format("{}, {}: {}{}", trial.one().name, trial.expected().preset, trial.outcome(),
                       trial.holds() ? "" : " (not as expected)");
}

}  // namespace

Gallery::Gallery(fs::path folder) : folder_(std::move(folder)) {
    try {
        studio_ = std::make_unique<pictures::Studio>();
    } catch (const renderer::RendererError& error) {
        missing_ = error.what();
    }
}

Gallery::~Gallery() = default;

std::string Gallery::hang(const std::string& name, std::span<const Trial> trials) const {
    std::vector<const Trial*> shown;
    for (const Trial& trial : trials) {
        if (studio_ && fs::exists(trial.state())) shown.push_back(&trial);
    }
    if (shown.empty()) return {};
    const int across = std::min(columns, static_cast<int>(shown.size()));
    const int rows = (static_cast<int>(shown.size()) + across - 1) / across;
    const pictures::Layout layout =
        pictures::grid({across * thumbnail.width, rows * thumbnail.height}, across, rows);
    std::vector<renderer::Image> images;
    for (const Trial* trial : shown) images.push_back(draw(*studio_, layout.cell, trial->state()));
    renderer::Image sheet = pictures::assemble(layout, images);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        studio_->lettering().name(sheet, layout.place(i), label_of(*shown[i]), letters);
    }
    const std::vector<std::uint8_t> bytes = renderer::encode_png(sheet);
    write_file(folder_ / (name + ".png"), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return name + ".png";
}

}  // namespace pushfactor::demos::reports::stability
