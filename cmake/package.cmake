# `ninja -C BUILD installable`, `cmake --install BUILD --prefix P`:
#
#   P/bin/twinbus             the program twinbus; as ./twinbus, but that it builds nothing
#   P/lib/twinbus/bin         the processes            P/lib/twinbus/lib/adaptors   adaptors of hardware
#   P/lib/twinbus/lib/python  message types in Python  P/lib/twinbus/share/types.jar  in Java
#   P/lib/twinbus/lib/native  the compiled part of the Python package, where nanobind was when it was built (Debian 13; python/CMakeLists.txt)
#   P/include/twinbus         headers, and message types in C++
#   P/share/twinbus           config (robots, scenes, stacks), lcmtypes (*.lcm), python, examples, the viewer's page, doc
#
# and then, in a project of one's own:
#
#   find_package(twinbus REQUIRED)        # -DCMAKE_PREFIX_PATH=P
#   target_link_libraries(mine PRIVATE twinbus::robot twinbus::sim twinbus::planner twinbus::lcmtypes)
#
# Headers are included as in the tree, "robot/description/model.h".  Folders of the rest: twinbus_PROGRAMS_DIR, twinbus_ADAPTORS_DIR,
# twinbus_CONFIG_DIR, twinbus_LCMTYPES_DIR, twinbus_PYTHON_DIR, and twinbus_JAR.  `cpack --config BUILD/CPackConfig.cmake -B OUT`
# makes a Debian package of all that.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # no tests and benches are built for an installation
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/twinbus)
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/twinbus)
set(home_dir lib/twinbus)  # as a build folder is inside; the programs find one another and the rest by it
set(data_dir share/twinbus)

# Our warnings are for our code; what a user compiles gets the include folder.
get_target_property(options twinbus_flags INTERFACE_COMPILE_OPTIONS)
list(TRANSFORM options REPLACE "(.+)" "$<BUILD_INTERFACE:\\1>")
set_target_properties(twinbus_flags PROPERTIES
  INTERFACE_COMPILE_OPTIONS "${options}"
  INTERFACE_INCLUDE_DIRECTORIES "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>;$<INSTALL_INTERFACE:${header_dir}>")
get_target_property(generated twinbus_messages INTERFACE_INCLUDE_DIRECTORIES)
set_target_properties(twinbus_messages PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "$<BUILD_INTERFACE:${generated}>;$<INSTALL_INTERFACE:${header_dir}>"
  INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "$<BUILD_INTERFACE:${generated}>")
# Whoever talks on the bus needs the messages.
set_property(TARGET twinbus_lcmtypes APPEND PROPERTY
  INTERFACE_LINK_LIBRARIES $<INSTALL_INTERFACE:twinbus::messages>)

# twinbus::robot is a room, twinbus::robot_collision one of its folders.
get_property(libraries GLOBAL PROPERTY TWINBUS_FOLDERS)
set(exported)
foreach(name ${libraries} twinbus_flags twinbus_messages)
  if(name MATCHES "^twinbus_(control|launcher|viewer_log|python)")
    continue()
  endif()
  string(REGEX REPLACE "^twinbus_" "" short ${name})
  set_target_properties(${name} PROPERTIES EXPORT_NAME ${short})
  list(APPEND exported ${name})
endforeach()
add_custom_target(installable DEPENDS programs ${exported})
set(python_recommends)
if(TARGET twinbus_native)
  add_dependencies(installable twinbus_native)
  set(python_recommends ", python3-numpy")
endif()
install(TARGETS ${exported} EXPORT twinbus
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT twinbus NAMESPACE twinbus:: FILE twinbusTargets.cmake DESTINATION ${package_dir} COMPONENT development)
foreach(room common geometry lcmtypes robot bridge sim planner)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room} DESTINATION ${header_dir} COMPONENT development
    FILES_MATCHING PATTERN "*.h")
endforeach()
install(DIRECTORY ${TWINBUS_MADE_MESSAGES}/lcmtypes DESTINATION ${header_dir} COMPONENT development
  FILES_MATCHING PATTERN "message_samples.h" EXCLUDE PATTERN "message_fields.h" EXCLUDE PATTERN "older_messages.h" EXCLUDE PATTERN "*.h")
install(DIRECTORY ${generated}/twinbus DESTINATION ${header_dir} COMPONENT development FILES_MATCHING PATTERN "*.hpp")

