# cmake -DINPUT=.. -DOUTPUT=.. -DNAMESPACE=.. -DVARIABLE=.. -P EmbedFile.cmake: one file as a C++ string literal.
# Every byte is written as \xHH, so no byte needs care and none can run into its neighbour.
file(SIZE "${INPUT}" size)
if(size GREATER_EQUAL 1000000)
  message(FATAL_ERROR "${INPUT}: ${size} bytes; an embedded file must be smaller than 1000000")
endif()

file(READ "${INPUT}" bytes HEX)
string(REPEAT "[0-9a-f]" 32 sixteen_bytes)
string(REGEX REPLACE "(${sixteen_bytes})" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
string(REPLACE "\n" "\"\n    \"" bytes "${bytes}")

file(WRITE "${OUTPUT}" "// Generated from ${INPUT}.
#include <string_view>

namespace ${NAMESPACE} {
extern const std::string_view ${VARIABLE};
const std::string_view ${VARIABLE}{
    \"${bytes}\",
    ${size}};
}
")
