# Writes BATCH, a source that includes the test files FILES one after the other, each in a namespace of its own: they
# use whole namespaces and share the names of their helpers. All headers come before, where they belong.
#   cmake -DBATCH=FILE -DFILES=A,B -P write_batch.cmake
string(REPLACE "," ";" FILES "${FILES}")
set(headers "")
set(text "")
foreach(file IN LISTS FILES)
    file(STRINGS ${file} includes REGEX "^#include ")
    list(APPEND headers ${includes})
    string(MAKE_C_IDENTIFIER "${file}" unit)
    string(APPEND text "namespace ${unit}_unit {\n#include \"${file}\"\n}\n")
endforeach()
list(REMOVE_DUPLICATES headers)
list(JOIN headers "\n" headers)
file(WRITE ${BATCH} "${headers}\n${text}")
