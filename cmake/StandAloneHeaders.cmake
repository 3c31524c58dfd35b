# ashimpact_stand_alone_headers: an object library, built by name only (`./dev check`), that compiles every header by
# itself, so that a header that lacks an include is found. Headers for SIMD lanes (-inl.hpp) are parts of others.
file(GLOB_RECURSE headers RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS
  core/*.hpp materials/*.hpp solver/*.hpp pipeline/*.hpp interface/*.hpp tests/*.hpp)
list(FILTER headers EXCLUDE REGEX "-inl\\.hpp$|^interface/web/")
set(sources)
foreach(header IN LISTS headers)
  set(source "${PROJECT_BINARY_DIR}/headers/${header}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "#include \"${header}\"\n")
  list(APPEND sources "${source}")
endforeach()
add_library(ashimpact_stand_alone_headers OBJECT EXCLUDE_FROM_ALL ${sources})
set_target_properties(ashimpact_stand_alone_headers PROPERTIES UNITY_BUILD OFF CXX_CLANG_TIDY "")
target_compile_options(ashimpact_stand_alone_headers PRIVATE -O0 -Wno-unused)
target_include_directories(ashimpact_stand_alone_headers PRIVATE
  "${PROJECT_SOURCE_DIR}/interface/include" "${PROJECT_BINARY_DIR}" "${PROJECT_BINARY_DIR}/solver")
target_link_libraries(ashimpact_stand_alone_headers PRIVATE
  ashimpact_sweep ashimpact_cli ashimpact_c doctest::doctest CLI11::CLI11 fmt::fmt spdlog::spdlog GSL::gsl hwy::hwy
  MPI::MPI_CXX PkgConfig::HDF5 pugixml::pugixml)
