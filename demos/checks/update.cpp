#include "demos/checks/update.h"

#include "demos/platform/output_file.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

#include <utility>

namespace pushfactor::demos::checks {

namespace fs = std::filesystem;

Update::Update(fs::path folder) : folder_(std::move(folder)), staging_(folder_ / ".new") {
    make_folder(folder_);
    make_folder(staging_);
}

Update::~Update() {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
}

void Update::stage(const std::string& name, const Bytes& bytes) const {
    stage(name, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void Update::stage(const std::string& name, std::string_view text) const {
    write_file(staged(name), text);
}

void Update::drop(const std::string& name) const {
    std::error_code ignored;
    fs::remove(staged(name), ignored);
}

long Update::apply() {
    long count = 0;
    for (const auto& entry : fs::directory_iterator(staging_)) {
        std::error_code error;
        const fs::path target = folder_ / entry.path().filename();
        if (fs::is_symlink(target, error)) {
            write_file(target, read_bytes_of(entry.path()).value_or(""));
        } else {
            fs::rename(entry.path(), target, error);
            if (error) throw OutputError(fmt::format("{}: {}", target.string(), error.message()));
        }
        ++count;
    }
    return count;
}

}  // namespace pushfactor::demos::checks
