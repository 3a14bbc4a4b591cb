// Frames are written in order, whole, by several threads; the first error ends it.
#include "demos/pictures/film/frame_writer.h"

#include "demos/base/text/errors.h"
#include "renderer/base/renderer_error.h"
#include "renderer/images/png.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <fmt/format.h>

#include <optional>

using namespace pushfactor::demos;
using pushfactor::demos::pictures::FrameWriter;
using pushfactor::renderer::Image;
using pushfactor::tests::Folder;

namespace {

const Rational sixty{60, 1};

// Frames that take unequal times to encode: every third one is noise.
Image frame(int number) {
    Image image{200, 100, std::vector<std::uint8_t>(3 * 200 * 100, static_cast<std::uint8_t>(number))};
    std::uint32_t noise = 1;
    for (std::size_t i = 0; number % 3 == 0 && i < image.rgb.size(); ++i) {
        noise = 1664525u * noise + 1013904223u;
        image.rgb[i] = static_cast<std::uint8_t>(noise >> 24);
    }
    image.rgb[0] = static_cast<std::uint8_t>(number);
    return image;
}

std::string name(int number) {
    return fmt::format("frame_{:03}.png", number);
}

std::string png(const Image& image) {
    const auto bytes = pushfactor::renderer::encode_png(image);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

TEST_CASE("all frames are written, each with its own bytes") {
    const Folder folder;
    FrameWriter writer(folder.path(), true, std::nullopt, sixty);
    for (int i = 0; i < 40; ++i) {
        Image image = writer.queue().blank();
        image = frame(i);
        writer.queue().send(name(i), std::move(image));
    }
    writer.finish();
    CHECK(writer.queue().ended() == 40);
    CHECK(folder.files().size() == 40);
    for (int i = 0; i < 40; ++i) CHECK(folder.read(name(i)) == png(frame(i)));
}

TEST_CASE("while frames are written those that are there are the first ones") {
    const Folder folder;
    FrameWriter writer(folder.path(), true, std::nullopt, sixty);
    for (int i = 0; i < 60; ++i) {
        writer.queue().send(name(i), frame(i));
        bool before = true;
        // From the last to the first, as more may be written meanwhile.
        bool later = false;
        for (int k = i; k >= 0; --k) {
            const bool there = std::filesystem::exists(folder / name(k));
            before = before && (there || !later);
            later = later || there;
        }
        CHECK(before);
    }
    writer.finish();
}

TEST_CASE("the memory of frames that are written is used again") {
    const Folder folder;
    FrameWriter writer(folder.path(), true, std::nullopt, sixty);
    for (int i = 0; i < 30; ++i) writer.queue().send(name(i), frame(i));
    writer.queue().flush();
    std::size_t kept = 0;
    while (!writer.queue().blank().rgb.empty()) ++kept;
    CHECK(kept >= 1);
    CHECK(kept <= 30);
}

TEST_CASE("a frame that cannot be encoded ends the writing: those before it are there, none after it is") {
    const Folder folder;
    FrameWriter writer(folder.path(), true, std::nullopt, sixty);
    const auto write_all = [&] {
        for (int i = 0; i < 100; ++i) {
            Image image = frame(i);
            if (i == 7) image.rgb.pop_back();
            writer.queue().send(name(i), std::move(image));
        }
        writer.finish();
    };
    CHECK_THROWS_AS(write_all(), pushfactor::renderer::RendererError);
    CHECK(writer.queue().ended() <= 7);
    const std::vector<std::string> files = folder.files();
    CHECK(files.size() == writer.queue().ended());
    for (std::size_t i = 0; i < files.size(); ++i) {
        CHECK(files[i] == name(static_cast<int>(i)));
        CHECK(folder.read(files[i]) == png(frame(static_cast<int>(i))));
    }
}

TEST_CASE("a folder that is gone is named, by the first of the threads that misses it", "[threads]") {
    const Folder folder;
    FrameWriter writer(folder / "gone", true, std::nullopt, sixty);
    const auto write_all = [&] {
        for (int i = 0; i < 100; ++i) writer.queue().send(name(i), frame(i));
        writer.finish();
    };
    CHECK_THROWS_WITH(write_all(), Catch::Contains("gone/" + name(0)) && Catch::Contains("No such file"));
    CHECK(writer.queue().ended() == 0);
}

TEST_CASE("a writer that is given up writes what it was given") {
    const Folder folder;
    {
        FrameWriter writer(folder.path(), true, std::nullopt, sixty);
        for (int i = 0; i < 5; ++i) writer.queue().send(name(i), frame(i));
    }
    CHECK(folder.files().size() == 5);
}
