# Run by every build: cmake -D SOURCE=DIR -D HEADER=FILE -P write_commit.cmake
# Writes the commit checked out in SOURCE into HEADER, only if it has changed, so that nothing is recompiled
# otherwise. Sources inside the checkout of another project have no commit.
cmake_minimum_required(VERSION 3.25)

set(commit unknown)
find_program(GIT git)
if(GIT)
    execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --show-prefix
        RESULT_VARIABLE status OUTPUT_VARIABLE below ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(status EQUAL 0 AND below STREQUAL "")
        execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --dirty --exclude=* --abbrev=12
            RESULT_VARIABLE status OUTPUT_VARIABLE described ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
        if(status EQUAL 0)
            set(commit ${described})
        endif()
    endif()
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define PUSHFACTOR_COMMIT \"${commit}\"\n")
