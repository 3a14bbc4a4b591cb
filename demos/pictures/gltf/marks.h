// Arrows, lines and points of overlays in a glTF document. They appear and vanish, so that the nth of a kind is one
// node in all frames, with scale 0 in those that have fewer.
#pragma once

#include "demos/pictures/camera/survey.h"
#include "demos/pictures/gltf/document.h"
#include "demos/pictures/gltf/tracks.h"
#include "demos/runs/scene.h"
#include "renderer/picture/picture.h"

#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos::pictures::gltf {

class Marks {
  public:
    // Widths depend on `view`.
    Marks(const std::vector<OverlayItem>& overlay, const Survey& survey, const View& view);

    // Those of the scene's last step; arrows without length are left out.
    std::vector<Mark> of(const BuiltScene& scene) const;

    // Adds the nodes and their channels. `tracks` must outlive the document; `seconds` are the times of its frames
    // and `times` their accessor. A node has keys only in frames in which it changes.
    void add_to(Document& document, const Tracks& tracks, const Values& seconds, int times) const;

  private:
    enum class Form { arrow, line, point };
    struct Kind {
        OverlayKind overlay;
        Form form;
        std::string name;
        glm::vec3 colour;
    };

    std::size_t kind_of(OverlayKind overlay, Form form, const glm::vec3& colour) const;
    Stretch stretch_of(Form form) const;

    std::vector<Scale> scales_;
    std::vector<Kind> kinds_;
    double width_;  // m
};

// Adds the channels of those properties that change; `placed` is called for each of them again.
void add_stretched(Document& document, int node, int times, bool step, const std::function<Stretched()>& placed);

}  // namespace pushfactor::demos::pictures::gltf
