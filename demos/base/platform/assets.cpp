#include "demos/base/platform/assets.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/text/errors.h"

namespace pushfactor::demos {

namespace fs = std::filesystem;

namespace {

fs::path installed_assets() {
    std::error_code no_such_link;  // without /proc only the source folder is used
    const fs::path program = fs::read_symlink("/proc/self/exe", no_such_link);
    return (program.parent_path() / PUSHFACTOR_INSTALLED_ASSETS).lexically_normal();
}

}  // namespace

fs::path asset_folder(const std::string& name) {
    const fs::path installed = installed_assets();
    return (fs::is_directory(installed) ? installed : fs::path(PUSHFACTOR_ASSET_DIR)) / name;
}

std::string asset_text(const fs::path& file) {
    if (auto text = read_bytes_of(file)) return std::move(*text);
    throw OutputError("cannot read " + file.string());
}

fs::path live_page() {
    const fs::path installed = installed_assets();
    return fs::is_directory(installed) ? installed / "live.html" : fs::path(PUSHFACTOR_LIVE_PAGE);
}

}  // namespace pushfactor::demos
