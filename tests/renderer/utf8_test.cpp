#include "renderer/base/utf8.h"

#include "tests/catch.h"

#include <string>
#include <string_view>

using namespace pushfactor::renderer;

namespace {

std::u32string decoded(std::string_view utf8) {
    std::u32string characters;
    while (!utf8.empty()) characters += take_character(utf8);
    return characters;
}

}  // namespace

TEST_CASE("UTF-8 of every length is decoded", "[font]") {
    CHECK(decoded("") == U"");
    CHECK(decoded("A\x7F") == U"A\x7F");
    CHECK(decoded("\xC2\x80\xDF\xBF") == U"\x80\x7FF");
    CHECK(decoded("\xE0\xA0\x80\xED\x9F\xBF\xEE\x80\x80\xEF\xBF\xBF") == U"\x800\xD7FF\xE000\xFFFF");
    CHECK(decoded("\xF0\x90\x80\x80\xF4\x8F\xBF\xBF") == U"\x10000\x10FFFF");
    CHECK(decoded(std::string_view("\0a", 2)) == std::u32string({0, U'a'}));
}

TEST_CASE("Bytes that are not UTF-8 become one U+FFFD for each beginning of a character", "[font]") {
    CHECK(decoded("\x80\xBF") == U"\xFFFD\xFFFD");
    CHECK(decoded("\xFF\xFE") == U"\xFFFD\xFFFD");
    CHECK(decoded("\xCE") == U"\xFFFD");
    CHECK(decoded("\xE2\x82") == U"\xFFFD");                  // cut off at the end
    CHECK(decoded("\xE2\x82z") == U"\xFFFDz");                // and before a letter, which is kept
    CHECK(decoded("\xC0\xAF") == U"\xFFFD\xFFFD");            // overlong
    CHECK(decoded("\xE0\x9F\xBF") == U"\xFFFD\xFFFD\xFFFD");  // overlong
    CHECK(decoded("\xED\xA0\x80") == U"\xFFFD\xFFFD\xFFFD");  // a surrogate
    CHECK(decoded("\xF4\x90\x80\x80") == U"\xFFFD\xFFFD\xFFFD\xFFFD");
    CHECK(decoded("\xF0\x9F\x98\xCE\xB2") == U"\xFFFD\x3B2");
}
