// Constants shared by the reader and the writer of scene files.
#pragma once

#include "demos/scenes/scene_description.h"

#include <array>
#include <string_view>
#include <utility>

namespace pushfactor::demos {

inline constexpr int scene_file_version = 1;

inline constexpr std::array<std::pair<std::string_view, engine::Distance::Acts>, 3> act_names{
    {{"both", engine::Distance::Acts::both},
     {"pulls", engine::Distance::Acts::pulls},
     {"pushes", engine::Distance::Acts::pushes}}};

inline constexpr std::array<std::pair<std::string_view, engine::Poke::Frame>, 2> frame_names{
    {{"world", engine::Poke::Frame::world}, {"body", engine::Poke::Frame::body}}};

}  // namespace pushfactor::demos
