#include "demos/pictures/film/frame_writer.h"

#include "demos/base/platform/output_file.h"
#include "renderer/images/png.h"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace pushfactor::demos::pictures {

FrameWriter::FrameWriter(std::filesystem::path folder, bool png, const std::optional<std::string>& video,
                         const Rational& fps, StageTimes* times, std::string film)
    : folder_(std::move(folder)),
      png_(png),
      video_name_(video),
      fps_(fps),
      film_(std::move(film)),
      queue_(std::bind_front(&FrameWriter::encode, this), times) {}

void FrameWriter::finish() {
    queue_.flush();
    if (video_) video_->finish();
}

FrameQueue::End FrameWriter::encode(const std::string& name, const renderer::Image& image, StageWatch& watch) {
    std::vector<std::uint8_t> png;
    if (png_) png = renderer::encode_png(image, {.dots_per_inch = 0.0, .film = film_});
    watch.end("encode");
    return [this, &name, &image, png = std::move(png)](StageWatch& own) {
        if (png_) write_file(folder_ / name, png);
        if (video_name_ && !video_) video_.emplace(*video_name_, image.width, image.height, fps_);
        if (video_) video_->add(image);
        own.end("write");
    };
}

}  // namespace pushfactor::demos::pictures
