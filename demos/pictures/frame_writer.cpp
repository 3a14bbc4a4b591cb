#include "demos/pictures/frame_writer.h"

#include "demos/errors.h"
#include "demos/output_file.h"
#include "renderer/png.h"

#include <fmt/format.h>

namespace pushfactor::demos::pictures {

FrameWriter::FrameWriter(std::filesystem::path folder, bool png, const std::optional<std::string>& video,
                         const Rational& fps)
    : folder_(std::move(folder)),
      png_(png),
      video_name_(video),
      fps_(fps),
      can_film_(video_name_ && find_tool("ffmpeg")) {
    if (video_name_ && !can_film_) png_ = true;
}

void FrameWriter::encode(const std::string& name, const renderer::Image& image) {
    if (png_) {
        const std::vector<std::uint8_t> bytes = renderer::encode_png(image);
        write_file(folder_ / name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    if (!can_film_) return;
    if (!video_) video_ = std::make_unique<Video>(*video_name_, image.width, image.height, fps_);
    video_->add(image);
}

void FrameWriter::write(const std::string& name, renderer::Image image) {
    if (writing_.valid()) writing_.get();
    writing_ = std::async(std::launch::async, [this, name, image = std::move(image)] { encode(name, image); });
}

void FrameWriter::finish() {
    if (writing_.valid()) writing_.get();
    if (video_) video_->finish();
    if (video_name_ && !can_film_) {
        throw OutputError(
            fmt::format("{}: ffmpeg is not installed (Debian: apt install ffmpeg); the frames are in {}",
                        *video_name_, folder_.string()));
    }
}

}  // namespace pushfactor::demos::pictures
