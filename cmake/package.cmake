# `cmake --install BUILD --prefix P` and then, in a project of one's own:
#
#   find_package(twinbus REQUIRED)        # -DCMAKE_PREFIX_PATH=P
#   target_link_libraries(mine PRIVATE twinbus::robot twinbus::sim twinbus::planner twinbus::lcmtypes)
#
# Headers are included as in the tree, "robot/description/model.h".  The robots are in P/share/twinbus/config: set TWINBUS_CONFIG to it.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/twinbus)
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/twinbus)

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
  if(name MATCHES "^twinbus_(control|launcher|viewer_log)")
    continue()
  endif()
  string(REGEX REPLACE "^twinbus_" "" short ${name})
  set_target_properties(${name} PROPERTIES EXPORT_NAME ${short})
  list(APPEND exported ${name})
endforeach()
install(TARGETS ${exported} EXPORT twinbus
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT twinbus NAMESPACE twinbus:: FILE twinbusTargets.cmake DESTINATION ${package_dir} COMPONENT development)
foreach(room common geometry lcmtypes robot bridge sim planner)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room} DESTINATION ${header_dir} COMPONENT development
    FILES_MATCHING PATTERN "*.h" PATTERN "*.lcm")
endforeach()
install(DIRECTORY ${generated}/twinbus DESTINATION ${header_dir} COMPONENT development FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/config DESTINATION ${CMAKE_INSTALL_DATADIR}/twinbus COMPONENT development
  PATTERN "__pycache__" EXCLUDE)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/twinbusConfig.cmake.in
  ${PROJECT_BINARY_DIR}/twinbusConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/twinbusConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/twinbusConfig.cmake ${PROJECT_BINARY_DIR}/twinbusConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindLCM.cmake ${CMAKE_CURRENT_LIST_DIR}/libraries.cmake DESTINATION ${package_dir} COMPONENT development)
