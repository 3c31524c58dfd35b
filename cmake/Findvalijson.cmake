# valijson is headers only and Debian packages no CMake file for it: imported target ashimpact::valijson.
find_path(VALIJSON_INCLUDE_DIR valijson/validator.hpp)
mark_as_advanced(VALIJSON_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(valijson REQUIRED_VARS VALIJSON_INCLUDE_DIR)

if(valijson_FOUND AND NOT TARGET ashimpact::valijson)
  add_library(ashimpact::valijson INTERFACE IMPORTED GLOBAL)
  set_target_properties(ashimpact::valijson PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${VALIJSON_INCLUDE_DIR}")
endif()
