# Everything comes from Debian packages; ./dev deps installs them.
find_package(GSL REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(UDUNITS2 REQUIRED)  # ashimpact::udunits2
find_package(valijson REQUIRED)  # ashimpact::valijson
find_package(fmt REQUIRED)
find_package(Nettle REQUIRED)    # nettle::nettle, for SHA-256
if(BUILD_TESTING)
  find_package(doctest REQUIRED)
endif()
