# What cmake/Dependencies.cmake finds, for WebAssembly: the same targets, header-only ones from this machine, the others
# compiled from Debian's source packages, which cmake/web/libraries.sh fetches. MPI, HDF5 and oneTBB are left out.
set(ASHIMPACT_WEB_LIBRARIES "${PROJECT_SOURCE_DIR}/build/web-libraries" CACHE PATH "Where libraries.sh put them")
find_program(ASHIMPACT_BASH bash REQUIRED)
execute_process(COMMAND "${ASHIMPACT_BASH}" "${CMAKE_CURRENT_LIST_DIR}/libraries.sh" "${ASHIMPACT_WEB_LIBRARIES}"
                RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the libraries for WebAssembly are incomplete, see above")
endif()
enable_language(C)
set(sources "${ASHIMPACT_WEB_LIBRARIES}/source")
set(config "${CMAKE_CURRENT_LIST_DIR}/config")  # what their own configure scripts would write

# Header-only libraries.
add_library(web_headers INTERFACE)
target_include_directories(web_headers SYSTEM INTERFACE "${ASHIMPACT_WEB_LIBRARIES}/include")
foreach(name CLI11::CLI11 nlohmann_json::nlohmann_json ashimpact::valijson Boost::headers FastFloat::fast_float)
  add_library(${name} INTERFACE IMPORTED GLOBAL)
  target_link_libraries(${name} INTERFACE web_headers)
endforeach()
add_library(Eigen3::Eigen INTERFACE IMPORTED GLOBAL)
target_include_directories(Eigen3::Eigen SYSTEM INTERFACE "${ASHIMPACT_WEB_LIBRARIES}/include/eigen3")
add_library(fmt::fmt INTERFACE IMPORTED GLOBAL)
target_link_libraries(fmt::fmt INTERFACE web_headers)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
add_library(spdlog::spdlog INTERFACE IMPORTED GLOBAL)
target_link_libraries(spdlog::spdlog INTERFACE fmt::fmt)
target_compile_definitions(spdlog::spdlog INTERFACE SPDLOG_FMT_EXTERNAL SPDLOG_NO_THREAD_ID SPDLOG_NO_TLS)

# web_library(<target> FOLDER <folder> SOURCES <file>... [HEADERS <file or folder>...] [DEFINE <definition>...])
# Somebody else's sources, warnings off. The headers that we include are linked beside the header-only libraries.
function(web_library target)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "FOLDER" "SOURCES;HEADERS;DEFINE")
  foreach(header IN LISTS ARG_HEADERS)
    cmake_path(GET header FILENAME name)
    file(CREATE_LINK "${ARG_FOLDER}/${header}" "${ASHIMPACT_WEB_LIBRARIES}/include/${name}" SYMBOLIC)
  endforeach()
  list(TRANSFORM ARG_SOURCES PREPEND "${ARG_FOLDER}/")
  add_library(${target} STATIC ${ARG_SOURCES})
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF CXX_CLANG_TIDY "")
  target_include_directories(${target} PRIVATE "${ARG_FOLDER}" "${config}")
  target_link_libraries(${target} PUBLIC web_headers)
  target_compile_definitions(${target} PRIVATE ${ARG_DEFINE})
  target_compile_options(${target} PRIVATE -w)
endfunction()

web_library(web_zlib FOLDER "${sources}/zlib"
  SOURCES adler32.c crc32.c inffast.c inflate.c inftrees.c zutil.c
  HEADERS zlib.h zconf.h)
web_library(web_minizip FOLDER "${sources}/minizip" SOURCES ioapi.c unzip.c HEADERS ../minizip DEFINE NOUNCRYPT)
target_link_libraries(web_minizip PUBLIC web_zlib)
add_library(PkgConfig::MINIZIP ALIAS web_minizip)

web_library(web_pugixml FOLDER "${sources}/pugixml/src" SOURCES pugixml.cpp HEADERS pugixml.hpp pugiconfig.hpp)
add_library(pugixml::pugixml ALIAS web_pugixml)

web_library(web_nettle FOLDER "${sources}/nettle" SOURCES base64-encode.c sha256.c sha256-compress.c write-be32.c HEADERS ../nettle
  DEFINE HAVE_CONFIG_H)
add_library(nettle::nettle ALIAS web_nettle)

web_library(web_highway FOLDER "${sources}/highway" SOURCES hwy/aligned_allocator.cc hwy/per_target.cc hwy/targets.cc
  HEADERS hwy)
add_library(hwy::hwy ALIAS web_highway)

# GSL: the folders the solver needs, each with the list of sources in its Makefile.am.
set(gsl_sources)
foreach(part blas block bspline cblas cdf complex eigen err integration interpolation linalg matrix min multifit
             multifit_nlinear multimin permutation poly randist rng roots sort specfunc statistics sys utils vector)
  file(STRINGS "${sources}/gsl/${part}/Makefile.am" lines REGEX "^lib[a-z_]*_la_SOURCES *=")
  string(REGEX REPLACE "^[^=]*=" "" lines "${lines}")
  string(REGEX MATCHALL "[A-Za-z0-9_]+\\.c" files "${lines}")
  list(TRANSFORM files PREPEND "${part}/")
  list(APPEND gsl_sources ${files})
endforeach()
web_library(web_gsl FOLDER "${sources}/gsl" SOURCES ${gsl_sources} HEADERS gsl DEFINE HAVE_CONFIG_H)
add_library(GSL::gsl ALIAS web_gsl)
add_library(GSL::gslcblas INTERFACE IMPORTED GLOBAL)
