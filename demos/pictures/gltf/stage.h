// The nodes of a scene in a glTF document.
#pragma once

#include "demos/pictures/gltf/document.h"
#include "demos/pictures/gltf/tracks.h"
#include "demos/runs/scene.h"
#include "renderer/picture/picture.h"

#include <vector>

namespace pushfactor::demos::pictures::gltf {

// Adds a node per body, in the scene's order, as `picture` shows them (draw_list()): spheres are a ball of radius 1
// at the node's scale, planes a polygon as large as the view. Also the ground of a scene that only draws one.
// Returns the nodes of the bodies.
std::vector<int> add_bodies(const BuiltScene& scene, const renderer::Picture& picture, Document& document);

Segment segment_of(const renderer::Bar& bar);

// How a bar is drawn: as a cylinder that ends where the renderer's round ends do, or as a ball if it is shorter
// than thick.
Stretch stretch_of(const renderer::Bar& bar);

// Adds a node per bar of the picture, and a parent of all. Returns the nodes of the bars.
std::vector<int> add_bars(const renderer::Picture& picture, Document& document);

// Adds a camera that looks as `view` does, and the renderer's sun. Returns the node of the camera.
int add_camera(const View& view, double aspect, Document& document);
void add_sun(const renderer::Picture& picture, Document& document);

// Of a camera's node.
Pose pose_of(const View& view);

// The properties of a node at a stretched mesh's first key.
Json node_at(const std::string& name, int mesh, const Stretched& placed);

}  // namespace pushfactor::demos::pictures::gltf
