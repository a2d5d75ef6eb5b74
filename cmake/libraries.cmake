# The libraries of others under twinbus, each found once, by CMake's own module, its package file or pkg-config, so that a
# distribution may put them where it likes.  What is missing is said with the name of the Debian package that brings it;
# config/packages.txt has them all.  Installed, too: who links twinbus's libraries needs the same ones.
#
# Gives Eigen3::Eigen, Threads::Threads, lcm::lcm, LCM_GEN and system::NAME of each twinbus_pkg_config(NAME ...).

function(twinbus_missing what package)
  message(FATAL_ERROR "\n  ${what} is missing; run: apt-get install ${package}\n")  # indented: CMake breaks no line of it
endfunction()

# twinbus_pkg_config(NAME MODULE PACKAGE): target system::NAME of the pkg-config module MODULE that Debian's PACKAGE brings.
# Only folders and libraries are taken over: FCL's file would set another C++ standard.
function(twinbus_pkg_config name module package)
  if(TARGET system::${name})
    return()
  endif()
  pkg_check_modules(twinbus_${name} QUIET ${module})
  if(NOT twinbus_${name}_FOUND)
    twinbus_missing("the library ${name} (pkg-config ${module})" ${package})
  endif()
  add_library(system::${name} INTERFACE IMPORTED GLOBAL)
  # Made plain: /usr/lib/x/../../include is /usr/include, which a compiler must not be given.
  set(folders)
  foreach(folder ${twinbus_${name}_INCLUDE_DIRS})
    get_filename_component(folder ${folder} REALPATH)
    list(APPEND folders ${folder})
  endforeach()
  set_target_properties(system::${name} PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${folders}"
    INTERFACE_LINK_LIBRARIES "${twinbus_${name}_LINK_LIBRARIES}")
endfunction()

if(POLICY CMP0167)
  cmake_policy(SET CMP0167 NEW)  # Boost's own package file; a macro keeps what is set where it is written
endif()
# twinbus_package(PACKAGE NAME [VERSION ...]): find_package(NAME ...), of Debian's PACKAGE.
macro(twinbus_package package name)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    twinbus_missing("${name} (${ARGN})" ${package})
  endif()
endmacro()

twinbus_package(pkg-config PkgConfig)
twinbus_package(libc6-dev Threads)
twinbus_package(libeigen3-dev Eigen3 3.4)
find_package(LCM QUIET)
if(NOT LCM_LIBRARY OR NOT LCM_INCLUDE_DIR)
  twinbus_missing("the library lcm" liblcm-dev)
elseif(NOT LCM_GEN)
  twinbus_missing("the program lcm-gen" liblcm-bin)
endif()
twinbus_pkg_config(ode ode libode-dev)
twinbus_pkg_config(urdfdom urdfdom liburdfdom-dev)
twinbus_pkg_config(console_bridge console_bridge libconsole-bridge-dev)
twinbus_pkg_config(expat expat libexpat1-dev)
twinbus_package(zlib1g-dev ZLIB)
twinbus_pkg_config(yaml_cpp yaml-cpp libyaml-cpp-dev)
