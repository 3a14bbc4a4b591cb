# The page with the program inside: one HTML file, build/browser/live.html. Node comes with Emscripten.
add_executable(live pictures/live/exports.cpp)
target_link_libraries(live PRIVATE pushfactor_flags demos_pictures)
target_precompile_headers(live REUSE_FROM demos_base)
target_link_options(live PRIVATE -sMODULARIZE=1 -sEXPORT_NAME=Program -sENVIRONMENT=worker,node -sALLOW_MEMORY_GROWTH=1
    -sEXPORTED_RUNTIME_METHODS=ccall,UTF8ToString)

find_program(NODE NAMES node nodejs REQUIRED NO_CMAKE_FIND_ROOT_PATH)
set(page ${PROJECT_BINARY_DIR}/live.html)
file(GLOB parts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/assets/live/* ${PROJECT_SOURCE_DIR}/assets/replay/*
    ${PROJECT_SOURCE_DIR}/assets/shaders/* ${PROJECT_SOURCE_DIR}/assets/pages/page.css)
add_custom_command(OUTPUT ${page}
    COMMAND ${NODE} ${CMAKE_CURRENT_SOURCE_DIR}/pictures/live/write_page.js $<TARGET_FILE:live> ${PROJECT_SOURCE_DIR}/assets ${page}
    DEPENDS live ${parts} ${CMAKE_CURRENT_SOURCE_DIR}/pictures/live/write_page.js
    COMMENT "Writing live.html" VERBATIM)
add_custom_target(live_page ALL DEPENDS ${page})
