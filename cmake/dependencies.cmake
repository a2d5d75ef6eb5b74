# Everything of others that building and testing twinbus needs: its libraries', and what only its programs and tests use.
include(libraries)
twinbus_package(nlohmann-json3-dev nlohmann_json 3.10)
twinbus_pkg_config(zstd libzstd libzstd-dev)
twinbus_package(libboost-dev Boost 1.71)  # headers only: Asio and Beast
twinbus_pkg_config(sdl2 sdl2 libsdl2-dev)
twinbus_pkg_config(fcl fcl libfcl-dev)  # what tests and benches compare collision checks with
twinbus_package(libgtest-dev GTest)
twinbus_package(python3 Python3 COMPONENTS Interpreter)

# Optional: the face of a Unitree robot on DDS (./twinbus face).  idlc comes apart from the library.
find_package(CycloneDDS 0.10 QUIET)
find_program(TWINBUS_IDLC idlc)
mark_as_advanced(TWINBUS_IDLC)
set(TWINBUS_DDS OFF)
if(TARGET CycloneDDS::ddsc AND TWINBUS_IDLC)
  set(TWINBUS_DDS ON)
else()
  message(STATUS "no CycloneDDS or no idlc: twinbus_face is not built (apt install cyclonedds-dev cyclonedds-tools)")
endif()
