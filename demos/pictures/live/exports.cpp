// What the worker of the page calls (assets/live/worker.js). Texts go in and out as UTF-8; every answer is JSON
// that lives until the next call, with "refused" or "failed" instead of a result if something is wrong.
#include "demos/base/text/errors.h"
#include "demos/pictures/live/live_run.h"
#include "demos/pictures/live/microscope.h"
#include "demos/pictures/replay/stage.h"
#include "engine/base/invalid_input.h"

#include <emscripten/emscripten.h>

#include <fstream>
#include <map>
#include <memory>

namespace {

using namespace pushfactor::demos;
using namespace pushfactor::demos::pictures;

std::map<int, std::unique_ptr<live::LiveRun>> runs;
std::string answer, bytes;
std::vector<double> numbers;

// The answer of `work`; what is wrong with the input is refused, what goes wrong in the run has failed.
template <typename Work>
const char* answer_of(const Work& work) {
    Json json;
    try {
        json = work();
    } catch (const UsageError& error) {
        json = {{"refused", error.what()}};
    } catch (const pushfactor::engine::InvalidInput& error) {
        json = {{"refused", error.what()}};
    } catch (const std::exception& error) {
        json = {{"failed", error.what()}};
    }
    answer = json_text(json, -1);
    return answer.c_str();
}

// Bytes for the page: where they are, and how many.
Json place_of(const std::string& text) {
    return {{"at", reinterpret_cast<std::uintptr_t>(text.data())}, {"size", text.size()}};
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* live_menu() {
    return answer_of([] { return live::menu(); });
}

// Box and square, as replay::common_meshes.
EMSCRIPTEN_KEEPALIVE const char* live_meshes() {
    return answer_of([] {
        bytes = replay::common_meshes();
        return place_of(bytes);
    });
}

// Writes a scene file of the visitor's, so that it can be opened by this name.
EMSCRIPTEN_KEEPALIVE const char* live_keep(const char* name, const char* text) {
    return answer_of([&] {
        std::ofstream(name) << text;
        return Json::object();
    });
}

// Opens a run in a slot: `request` has "scene" and "options", pairs of texts. The answer is LiveRun::about() with
// the place of its meshes; the slot keeps its run if that is refused.
EMSCRIPTEN_KEEPALIVE const char* live_open(int slot, const char* request) {
    return answer_of([&] {
        const Json wish = parse_json(request);
        auto run =
            std::make_unique<live::LiveRun>(wish["scene"].get<std::string>(), wish["options"].get<OptionTexts>());
        Json about = run->about();
        bytes = run->meshes();
        about["meshes"] = place_of(bytes);
        runs[slot] = std::move(run);
        return about;
    });
}

EMSCRIPTEN_KEEPALIVE void live_close(int slot) {
    runs.erase(slot);
}

// Takes steps. LiveRun::numbers() are at "at" as so many doubles.
EMSCRIPTEN_KEEPALIVE const char* live_advance(int slot, int steps) {
    return answer_of([&] {
        live::LiveRun& run = *runs.at(slot);
        run.advance(steps);
        numbers = run.numbers();
        return Json{{"hash", run.state_hash()},
                    {"command", run.command()},
                    {"at", reinterpret_cast<std::uintptr_t>(numbers.data())},
                    {"size", numbers.size()}};
    });
}

EMSCRIPTEN_KEEPALIVE const char* live_microscope(int slot) {
    return answer_of([&] { return live::microscope(runs.at(slot)->simulation()); });
}
}
