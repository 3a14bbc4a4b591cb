#include "demos/pictures/frame_writer.h"

#include "demos/platform/output_file.h"
#include "demos/text/errors.h"
#include "renderer/images/png.h"

#include <algorithm>

namespace pushfactor::demos::pictures {

namespace {

constexpr std::size_t waiting = 2;  // frames
constexpr unsigned most_threads = 4;

}  // namespace

FrameWriter::FrameWriter(std::filesystem::path folder, bool png, const std::optional<std::string>& video,
                         const Rational& fps, StageTimes* times)
    : folder_(std::move(folder)), png_(png), video_name_(video), fps_(fps), times_(times), waiting_(waiting) {
    const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 1u, most_threads);
    for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

FrameWriter::~FrameWriter() {
    waiting_.close();
    join();
}

renderer::Image FrameWriter::blank() {
    const std::lock_guard lock(mutex_);
    if (blanks_.empty()) return {};
    renderer::Image image = std::move(blanks_.back());
    blanks_.pop_back();
    return image;
}

void FrameWriter::write(const std::string& name, renderer::Image image) {
    if (waiting_.send({sent_++, name, std::move(image)})) return;
    join();
    std::rethrow_exception(error_);
}

void FrameWriter::flush() {
    waiting_.close();
    join();
    if (error_) std::rethrow_exception(error_);
}

void FrameWriter::finish() {
    flush();
    if (video_) video_->finish();
}

std::size_t FrameWriter::written() const {
    const std::lock_guard lock(mutex_);
    return turn_;
}

void FrameWriter::join() {
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
}

void FrameWriter::work() {
    const ThreadWatch watch(times_);
    try {
        while (auto frame = waiting_.receive()) handle(*frame);
    } catch (...) {
        note_error();
    }
}

void FrameWriter::handle(Frame& frame) {
    StageWatch watch(times_);
    std::vector<std::uint8_t> bytes;
    if (png_) bytes = renderer::encode_png(frame.image);
    watch.end("encode");
    if (!wait_for_turn(frame.number)) return;
    watch.skip();
    put(frame, bytes);
    watch.end("write");
    end_turn(frame);
}

// False after an error, when the turn never comes.
bool FrameWriter::wait_for_turn(std::size_t number) {
    std::unique_lock lock(mutex_);
    turned_.wait(lock, [&] { return turn_ == number || error_; });
    return !error_;
}

void FrameWriter::put(const Frame& frame, const std::vector<std::uint8_t>& bytes) {
    if (png_) write_file(folder_ / frame.name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    if (!video_name_) return;
    if (!video_) video_ = std::make_unique<Video>(*video_name_, frame.image.width, frame.image.height, fps_);
    video_->add(frame.image);
}

void FrameWriter::end_turn(Frame& frame) {
    const std::lock_guard lock(mutex_);
    ++turn_;
    blanks_.push_back(std::move(frame.image));
    turned_.notify_all();
}

// Only the first error is kept; later ones are its consequences.
void FrameWriter::note_error() {
    waiting_.close();
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::current_exception();
    turned_.notify_all();
}

}  // namespace pushfactor::demos::pictures
