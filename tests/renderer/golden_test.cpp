// Frames against the golden images in assets/golden. After an intended change build/release/tests/make_expected
// writes them anew; look at them before you commit.
#include "tests/renderer/golden.h"

#include "renderer/gl/offscreen_context.h"
#include "renderer/images/read_png.h"
#include "tests/catch.h"
#include "tests/renderer/image_difference.h"

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace pushfactor::renderer;
using namespace pushfactor::renderer::golden;

namespace {

Image read_image(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return decode_png(std::vector<std::uint8_t>{std::istreambuf_iterator<char>(stream), {}});
}

// Writes the drawn image and its difference for inspection, and reports where.
std::string report(const Sample& sample, const Image& golden, const Image& drawn) {
    const fs::path folder = PUSHFACTOR_GOLDEN_REPORTS;
    const fs::path drawn_file = folder / (sample.name + ".png");
    const fs::path difference_file = folder / (sample.name + "_difference.png");
    write_image(drawn_file, drawn);
    write_image(difference_file, heat_map(golden, drawn));
    const ImageDifference difference(golden, drawn);
    return "drawn: " + drawn_file.string() + "\ndifference: " + difference_file.string() +
           "\ngolden: " + golden_file(sample).string() +
           "\npixels that differ by more than 2 levels: " + std::to_string(100.0 * difference.share_above(2)) +
           " % (0.2 allowed), by more than 16: " + std::to_string(100.0 * difference.share_above(16)) +
           " % (0.02 allowed), similarity " + std::to_string(difference.similarity()) + " dB (at least 50)\n" +
           gl_version_of(*open_offscreen_context());
}

}  // namespace

TEST_CASE("Frames look as they are meant to") {
    for (const Sample& sample : samples()) {
        const fs::path file = golden_file(sample);
        if (!fs::exists(file)) {
            FAIL_CHECK(file.string() + " is missing; make it with build/release/tests/make_expected");
            continue;
        }
        const Image golden = read_image(file);
        const Image drawn = OffscreenRenderer(width, height, sample.samples).render(sample.picture);
        REQUIRE(golden.width == width);
        REQUIRE(golden.height == height);
        if (!same_to_the_eye(ImageDifference(golden, drawn))) FAIL_CHECK(report(sample, golden, drawn));
    }
}
