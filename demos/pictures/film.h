// A run, or several side by side, as one picture a moment.
#pragma once

#include "demos/pictures/layout.h"
#include "demos/pictures/survey.h"
#include "demos/simulation.h"

#include <vector>

namespace pushfactor::demos::pictures {

class Film {
  public:
    // `runs` are those of the panels, in the same order, at their start; they must outlive the film. `frames` are
    // the moments of each. Throws UsageError for an overlay that the scene has no part for.
    Film(Studio& studio, const std::vector<Panel>& panels, std::vector<const Simulation*> runs,
         const std::vector<std::vector<Frame>>& frames);

    // What the runs show now. Throws renderer::RendererError for what cannot be drawn.
    renderer::Image shoot() const;

  private:
    struct Scale {
        OverlayKind kind = OverlayKind::contacts;
        double units_a_metre = 1.0;
    };

    View place_camera(const Scene& scene, double across) const;
    renderer::Image draw(std::size_t panel) const;
    std::vector<LegendLine> legend(const View& view) const;
    void write(renderer::Image& sheet) const;

    Studio& studio_;
    FrameChoices choices_;
    std::vector<const Simulation*> runs_;
    std::vector<std::string> labels_;
    std::string caption_;
    Survey survey_;
    Layout layout_;
    std::vector<View> views_;  // of the panels, at the start
    std::vector<Scale> scales_;
};

}  // namespace pushfactor::demos::pictures
