# A room of the house is a folder of folders.  Each folder is a library; its PUBLIC and PRIVATE links are the arrows that
# test/structure/arrows_test.py holds the includes to.

# twinbus_folder(FOLDER [PUBLIC FOLDER...] [PRIVATE FOLDER...] [LIBRARIES TARGET...])
#
# The library twinbus_<folder with _ for /> of all sources in FOLDER that are no main.  PUBLIC: folders that its headers
# include; PRIVATE: those that only its sources do; LIBRARIES: of others.
function(twinbus_folder folder)
  cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE;LIBRARIES" ${ARGN})
  string(REPLACE "/" "_" name twinbus_${folder})
  if(NOT folder MATCHES "/")
    set(name ${name}_top)  # files of a room that lie in none of its folders
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "(/|_)main\\.cpp$")
  set(public twinbus_flags)
  set(private)
  foreach(kind PUBLIC PRIVATE)
    foreach(other ${ARG_${kind}})
      string(REPLACE "/" "_" target twinbus_${other})
      if(NOT other MATCHES "/")
        string(APPEND target _top)
      endif()
      string(TOLOWER ${kind} list)
      list(APPEND ${list} ${target})
    endforeach()
  endforeach()
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC ${public} PRIVATE ${private} ${ARG_LIBRARIES})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE ${public} ${private} ${ARG_LIBRARIES})
  endif()
  string(REGEX REPLACE "/.*" "" room ${folder})
  set_property(GLOBAL APPEND PROPERTY TWINBUS_FOLDERS ${name})
  set_property(GLOBAL APPEND PROPERTY TWINBUS_FOLDERS_${room} ${name})
endfunction()

# twinbus_room(ROOM): the library twinbus_ROOM, everything of its folders.
function(twinbus_room room)
  get_property(folders GLOBAL PROPERTY TWINBUS_FOLDERS_${room})
  add_library(twinbus_${room} INTERFACE)
  target_link_libraries(twinbus_${room} INTERFACE ${folders})
  set_property(GLOBAL APPEND PROPERTY TWINBUS_FOLDERS twinbus_${room})
endfunction()
