#include "demos/platform/output_file.h"
#include "demos/reports/reality/tosses.h"
#include "demos/text/errors.h"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <string_view>

namespace pushfactor::demos::reports::reality {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
    throw RunError(fmt::format("{}: {}", file.string(), what));
}

std::string decompressed(const std::filesystem::path& file, const std::string& bytes) {
    // The size before compression is in the last four bytes, the lowest first (RFC 1952).
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4 && bytes.size() > 4; ++i) {
        size |= std::size_t{static_cast<unsigned char>(bytes[bytes.size() - 4 + i])} << (8 * i);
    }
    constexpr std::size_t most = 100'000'000;
    std::string text(std::min(size, most), '\0');
    const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> gzip(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    if (libdeflate_gzip_decompress(gzip.get(), bytes.data(), bytes.size(), text.data(), text.size(), nullptr) !=
        LIBDEFLATE_SUCCESS) {
        refuse(file, "is damaged");
    }
    return text;
}

}  // namespace

std::vector<std::vector<double>> numbers_of(const std::filesystem::path& file, const std::string& columns) {
    const auto bytes = read_bytes_of(file);
    if (!bytes) refuse(file, "cannot be read");
    std::string text = *bytes;
    if (file.extension() == ".gz") text = decompressed(file, text);
    if (!text.starts_with(columns + "\n")) refuse(file, "must begin with " + columns);
    std::vector<std::vector<double>> lines;
    const auto cells = static_cast<std::size_t>(std::ranges::count(columns, ',')) + 1;
    const char* at = text.data() + columns.size() + 1;
    const char* const end = text.data() + text.size();
    while (at < end) {
        std::vector<double>& line = lines.emplace_back(cells);
        for (double& number : line) {
            const auto [next, error] = std::from_chars(at, end, number);
            const char after = &number == &line.back() ? '\n' : ',';
            if (error != std::errc() || next == end || *next != after) {
                refuse(file, fmt::format("line {}: must be {} numbers", lines.size() + 1, cells));
            }
            at = next + 1;
        }
    }
    return lines;
}

}  // namespace pushfactor::demos::reports::reality
