# Everything comes from Debian packages; ./dev deps installs them.
find_package(GSL REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(FastFloat REQUIRED)
find_package(valijson REQUIRED)  # ashimpact::valijson
find_package(fmt REQUIRED)
find_package(Nettle REQUIRED)    # nettle::nettle, for SHA-256
find_package(Boost 1.68 REQUIRED)  # headers only: the tables of Boost.Random
find_package(TBB REQUIRED)
find_package(hwy REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(MINIZIP REQUIRED IMPORTED_TARGET GLOBAL minizip)  # spreadsheets are zip archives of XML
find_package(pugixml REQUIRED)
if(ASHIMPACT_SWEEP)
  set(MPI_CXX_SKIP_MPICXX ON)  # the C interface: that of C++ is no longer part of MPI
  find_package(MPI REQUIRED COMPONENTS CXX)
  pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5)  # CMake's own module requires a C compiler in the project
endif()
if(BUILD_TESTING)
  find_package(doctest REQUIRED)
endif()
