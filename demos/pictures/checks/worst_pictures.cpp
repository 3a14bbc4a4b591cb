#include "demos/pictures/checks/worst_pictures.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/text/text_hash.h"

#include <algorithm>
#include <array>

namespace pushfactor::demos::checks {

namespace {

constexpr std::array exhibits{"expected", "actual", "difference"};

void write_exhibit(const std::filesystem::path& file, const Bytes& bytes) {
    if (bytes.empty()) return;
    make_folder(file.parent_path());
    write_file(file, bytes);
}

bool is_exhibit(const std::filesystem::path& file) {
    return std::ranges::any_of(exhibits, [name = file.filename().string()](const char* exhibit) {
        return name.ends_with(exhibit_file("", exhibit));
    });
}

// A picture's name without what would make a file name too long.
std::string short_file_name(const std::string& name) {
    constexpr std::size_t longest = 200;
    const std::size_t slash = name.rfind('/'), begin = slash == std::string::npos ? 0 : slash + 1;
    if (name.size() - begin <= longest) return name;
    return name.substr(0, begin + longest - 17) + "-" + std::to_string(text_hash(name) % 1000000000000000u);
}

}  // namespace

std::string exhibit_file(const std::string& name, const std::string& exhibit) {
    return short_file_name(name) + "." + exhibit + ".png";
}

WorstPictures::WorstPictures(std::filesystem::path folder) : folder_(std::move(folder)) {
    if (!std::filesystem::is_directory(folder_)) return;
    std::vector<std::filesystem::path> old;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
        if (is_exhibit(entry.path())) old.push_back(entry.path());
    }
    std::error_code ignored;
    for (const auto& file : old) std::filesystem::remove(file, ignored);
}

void WorstPictures::offer(const Compared& compared) {
    if (compared.verdict.holds()) return;
    if (kept_.size() >= most) {
        if (compared.verdict.badness <= kept_.begin()->first) return;
        for (const char* const exhibit : exhibits) {
            std::error_code ignored;
            std::filesystem::remove(folder_ / exhibit_file(kept_.begin()->second, exhibit), ignored);
        }
        kept_.erase(kept_.begin());
    }
    const std::string& name = compared.verdict.name;
    write_exhibit(folder_ / exhibit_file(name, "expected"), compared.expected);
    write_exhibit(folder_ / exhibit_file(name, "actual"), compared.actual);
    write_exhibit(folder_ / exhibit_file(name, "difference"), compared.difference);
    kept_.emplace(compared.verdict.badness, name);
}

void WorstPictures::mark(std::vector<PictureVerdict>& verdicts) const {
    std::set<std::string> names;
    for (const auto& [badness, name] : kept_) names.insert(name);
    for (PictureVerdict& verdict : verdicts) verdict.shown = names.contains(verdict.name);
}

}  // namespace pushfactor::demos::checks