# What runs: programs, adaptors, and what they read.
get_target_property(names programs MANUALLY_ADDED_DEPENDENCIES)
foreach(name twinbus_cli ${names})
  get_target_property(type ${name} TYPE)
  if(type STREQUAL "EXECUTABLE")
    install(TARGETS ${name} RUNTIME DESTINATION ${home_dir}/bin COMPONENT programs)
  elseif(type STREQUAL "MODULE_LIBRARY")
    install(TARGETS ${name} LIBRARY DESTINATION ${home_dir}/lib/adaptors COMPONENT programs)
  endif()
endforeach()
install(DIRECTORY ${CMAKE_BINARY_DIR}/lib/python DESTINATION ${home_dir}/lib COMPONENT programs PATTERN "__pycache__" EXCLUDE)
if(TARGET twinbus_java)
  install(FILES ${CMAKE_BINARY_DIR}/share/types.jar DESTINATION ${home_dir}/share COMPONENT programs)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/config DESTINATION ${data_dir} COMPONENT programs
  PATTERN "__pycache__" EXCLUDE PATTERN "packages.txt" EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/campaign DESTINATION ${data_dir} COMPONENT programs FILES_MATCHING PATTERN "*.py" PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/lcmtypes DESTINATION ${data_dir} COMPONENT programs FILES_MATCHING PATTERN "*.lcm" PATTERN "README.md")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/viewer_log/web/dist DESTINATION ${data_dir}/viewer_log/web COMPONENT programs)
# In a wheel the package is around all this, and zip files have no links.
if(SKBUILD)
  set(links PATTERN "examples/twinbus" EXCLUDE)
else()
  set(links)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/twinbus DESTINATION ${data_dir}/python COMPONENT programs PATTERN "__pycache__" EXCLUDE)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/link)
  file(CREATE_LINK ../${home_dir}/bin/twinbus ${PROJECT_BINARY_DIR}/link/twinbus SYMBOLIC)
  install(FILES ${PROJECT_BINARY_DIR}/link/twinbus DESTINATION bin COMPONENT programs)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${data_dir} COMPONENT programs
  PATTERN "__pycache__" EXCLUDE PATTERN "CMakeLists.txt" EXCLUDE ${links})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/doc DESTINATION ${data_dir} COMPONENT programs FILES_MATCHING PATTERN "*.md")
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${data_dir} COMPONENT programs)
install(PROGRAMS ${PROJECT_SOURCE_DIR}/launcher/env.sh ${PROJECT_SOURCE_DIR}/launcher/spy.sh ${PROJECT_SOURCE_DIR}/launcher/policy.sh ${PROJECT_SOURCE_DIR}/launcher/named_state.py
  DESTINATION ${data_dir}/launcher COMPONENT programs)
# The commit that `twinbus --version` shows and that is written into logs.
install(CODE "
  execute_process(COMMAND git -C \"${PROJECT_SOURCE_DIR}\" rev-parse HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
    RESULT_VARIABLE failed ERROR_QUIET)
  if(failed)
    set(commit unknown)
  endif()
  file(WRITE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${data_dir}/commit\" \"\${commit}\\n\")" COMPONENT programs)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/twinbusConfig.cmake.in
  ${PROJECT_BINARY_DIR}/twinbusConfig.cmake INSTALL_DESTINATION ${package_dir} PATH_VARS home_dir data_dir)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/twinbusConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/twinbusConfig.cmake ${PROJECT_BINARY_DIR}/twinbusConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindLCM.cmake ${CMAKE_CURRENT_LIST_DIR}/libraries.cmake DESTINATION ${package_dir} COMPONENT development)

# One Debian package.  Needed: the libraries that the programs load.  Recommended: what a project needs that builds with it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME twinbus)
set(CPACK_PACKAGE_CONTACT "twinbus developers <twinbus@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Simulator, controller, guard, planner and viewer of humanoid robots on an LCM bus")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3, iproute2")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "cmake, g++, pkg-config, liblcm-dev, liblcm-bin, libeigen3-dev, libode-dev, liburdfdom-dev, libconsole-bridge-dev, libexpat1-dev, zlib1g-dev, libyaml-cpp-dev${python_recommends}")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "default-jre, liblcm-java, libjchart2d-java")
include(CPack)
