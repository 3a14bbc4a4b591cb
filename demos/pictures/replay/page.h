// The page around the data of a replay: style, viewer and shaders from the assets, all inline.
#pragma once

#include "demos/base/text/json.h"

#include <string>
#include <string_view>

namespace pushfactor::demos::pictures::replay {

// Text of the page before and after its data. Throws OutputError if an asset is missing.
struct Page {
    std::string before, after;
};

// `about` is known at the start of the run.
Page page_about(const Json& about);

// A part of the data: inert for the browser until the viewer reads it. `attributes` say which part it is.
std::string data_block(std::string_view attributes, std::string_view bytes);

// What is known only at the end of the run.
std::string end_block(const Json& end);

// Compressed as a zlib stream (RFC 1950), which browsers inflate by themselves (DecompressionStream "deflate").
std::string deflated(std::string_view bytes);

// RFC 4648, section 4.
std::string base64(std::string_view bytes);

}  // namespace pushfactor::demos::pictures::replay
