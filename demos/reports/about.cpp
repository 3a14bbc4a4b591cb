#include "demos/reports/about.h"

#include "demos/platform/version.h"
#include "demos/text/json.h"

#include <fmt/format.h>

#include <fstream>
#include <thread>

namespace pushfactor::demos::reports {

namespace {

std::string cpu_model() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "";
}

}  // namespace

About about_this() {
#ifdef __clang__
    const std::string compiler = "clang " __clang_version__;
#else
    const std::string compiler = "g++ " __VERSION__;
#endif
    return {.version = version_text(),
            .compiler = compiler,
            .flags = compile_flags(),
            .cpu = cpu_model(),
            .cores = std::thread::hardware_concurrency()};
}

std::string about_json(const About& about) {
    const Json json{{"program", "pushfactor " + about.version},
                    {"compiler", about.compiler},
                    {"flags", about.flags},
                    {"cpu", about.cpu.empty() ? Json(nullptr) : Json(about.cpu)},
                    {"cores", about.cores}};
    return json_text(json);
}

std::string line_of(const About& about) {
    return fmt::format("pushfactor {}, {}, {}; {}{} cores", about.version, about.compiler, about.flags,
                       about.cpu.empty() ? "" : about.cpu + ", ", about.cores);
}

}  // namespace pushfactor::demos::reports
