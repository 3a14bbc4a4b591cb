#include "demos/platform/version.h"
#include "demos/reports/study.h"
#include "demos/text/json.h"

#include <fmt/format.h>

#include <fstream>
#include <thread>

namespace pushfactor::demos::reports {

namespace {

#ifdef __clang__
constexpr const char* compiler = "clang " __clang_version__;
#else
constexpr const char* compiler = "g++ " __VERSION__;
#endif

// Model name; empty if unknown.
std::string cpu_model() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "";
}

}  // namespace

std::string about_json() {
    const std::string cpu = cpu_model();
    return json_text(Json{{"program", "pushfactor " + version_text()},
                          {"compiler", compiler},
                          {"flags", compile_flags()},
                          {"cpu", cpu.empty() ? Json(nullptr) : Json(cpu)},
                          {"cores", std::thread::hardware_concurrency()}});
}

std::string about_line() {
    const std::string cpu = cpu_model();
    return fmt::format("pushfactor {}, {}, {}; {}{} cores", version_text(), compiler, compile_flags(),
                       cpu.empty() ? "" : cpu + ", ", std::thread::hardware_concurrency());
}

}  // namespace pushfactor::demos::reports
