# Headers that cost a second or more of every source that includes them, parsed once a configuration:
#
#   ashimpact_precompile(<target> [DOCTEST] [COLD])
#
# lets a target take nlohmann/json (and doctest) from there. COLD is for code that runs once per process: -O1, which
# compiles a third faster (ashimpact_cold_code). Sources still include what they use: `./dev check` builds without
# precompiled headers and compiles every header by itself.
function(ashimpact_precompile target)
  cmake_parse_arguments(ARG "DOCTEST;COLD" "" "" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "ashimpact_precompile(${target}): unknown '${ARG_UNPARSED_ARGUMENTS}', known: DOCTEST, COLD")
  endif()
  set(pch ashimpact_pch)
  set(headers <nlohmann/json.hpp>)
  set(libraries ashimpact_options nlohmann_json::nlohmann_json)
  if(ARG_DOCTEST)
    string(APPEND pch _test)
    list(PREPEND headers <doctest/doctest.h>)
    list(APPEND libraries doctest::doctest)
  endif()
  if(ARG_COLD)  # a precompiled header fixes how far the compiler optimises
    string(APPEND pch _cold)
    list(APPEND libraries ashimpact_cold_code)
    target_link_libraries(${target} PRIVATE ashimpact_cold_code)
  endif()

  if(NOT TARGET ${pch})
    set(empty "${PROJECT_BINARY_DIR}/${pch}.cpp")
    file(CONFIGURE OUTPUT "${empty}" CONTENT "// carries the precompiled headers\n")
    add_library(${pch} OBJECT "${empty}")
    target_link_libraries(${pch} PRIVATE ${libraries})
    target_precompile_headers(${pch} PRIVATE ${headers})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${pch})
endfunction()
