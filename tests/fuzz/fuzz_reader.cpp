// libFuzzer target: any bytes as a scene file are refused in one line, or are a scene that survives writing and
// reading, and that can be stepped.
#include "demos/base/text/errors.h"
#include "demos/options/choices.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/scene_file.h"
#include "engine/base/invalid_input.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

using namespace pushfactor;

namespace {

// A file in memory.
class MemoryFile {
  public:
    explicit MemoryFile(const char* name) : descriptor_(memfd_create(name, 0)) {
        if (descriptor_ < 0) std::abort();
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

    void hold(const void* bytes, std::size_t size) {
        const bool written =
            ftruncate(descriptor_, 0) == 0 && pwrite(descriptor_, bytes, size, 0) == static_cast<ssize_t>(size);
        if (!written) std::abort();
    }

  private:
    int descriptor_;
};

void require(bool holds) {
    if (!holds) std::abort();
}

void read_back(const demos::SceneDescription& scene) {
    static MemoryFile file("again");
    const std::string text = demos::scene_file_text(scene);
    file.hold(text.data(), text.size());
    require(demos::scene_file_text(demos::read_scene_file(file.path())) == text);
}

// Two steps of a few sweeps, only of scenes that do not take long.
void step(demos::Choices& choices) {
    if (choices.description.bodies.size() > 20) return;
    choices.settings.iterations = std::min(choices.settings.iterations, 10);
    choices.settings.substeps = std::min(choices.settings.substeps, 2);
    demos::Simulation simulation(choices);
    simulation.advance();
    simulation.advance();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static MemoryFile file("scene");
    file.hold(bytes, size);
    try {
        demos::Choices choices = demos::understand(file.path(), {});
        read_back(choices.description);
        step(choices);
    } catch (const demos::UsageError& error) {
        require(std::string_view(error.what()).find('\n') == std::string_view::npos);
    } catch (const engine::InvalidInput&) {
    } catch (const demos::NonFiniteError&) {
    }
    return 0;
}
