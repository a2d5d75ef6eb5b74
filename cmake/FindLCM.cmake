# LCM as Debian packages it: no CMake files of its own.  Gives lcm::lcm and LCM_GEN.
find_package(lcm CONFIG QUIET)
find_path(LCM_INCLUDE_DIR lcm/lcm.h)
find_library(LCM_LIBRARY lcm)
find_program(LCM_GEN lcm-gen)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LCM REQUIRED_VARS LCM_LIBRARY LCM_INCLUDE_DIR LCM_GEN)
if(LCM_FOUND AND NOT TARGET lcm::lcm)
  add_library(lcm::lcm UNKNOWN IMPORTED)
  set_target_properties(lcm::lcm PROPERTIES
    IMPORTED_LOCATION ${LCM_LIBRARY}
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${LCM_INCLUDE_DIR})
endif()
