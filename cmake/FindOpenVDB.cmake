# Finds OpenVDB as Debian packages it, with the two libraries its headers pull in: OpenVDB::openvdb.
# Debian's own FindOpenVDB module looks for every optional part of Boost as well.
find_path(OpenVDB_INCLUDE_DIR openvdb/openvdb.h)
find_path(OpenVDB_BOOST_INCLUDE_DIR boost/numeric/conversion/conversion_traits.hpp)
find_library(OpenVDB_LIBRARY openvdb)
find_library(OpenVDB_IMATH_LIBRARY Imath-3_1)
find_package(TBB QUIET)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenVDB REQUIRED_VARS
  OpenVDB_LIBRARY OpenVDB_INCLUDE_DIR OpenVDB_BOOST_INCLUDE_DIR OpenVDB_IMATH_LIBRARY TBB_FOUND)
mark_as_advanced(OpenVDB_INCLUDE_DIR OpenVDB_BOOST_INCLUDE_DIR OpenVDB_LIBRARY
                 OpenVDB_IMATH_LIBRARY)

if(OpenVDB_FOUND AND NOT TARGET OpenVDB::openvdb)
  add_library(OpenVDB::openvdb UNKNOWN IMPORTED)
  set_target_properties(OpenVDB::openvdb PROPERTIES
    IMPORTED_LOCATION "${OpenVDB_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OpenVDB_INCLUDE_DIR};${OpenVDB_BOOST_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "TBB::tbb;${OpenVDB_IMATH_LIBRARY}")
endif()
