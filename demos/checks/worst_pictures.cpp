#include "demos/checks/worst_pictures.h"

#include "demos/platform/output_file.h"

namespace pushfactor::demos::checks {

namespace {

void write_bytes(const std::filesystem::path& file, const Bytes& bytes) {
    if (bytes.empty()) return;
    make_folder(file.parent_path());
    write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

bool is_exhibit(const std::filesystem::path& file) {
    const std::string name = file.filename();
    return name.ends_with(expected_file("")) || name.ends_with(actual_file("")) ||
           name.ends_with(difference_file(""));
}

}  // namespace

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
        remove(kept_.begin()->second);
        kept_.erase(kept_.begin());
    }
    write(compared);
    kept_.emplace(compared.verdict.badness, compared.verdict.name);
}

void WorstPictures::mark(std::vector<PictureVerdict>& verdicts) const {
    std::set<std::string> names;
    for (const auto& [badness, name] : kept_) names.insert(name);
    for (PictureVerdict& verdict : verdicts) verdict.shown = names.count(verdict.name) > 0;
}

void WorstPictures::write(const Compared& compared) const {
    const std::string& name = compared.verdict.name;
    write_bytes(folder_ / expected_file(name), compared.expected);
    write_bytes(folder_ / actual_file(name), compared.actual);
    write_bytes(folder_ / difference_file(name), compared.difference);
}

void WorstPictures::remove(const std::string& name) const {
    for (const std::string& file : {expected_file(name), actual_file(name), difference_file(name)}) {
        std::error_code ignored;
        std::filesystem::remove(folder_ / file, ignored);
    }
}

}  // namespace pushfactor::demos::checks
