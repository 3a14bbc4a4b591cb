#include "demos/platform/assets.h"

namespace pushfactor::demos {

namespace fs = std::filesystem;

fs::path asset_folder(const std::string& name) {
    std::error_code no_such_link;  // without /proc only the source folder is used
    const fs::path program = fs::read_symlink("/proc/self/exe", no_such_link);
    const fs::path installed = (program.parent_path() / PUSHFACTOR_INSTALLED_ASSETS).lexically_normal();
    const fs::path assets = fs::is_directory(installed) ? installed : fs::path(PUSHFACTOR_ASSET_DIR);
    return assets / name;
}

}  // namespace pushfactor::demos
