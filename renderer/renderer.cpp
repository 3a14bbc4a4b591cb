#include "renderer/renderer.h"

#include "renderer/base/renderer_error.h"
#include "renderer/frames/frame_changes.h"
#include "renderer/frames/frame_checks.h"
#include "renderer/frames/painter.h"
#include "renderer/frames/render_target.h"
#include "renderer/gl/gl.h"
#include "renderer/images/sampling.h"
#include "renderer/images/smoothing.h"
#include "renderer/picture/bodies.h"
#include "renderer/picture/marks.h"
#include "renderer/picture/views.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pushfactor::renderer {
namespace {

int checked_side(int pixels) {
    if (pixels < 1 || pixels > Renderer::max_side) {
        throw RendererError("a picture's sides are 1 to " + std::to_string(Renderer::max_side) + " pixels, not " +
                            std::to_string(pixels));
    }
    return pixels;
}

int checked_samples(int samples) {
    if (samples < 1 || samples > Renderer::max_samples) {
        throw RendererError("a picture is the mean of 1 to " + std::to_string(Renderer::max_samples) +
                            " samples, not of " + std::to_string(samples));
    }
    return samples;
}

Light light_for(int samples) {
    if (samples == 1) return Light::at_once;
    return samples < Renderer::least_sky_samples ? Light::summed : Light::summed_with_sky;
}

}  // namespace

