# find_package(P4est): the target P4est::P4est, p4est with its support library sc, for MPI::MPI_CXX,
# which must have been looked for. Neither p4est 2.2 nor Debian brings a file of this kind.
find_path(P4EST_INCLUDE_DIR p8est.h)
find_library(P4EST_LIBRARY p4est)
find_library(P4EST_SC_LIBRARY sc)
mark_as_advanced(P4EST_INCLUDE_DIR P4EST_LIBRARY P4EST_SC_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(P4est
  REQUIRED_VARS P4EST_LIBRARY P4EST_SC_LIBRARY P4EST_INCLUDE_DIR MPI_CXX_FOUND)
if(P4est_FOUND AND NOT TARGET P4est::P4est)
  add_library(P4est::P4est UNKNOWN IMPORTED)
  set_target_properties(P4est::P4est PROPERTIES
    IMPORTED_LOCATION ${P4EST_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${P4EST_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "${P4EST_SC_LIBRARY};MPI::MPI_CXX")
endif()
