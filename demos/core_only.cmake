# For PUSHFACTOR_CORE_ONLY: Eigen, GLM, fmt and JSON are headers that serve every processor. Those of this system are found,
# without the rest of its folder, which another system's compiler must not see.
set(headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})

# Declares the target of a package whose headers are in FOLDER, HEADER among them, and lets find_package find it.
function(use_headers package target folder header)
    find_path(${package}_HEADERS ${folder}/${header} PATHS /usr/include /usr/local/include PATH_SUFFIXES eigen3
        NO_CMAKE_FIND_ROOT_PATH REQUIRED)
    file(CREATE_LINK ${${package}_HEADERS}/${folder} ${headers}/${folder} SYMBOLIC)
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    target_include_directories(${target} SYSTEM INTERFACE ${headers})
    string(TOLOWER ${package} name)
    file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/${name}-config.cmake "")
    file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/${name}-config-version.cmake "set(PACKAGE_VERSION_COMPATIBLE TRUE)")
endfunction()

use_headers(Eigen3 Eigen3::Eigen Eigen Core)
use_headers(glm glm::glm glm glm.hpp)
use_headers(fmt fmt::fmt fmt format.h)
use_headers(nlohmann_json nlohmann_json::nlohmann_json nlohmann json.hpp)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
if(EMSCRIPTEN)
    # Written once: all files depend on it.
    if(NOT EXISTS ${headers}/mmintrin.h)
        file(WRITE ${headers}/mmintrin.h "// Eigen includes it beside SSE2; WebAssembly has no such registers.\n")
    endif()
endif()
