// A picture beside the file that is expected.
#pragma once

#include "demos/checks/tolerance.h"
#include "demos/checks/verdict.h"
#include "renderer/images/image.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace pushfactor::demos::checks {

using Bytes = std::vector<std::uint8_t>;

// The verdict, and for the page, if it does not hold, three PNG files; empty where there is none.
struct Compared {
    PictureVerdict verdict{};
    Bytes expected{}, actual{}, difference{};
};

struct Comparison {
    Tolerance tolerance;
    std::string film{};       // mark of the frames
    bool same_bytes = false;  // equal pictures are expected to be equal files: a quick look before decoding
};

// Thread-safe. Throws renderer::RendererError for an image that cannot be encoded.
// `file` is the actual PNG file where there is one, whose opacity counts.
Compared compare(const Comparison& how, const std::filesystem::path& expected, const renderer::Image& actual,
                 const Bytes& file = {});

// The bytes of a file; none if there is no such file. Throws OutputError if it cannot be read.
std::optional<Bytes> read_bytes(const std::filesystem::path& file);

// The verdict on a picture without a partner.
PictureVerdict without(const std::string& name, const std::string& text);

}  // namespace pushfactor::demos::checks
