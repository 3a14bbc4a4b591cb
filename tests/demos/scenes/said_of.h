// What the program says about a scene file.
#pragma once

#include "demos/base/text/errors.h"
#include "demos/options/choices.h"
#include "demos/runs/scene.h"
#include "engine/base/invalid_input.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <algorithm>
#include <string>

namespace pushfactor::tests {

// The message, one line, for a file "my.json" with this text, beside the files that are in `folder`; "accepted"
// without one.
inline std::string said_of(const std::string& text, const Folder& folder = {}) {
    folder.write("my.json", text);
    try {
        demos::build_scene(demos::understand((folder / "my.json").string(), {}));
    } catch (const demos::UsageError& error) {
        const std::string message = error.what();
        CHECK(std::count(message.begin(), message.end(), '\n') == 0);
        return message;
    } catch (const engine::InvalidInput& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace pushfactor::tests
