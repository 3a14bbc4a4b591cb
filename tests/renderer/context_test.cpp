#include "renderer/gl.h"
#include "renderer/osmesa_context.h"
#include "renderer/renderer_error.h"
#include "tests/catch.h"

#include <string>

using namespace pushfactor::renderer;

TEST_CASE("Without OSMesa the error names the package to install") {
    try {
        open_osmesa_context({"libNoSuchMesa.so.1", "libNoSuchMesa.so"});
        FAIL("a library that does not exist was loaded");
    } catch (const RendererError& error) {
        const std::string message = error.what();
        CHECK(message.find("libosmesa6") != std::string::npos);
        CHECK(message.find('\n') == std::string::npos);
    }
}

TEST_CASE("A library that is not OSMesa is refused") {
    CHECK_THROWS_AS(open_osmesa_context({"libm.so.6"}), RendererError);
}

TEST_CASE("A context offers GL 3.3 or later") {
    const auto context = open_offscreen_context();
    const Gl gl = load_gl(*context);
    int major = 0;
    int minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    CHECK(10 * major + minor >= 33);
}

TEST_CASE("Contexts may be closed in any order") {
    auto first = open_offscreen_context();
    auto second = open_offscreen_context();
    first->make_current();
    second.reset();
    auto third = open_offscreen_context();
    first.reset();
    third->make_current();
    CHECK(load_gl(*third).GetString(GL_VERSION) != nullptr);
}
