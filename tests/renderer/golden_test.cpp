// Frames against the golden images in assets/golden. After an intended change: build/release/tests/tests
// "[golden-update]" regenerates them; look at them before you commit.
#include "renderer/gl/offscreen_context.h"
#include "renderer/images/png.h"
#include "renderer/images/read_png.h"
#include "tests/catch.h"
#include "tests/renderer/image_difference.h"
#include "tests/renderer/sample_pictures.h"

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace pushfactor::renderer;

namespace {

namespace fs = std::filesystem;

constexpr int width = 320;   // pixels
constexpr int height = 180;  // pixels

struct Sample {
    std::string name;
    Picture picture;
    int samples = 1;
};

// A row of balls of several sizes on thin bars, as pendulums hang.
Picture pendulums() {
    Picture picture{.camera = {.eye = {7.0f, 5.0f, 15.0f}, .target = {0.0f, 2.5f, 0.0f}}, .ground = Ground{}};
    for (int i = 0; i < 9; ++i) {
        const auto step = static_cast<float>(i);
        const float angle = 0.25f * step - 1.0f;
        const glm::vec3 pivot(1.3f * step - 5.2f, 5.5f, 0.0f);
        const glm::vec3 ball = pivot + (3.0f + 0.2f * step) * glm::vec3(0.0f, -std::cos(angle), std::sin(angle));
        picture.bars.push_back({.from = pivot, .to = ball, .radius = 0.004f * step});
        picture.spheres.push_back({.position = ball,
                                   .orientation = glm::angleAxis(angle, glm::vec3(1.0f, 0.0f, 0.0f)),
                                   .radius = 0.2f + 0.05f * step,
                                   .colour = i % 3 == 0   ? red
                                             : i % 3 == 1 ? blue
                                                          : ivory});
    }
    return picture;
}

// The panels and balls of all_kinds() alone, from above, without a ground.
Picture funnel() {
    Picture picture = all_kinds();
    picture.ground.reset();
    picture.boxes.clear();
    picture.polyhedra.clear();
    picture.bars.clear();
    picture.camera = {.eye = {8.0f, 14.0f, 12.0f}, .target = {5.0f, 3.0f, 0.0f}};
    return picture;
}

std::vector<Sample> samples() {
    return {{.name = "cubes", .picture = stack_of_cubes(5)},
            {.name = "pendulums", .picture = pendulums()},
            {.name = "funnel", .picture = funnel()},
            {.name = "all_kinds", .picture = all_kinds()},
            {.name = "still", .picture = all_kinds(), .samples = 16}};
}

fs::path golden_file(const Sample& sample) {
    return fs::path(PUSHFACTOR_ASSET_DIR) / "golden" / (sample.name + ".png");
}

Image read_image(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return decode_png(std::vector<std::uint8_t>{std::istreambuf_iterator<char>(stream), {}});
}

void write_image(const fs::path& file, const Image& image) {
    fs::create_directories(file.parent_path());
    const std::vector<std::uint8_t> png = encode_png(image);
    std::ofstream stream(file, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    REQUIRE(stream.good());
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
            FAIL_CHECK(file.string() + " is missing; make it with: tests \"[golden-update]\"");
            continue;
        }
        const Image golden = read_image(file);
        const Image drawn = Studio(width, height, sample.samples).render(sample.picture);
        REQUIRE(golden.width == width);
        REQUIRE(golden.height == height);
        if (!same_to_the_eye(ImageDifference(golden, drawn))) FAIL_CHECK(report(sample, golden, drawn));
    }
}

TEST_CASE("Make the golden images", "[.golden-update]") {
    for (const Sample& sample : samples()) {
        write_image(golden_file(sample), Studio(width, height, sample.samples).render(sample.picture));
    }
}
