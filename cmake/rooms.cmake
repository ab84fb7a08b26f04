# One target per folder of src/aktina. A room may use only the rooms named after USES, which stand above
# it in the table of docs/architecture.md; scripts/check_layers.py holds the #include lines to the same table.
#
#   aktina_room(NAME scene USES base illumination image texture LINKS draco::draco)
#
# compiles every .cpp below the folder that is not in a sub-room of its own.
function(aktina_room)
  cmake_parse_arguments(ROOM "" "NAME" "USES;LINKS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${ROOM_NAME}/*.cpp)
  add_library(aktina_${ROOM_NAME} STATIC ${sources})
  target_include_directories(aktina_${ROOM_NAME} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(aktina_${ROOM_NAME} PRIVATE aktina_flags)
  foreach(room ${ROOM_USES})
    target_link_libraries(aktina_${ROOM_NAME} PUBLIC aktina_${room})
  endforeach()
  target_link_libraries(aktina_${ROOM_NAME} PRIVATE ${ROOM_LINKS})
  set_property(GLOBAL APPEND PROPERTY AKTINA_ROOMS aktina_${ROOM_NAME})
  set_property(GLOBAL APPEND PROPERTY AKTINA_LINKS ${ROOM_LINKS})
endfunction()
