// Reads the files of measured numbers and tosses.
#include "demos/base/platform/output_file.h"
#include "demos/base/text/errors.h"
#include "demos/reports/reality/tosses.h"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <charconv>
#include <memory>

namespace pushfactor::demos::reports::reality {

namespace {

using engine::Quaternion;
using engine::Vector3;

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
        throw RunError("{}: is damaged", file.string());
    }
    return text;
}

// z is up in the files.
const Quaternion y_up(std::sqrt(0.5), -std::sqrt(0.5), 0.0, 0.0);

Vector3 vector_at(const std::vector<double>& line, std::size_t at) {
    return y_up * Vector3(line[at], line[at + 1], line[at + 2]);
}

Pose pose_at(const std::vector<double>& line, std::size_t at) {
    const Quaternion turned(line[at + 3], line[at + 4], line[at + 5], line[at + 6]);
    return {vector_at(line, at), (y_up * turned).normalized()};
}

}  // namespace

std::vector<std::vector<double>> numbers_of(const std::filesystem::path& file, const std::string& columns) {
    const auto bytes = read_bytes_of(file);
    if (!bytes) throw RunError("{}: cannot be read", file.string());
    std::string text = *bytes;
    if (file.extension() == ".gz") text = decompressed(file, text);
    if (!text.starts_with(columns + "\n")) throw RunError("{}: must begin with {}", file.string(), columns);
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
                throw RunError("{}: line {}: must be {} numbers", file.string(), lines.size() + 1, cells);
            }
            at = next + 1;
        }
    }
    return lines;
}

std::vector<Toss> read_tosses(const std::filesystem::path& folder) {
    std::vector<Toss> tosses;
    for (const auto& line : numbers_of(folder / "cube-tosses.csv.gz", "toss,frame,x_m,y_m,z_m,qw,qx,qy,qz")) {
        tosses.resize(static_cast<std::size_t>(line[0]) + 1);
        tosses.back().frames.push_back(pose_at(line, 2));
    }
    for (const auto& line : numbers_of(folder / "cube-toss-starts.csv",
                                       "toss,frames,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_per_s,vy_m_per_s,vz_m_per_s,"
                                       "wx_rad_per_s,wy_rad_per_s,wz_rad_per_s")) {
        Toss& toss = tosses.at(static_cast<std::size_t>(line[0]));
        toss.start = {toss.frames.front(), vector_at(line, 9), vector_at(line, 12)};
    }
    return tosses;
}

}  // namespace pushfactor::demos::reports::reality
