// Writes what tests compare with: the golden images in assets/golden and the scene files in tests/scenes. Run it
// after an intended change, and look at what git says has changed before you commit.
#include "demos/base/platform/output_file.h"
#include "demos/scenes/scene_file.h"
#include "tests/demos/reports/stability_files.h"
#include "tests/renderer/golden.h"

int main() {
    using namespace pushfactor;
    for (const renderer::golden::Sample& sample : renderer::golden::samples()) {
        renderer::OffscreenRenderer offscreen(renderer::golden::width, renderer::golden::height, sample.samples);
        renderer::golden::write_image(renderer::golden::golden_file(sample), offscreen.render(sample.picture));
    }
    for (const auto& [name, scene] : demos::reports::stability::scenes_with_files()) {
        demos::write_file(demos::reports::stability::file_of(name), demos::scene_file_text(scene));
    }
}
