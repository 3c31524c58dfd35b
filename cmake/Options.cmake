# Compiler settings shared by every target: link to ashimpact_options.
# Whether a warning is an error is the builder's choice (CMAKE_COMPILE_WARNING_AS_ERROR); every preset does.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}")

find_program(ASHIMPACT_CCACHE ccache)
mark_as_advanced(ASHIMPACT_CCACHE)
if(ASHIMPACT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${ASHIMPACT_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER "${ASHIMPACT_CCACHE}")
endif()

add_library(ashimpact_options INTERFACE)
target_include_directories(ashimpact_options INTERFACE "${PROJECT_SOURCE_DIR}")
# Failed assertions name files as they lie in the project, so that builds in two folders are the same bytes.
target_compile_options(ashimpact_options INTERFACE "-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=")
target_compile_options(ashimpact_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(ASHIMPACT_WEB)
  # Warnings are looked for in the builds for this machine, with a newer compiler and a whole standard library.
  target_compile_options(ashimpact_options INTERFACE -w "SHELL:-include ${PROJECT_SOURCE_DIR}/cmake/web/standard_library.hpp")
endif()
if(ASHIMPACT_SANITIZE)
  # Five checks of undefined behaviour take half of the time to compile: what the first four would find, an access outside
  # of an object or through a null pointer, the address sanitizer finds where it happens; there are few virtual functions.
  target_compile_options(ashimpact_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
    -fno-sanitize=null,alignment,object-size,pointer-overflow,vptr)
  # With instrumentation GCC warns of uninitialised reads in the standard library that do not happen.
  target_compile_options(ashimpact_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(ashimpact_options INTERFACE -fsanitize=address,undefined)
endif()

if(ASHIMPACT_FUZZ)
  target_compile_options(ashimpact_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined
                                                     -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(ashimpact_options INTERFACE -fsanitize=address,undefined)
endif()
if(ASHIMPACT_THREAD_SANITIZER)
  target_compile_options(ashimpact_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(ashimpact_options INTERFACE -fsanitize=thread)
endif()
if(ASHIMPACT_COVERAGE)
  target_compile_options(ashimpact_options INTERFACE --coverage -fprofile-update=atomic)
  target_link_options(ashimpact_options INTERFACE --coverage)
endif()

# For what a run passes through once, reading and writing documents and the command line: it compiles in two thirds of the
# time, and no run is slower for it. With sanitizers, which make such code grow, in less than half.
add_library(ashimpact_cold_code INTERFACE)
target_compile_options(ashimpact_cold_code INTERFACE
  $<$<CONFIG:RelWithDebInfo>:$<IF:$<BOOL:${ASHIMPACT_SANITIZE}>,-O0,-O1>>)

# For what becomes part of libashimpact or of the Python module, as add_compile_options() of its folder: it can be loaded
# anywhere, and a function is visible from outside only where it is marked.
set(ASHIMPACT_LIBRARY_OPTIONS -fPIC -fvisibility=hidden -fvisibility-inlines-hidden)