// Keeps the last frame and redraws only what the next one changes.
class Renderer::Pipeline {
  public:
    Pipeline(OffscreenContext& context, int width, int height, const std::filesystem::path& shaders, int samples,
             Stages* stages)
        : gl_(load_gl(context)),
          stages_(stages),
          samples_(samples),
          width_(width),
          height_(height),
          painter_(gl_, width, height, light_for(samples), shaders, stages),
          target_(gl_, width, height, samples > 1 ? Stored::light : Stored::bytes),
          frame_{
              width, height,
              std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))} {
        if (samples > 1) {
            mean_.emplace(width, height);
        } else {
            rgba_.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        }
    }

    const Image& draw(const Picture& picture) {
        FrameContents contents = contents_of(picture, 0, samples_);
        Tiles changed(width_, height_);
        if (drawn_) {
            changed = changed_tiles(*drawn_, contents);
        } else {
            changed.add_all();
        }
        drawn_.reset();  // until it is complete
        end(Stage::plan);
        if (!changed.none()) {
            samples_ == 1 ? draw_once(picture, contents, changed) : draw_mean(picture, contents, changed);
            check_gl_errors(gl_);
        }
        drawn_ = std::move(contents);
        return frame_;
    }

    // Each sample of another picture; a single sample is of the last.
    const Image& draw_spread(std::span<const Picture> pictures) {
        if (samples_ == 1) return draw(pictures.back());
        drawn_.reset();
        Tiles all(width_, height_);
        all.add_all();
        const std::vector<PixelArea> areas = all.areas();
        mean_->clear(areas);
        for (int sample = 0; sample < samples_; ++sample) {
            const auto which =
                static_cast<std::size_t>(sample) * pictures.size() / static_cast<std::size_t>(samples_);
            const Picture& picture = pictures[which];
            const FrameContents contents = contents_of(picture, sample, sample + 1);
            end(Stage::plan);
            draw_raw(picture, contents, 0, all);
            add_to_mean(areas);
        }
        mean_->put(samples_, areas, frame_);
        check_gl_errors(gl_);
        end(Stage::smooth);
        return frame_;
    }

    void end(Stage stage) const {
        if (stages_) stages_->end(stage);
    }

  private:
    // With the renderings from `first` to before `end`.
    FrameContents contents_of(const Picture& picture, int first, int end) const {
        const float scale = scale_of(picture.camera);
        FrameContents contents{.camera = picture.camera,
                               .background = picture.background,
                               .ground = picture.ground,
                               // Bodies beyond are invisible in the haze, however far they have been thrown.
                               .bodies = visible_bodies(picture, ground_reach * scale),
                               .panels = picture.panels,
                               .suns = {},
                               .views = {},
                               .skies = {}};
        const std::vector<Instance> bodies = contents.bodies.all();
        const float aspect = static_cast<float>(width_) / static_cast<float>(height_);
        // The corners of the ground are the farthest points drawn.
        const glm::mat4 world_to_clip = camera_view(picture.camera, aspect, 1.5f * ground_reach * scale);
        for (int index = first; index < end; ++index) {
            const SampleOffset offset = sample_offset(index, samples_, glm::normalize(picture.towards_sun));
            const glm::vec2 clip = 2.0f * offset.pixel / glm::vec2(width_, height_);
            const auto seen_from = [&](const glm::vec3& direction) {
                return sun_view(picture.camera, direction, bodies, ShadowMap::max_side);
            };
            contents.suns.push_back(seen_from(offset.towards_sun));
            contents.views.push_back(
                {.width = width_,
                 .height = height_,
                 .world_to_clip = glm::translate(glm::mat4(1.0f), glm::vec3(clip, 0.0f)) * world_to_clip,
                 .towards_sun = offset.towards_sun,
                 .texel = contents.suns.back().texel,
                 .pixel = pixel_at_one_metre(picture.camera, height_)});
            if (samples_ < least_sky_samples) continue;
            contents.skies.push_back({.above = seen_from(offset.towards_sky),
                                      .below = seen_from(-offset.towards_sky),
                                      .towards_sky = offset.towards_sky,
                                      .weight = offset.sky_weight});
        }
        return contents;
    }

    // Smoothing of a pixel depends on its surroundings, at most up to the adjacent tile.
    static_assert(smoothing_reach <= Tiles::side);
    void draw_once(const Picture& picture, const FrameContents& contents, const Tiles& changed) {
        draw_raw(picture, contents, 0, changed);
        target_.read(changed.areas(), rgba_);
        end(Stage::read);
        smooth_edges(rgba_, changed.with_neighbours().areas(), frame_);
        end(Stage::smooth);
    }

    void draw_mean(const Picture& picture, const FrameContents& contents, const Tiles& changed) {
        const std::vector<PixelArea> areas = changed.areas();
        mean_->clear(areas);
        for (std::size_t sample = 0; sample < contents.views.size(); ++sample) {
            draw_raw(picture, contents, sample, changed);
            add_to_mean(areas);
        }
        mean_->put(samples_, areas, frame_);
        end(Stage::smooth);
    }

    // In strips, so that little memory is needed besides the sum.
    void add_to_mean(const std::vector<PixelArea>& areas) {
        constexpr int rows = 32;
        for (const PixelArea& area : areas) {
            for (int y = area.y; y < area.y + area.height; y += rows) {
                const PixelArea strip{area.x, y, area.width, std::min(rows, area.y + area.height - y)};
                light_.resize(4 * static_cast<std::size_t>(strip.width) * static_cast<std::size_t>(strip.height));
                target_.read(strip, light_);
                mean_->add(light_, strip);
            }
        }
        end(Stage::read);
    }

    void draw_raw(const Picture& picture, const FrameContents& contents, std::size_t sample, const Tiles& tiles) {
        painter_.draw({.picture = picture,
                       .bodies = contents.bodies,
                       .sun = contents.suns[sample],
                       .view = contents.views[sample],
                       .sky = contents.skies.empty() ? nullptr : &contents.skies[sample]},
                      tiles, target_);
    }

    Gl gl_;
    Stages* stages_;
    int samples_;
    int width_;   // pixels
    int height_;  // pixels
    Painter painter_;
    RenderTarget target_;
    std::vector<std::uint8_t> rgba_;      // before smoothing; for one rendering
    std::vector<float> light_;            // a part of a rendering; for several
    std::optional<SampleMean> mean_;      // for several renderings
    Image frame_;                         // without marks
    std::optional<FrameContents> drawn_;  // contents of frame_
};

Renderer::Renderer(OffscreenContext& context, int width, int height, const std::filesystem::path& shader_directory,
                   int samples, Stages* stages)
    : context_(context),
      pipeline_(std::make_unique<Pipeline>(context, checked_side(width), checked_side(height), shader_directory,
                                           checked_samples(samples), stages)) {}

// The pipeline's GL objects are deleted in their own context.
Renderer::~Renderer() {
    context_.make_current();
}

Image Renderer::render(const Picture& picture) {
    Image image;
    render(std::span(&picture, 1), image);
    return image;
}

void Renderer::render(std::span<const Picture> pictures, Image& image) {
    if (pictures.empty()) throw RendererError("no picture to render");
    for (const Picture& picture : pictures) check(picture);
    context_.make_current();
    image = pictures.size() == 1 ? pipeline_->draw(pictures.front()) : pipeline_->draw_spread(pictures);
    draw_marks(image, pictures.back());
    if (shows_only(pictures.back().background.colour, image)) ++blank_;
    pipeline_->end(Stage::marks);
}

}  // namespace pushfactor::renderer
