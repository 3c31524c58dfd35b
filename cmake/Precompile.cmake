# Headers that cost a second or more of every source that includes them, parsed once a configuration:
#
#   ashimpact_precompile(<target> [doctest])
#
# lets a target take nlohmann/json (and doctest) from there. Sources still include what they use: the preset
# `check` builds without precompiled headers and fails where an include is missing. A precompiled header fixes how far
# the compiler optimises: those of the program are for what ashimpact_cold_code compiles.
function(ashimpact_precompile target)
  if(ARGN STREQUAL "doctest")
    set(pch ashimpact_pch_test)
    set(headers <doctest/doctest.h> <nlohmann/json.hpp>)
    set(libraries doctest::doctest nlohmann_json::nlohmann_json)
  elseif(NOT ARGN)
    set(pch ashimpact_pch)
    set(headers <nlohmann/json.hpp>)
    set(libraries nlohmann_json::nlohmann_json)
  else()
    message(FATAL_ERROR "ashimpact_precompile(${target}): unknown header set '${ARGN}', known: doctest")
  endif()

  if(NOT TARGET ${pch})
    set(empty "${PROJECT_BINARY_DIR}/${pch}.cpp")
    file(CONFIGURE OUTPUT "${empty}" CONTENT "// carries the precompiled headers\n")
    add_library(${pch} OBJECT "${empty}")
    target_link_libraries(${pch} PRIVATE ashimpact_options ${libraries})
    if(NOT ARGN)
      target_link_libraries(${pch} PRIVATE ashimpact_cold_code)
    endif()
    target_precompile_headers(${pch} PRIVATE ${headers})
  endif()
  if(NOT ARGN)
    target_link_libraries(${target} PRIVATE ashimpact_cold_code)
  endif()
  target_precompile_headers(${target} REUSE_FROM ${pch})
endfunction()
