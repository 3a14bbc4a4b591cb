#include "demos/pictures/camera/layout.h"

#include "tests/catch.h"

using namespace pushfactor::demos::pictures;

TEST_CASE("a tall thing is shown side by side, a wide one above each other") {
    CHECK(best_layout({1280, 720}, 3, 0.1, 0.35).columns == 3);
    CHECK(best_layout({1280, 720}, 3, 3.0, 0.35).columns == 1);
    CHECK(best_layout({1000, 1000}, 4, 0.35, 0.35).columns == 2);
}

TEST_CASE("cells do not overlap, stay on the sheet, and a single one is all of it") {
    for (const int count : {1, 2, 3, 5, 7, 16}) {
        const Layout layout = best_layout({1000, 600}, count, 0.4, 0.3);
        REQUIRE(layout.columns * layout.rows >= count);
        for (int i = 0; i < count; ++i) {
            const auto a = layout.place(static_cast<std::size_t>(i));
            CHECK(a.x + a.width <= 1000.0f);
            CHECK(a.y + a.height <= 600.0f);
            for (int j = 0; j < i; ++j) {
                const auto b = layout.place(static_cast<std::size_t>(j));
                CHECK((a.x >= b.x + b.width || b.x >= a.x + a.width || a.y >= b.y + b.height ||
                       b.y >= a.y + a.height));
            }
        }
    }
    const Layout one = best_layout({1000, 600}, 1, 0.4, 0.3);
    CHECK(one.cell.width == 1000);
    CHECK(one.cell.height == 600);
}

TEST_CASE("pictures come to their cells in order, with white between them") {
    const Layout layout = grid({22, 10}, 2, 1);
    const auto red = pushfactor::renderer::blank_image(layout.cell.width, layout.cell.height, {1, 0, 0});
    const auto blue = pushfactor::renderer::blank_image(layout.cell.width, layout.cell.height, {0, 0, 1});
    const auto sheet = assemble(layout, {red, blue});
    CHECK(sheet.pixel(0, 5) == red.pixel(0, 0));
    CHECK(sheet.pixel(10, 5) == std::array<std::uint8_t, 3>{255, 255, 255});
    CHECK(sheet.pixel(21, 9) == blue.pixel(0, 0));
}
