#include "renderer/base/renderer_error.h"
#include "renderer/gl/egl_context.h"
#include "renderer/gl/gl.h"
#include "renderer/gl/offscreen_context.h"
#include "renderer/gl/osmesa_context.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"
#include "tests/skip.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

using namespace pushfactor::renderer;

namespace {

using Open = std::unique_ptr<OffscreenContext>(const std::vector<std::string>& libraries);

// Checks that a context without its library is refused with one line that names these packages.
void check_missing(Open open, const std::vector<const char*>& packages) {
    try {
        open({"libNoSuchMesa.so.1", "libNoSuchMesa.so"});
        FAIL("a library that does not exist was loaded");
    } catch (const RendererError& error) {
        const std::string message = error.what();
        for (const char* package : packages) CHECK_THAT(message, Catch::Contains(package));
        CHECK(message.find('\n') == std::string::npos);
    }
}

// Tests of a back end are skipped only where it is not installed: Mesa 25.1 and later have no OSMesa.
bool is_installed(ContextKind kind) {
    try {
        open_offscreen_context(kind);
    } catch (const RendererError& error) {
        if (std::string(error.what()).find("cannot load") == std::string::npos) throw;
        WARN("not tested: " << error.what());
        return false;
    }
    return true;
}

}  // namespace

TEST_CASE("Without the libraries the error names the packages to install") {
    check_missing(open_osmesa_context, {"libosmesa6"});
    check_missing(open_egl_context, {"libegl1", "libegl-mesa0", "libgl1-mesa-dri"});
}

TEST_CASE("A library that is neither OSMesa nor EGL is refused") {
    CHECK_THROWS_AS(open_osmesa_context({"libm.so.6"}), RendererError);
    CHECK_THROWS_AS(open_egl_context({"libm.so.6"}), RendererError);
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

TEST_CASE("The kind that is wanted is opened, and the first one otherwise") {
    const bool osmesa = is_installed(ContextKind::osmesa);
    if (osmesa) CHECK(open_offscreen_context(ContextKind::osmesa)->description() == "OSMesa");
    CHECK(open_offscreen_context()->description() == (osmesa ? "OSMesa" : "EGL"));
    if (is_installed(ContextKind::egl)) CHECK(open_offscreen_context(ContextKind::egl)->description() == "EGL");
}

TEST_CASE("OSMesa and EGL give the same frames, to the byte") {
    if (!is_installed(ContextKind::osmesa) || !is_installed(ContextKind::egl)) {
        return pushfactor::tests::skip("needs OSMesa and EGL");
    }
    std::vector<Image> frames;
    for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl}) {
        const auto context = open_offscreen_context(kind);
        Renderer renderer(*context, 320, 180, shader_directory);
        renderer.render(stack_of_cubes(4));
        frames.push_back(renderer.render(all_kinds()));
    }
    CHECK(frames[0] == frames[1]);
}
