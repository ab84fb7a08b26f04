# What `make install` installs: the program, one shared library with all rooms, its headers, the CMake and pkg-config
# files that find them, the man page, shell completion, and the scenes.
include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY AKTINA_ROOMS)
get_property(links GLOBAL PROPERTY AKTINA_LINKS)
add_library(aktina_library SHARED)
foreach(room ${rooms})
  target_sources(aktina_library PRIVATE $<TARGET_OBJECTS:${room}>)
endforeach()
list(REMOVE_DUPLICATES links)
target_link_libraries(aktina_library PRIVATE ${links})
target_include_directories(aktina_library PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                         $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(aktina_library PUBLIC cxx_std_20)
set_target_properties(aktina_library PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME aktina EXPORT_NAME aktina
                                                VERSION ${PROJECT_VERSION}
                                                SOVERSION ${PROJECT_VERSION_MAJOR}
                                                LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)

install(TARGETS aktina_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS aktina_library EXPORT aktina-targets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/aktina DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.h" PATTERN "*_simd*.h" EXCLUDE PATTERN "exr_*.h" EXCLUDE PATTERN "hdf5_*.h" EXCLUDE PATTERN "simd.h" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/aktina OPTIONAL)

# find_package(aktina CONFIG)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/aktina)
install(EXPORT aktina-targets NAMESPACE aktina:: DESTINATION ${package_folder})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/aktina-config.cmake.in
                              ${PROJECT_BINARY_DIR}/aktina-config.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/aktina-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/aktina-config.cmake ${PROJECT_BINARY_DIR}/aktina-config-version.cmake
        DESTINATION ${package_folder})

# pkg-config aktina
configure_file(${PROJECT_SOURCE_DIR}/cmake/aktina.pc.in ${PROJECT_BINARY_DIR}/aktina.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/aktina.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# Man page and completion come from the program's own tables.
set(generated ${PROJECT_BINARY_DIR}/share)
file(MAKE_DIRECTORY ${generated})
function(aktina_generated FILE DESTINATION)
  add_custom_command(OUTPUT ${generated}/${FILE} DEPENDS aktina_program VERBATIM
                     COMMAND sh -c "\"$0\" \"$@\" > ${generated}/${FILE}" $<TARGET_FILE:aktina_program> ${ARGN})
  set_property(GLOBAL APPEND PROPERTY AKTINA_GENERATED ${generated}/${FILE})
  install(FILES ${generated}/${FILE} DESTINATION ${DESTINATION})
endfunction()
aktina_generated(aktina.1 ${CMAKE_INSTALL_MANDIR}/man1 --man)
aktina_generated(aktina ${CMAKE_INSTALL_DATADIR}/bash-completion/completions --completion bash)
aktina_generated(_aktina ${CMAKE_INSTALL_DATADIR}/zsh/site-functions --completion zsh)
aktina_generated(aktina.fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d --completion fish)
get_property(files GLOBAL PROPERTY AKTINA_GENERATED)
add_custom_target(aktina_share ALL DEPENDS ${files})
