// Reads what demos/pictures/replay writes, by the description in its headers.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pushfactor::tests {

class IntegerReader {
  public:
    explicit IntegerReader(std::string bytes) : bytes_(std::move(bytes)) {}

    unsigned char byte() { return static_cast<unsigned char>(bytes_.at(at_++)); }
    std::int64_t next();
    std::string rest() const { return bytes_.substr(at_); }
    bool is_at_end() const { return at_ == bytes_.size(); }

  private:
    std::string bytes_;
    std::size_t at_ = 0;
};

// The values of `count` quantities in `frames` frames.
std::vector<std::vector<std::int64_t>> read_quantities(const std::string& bytes, std::size_t count,
                                                       std::size_t frames);

struct ReadItem {
    std::int64_t kind = 0, body = 0, other = 0;
    std::array<std::int64_t, 3> place{};             // position units of the body
    std::array<std::array<double, 3>, 3> vectors{};  // force [N], push and lasting push [m/s]
};

// The lists of `frames` frames.
std::vector<std::vector<ReadItem>> read_forces(const std::string& bytes, std::size_t frames);

}  // namespace pushfactor::tests
