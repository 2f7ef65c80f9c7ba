# Install rules and the Debian package: the binary, the runtime's headers, and how CMake and pkg-config find them.
include(CMakePackageConfigHelpers)

# A directory of its own: -I/usr/include would bring the headers of this machine into a cross-compilation.
set(mbgen_include_directory ${CMAKE_INSTALL_INCLUDEDIR}/mbgen)
# The same files serve every target processor, so that one that is cross-compiled for finds them too.
set(package_directory ${CMAKE_INSTALL_DATAROOTDIR}/cmake/mbgen)
set(package_files ${CMAKE_CURRENT_BINARY_DIR}/package)

foreach(list gnu clang gnu_lanes_x86)
  set(file ${CMAKE_CURRENT_SOURCE_DIR}/templates/${list}.flags)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(STRINGS ${file} mbgen_${list}_flags REGEX "^-")
  list(JOIN mbgen_${list}_flags " " mbgen_${list}_flags)
endforeach()
configure_package_config_file(cmake/mbgenConfig.cmake.in ${package_files}/mbgenConfig.cmake
  INSTALL_DESTINATION ${package_directory} PATH_VARS CMAKE_INSTALL_BINDIR mbgen_include_directory
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
configure_file(cmake/mbgenFunctions.cmake.in ${package_files}/mbgenFunctions.cmake @ONLY)
configure_file(cmake/mbgen.pc.in ${package_files}/mbgen.pc @ONLY)
write_basic_package_version_file(${package_files}/mbgenConfigVersion.cmake COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)

# The man page and what shells complete, as the binary itself tells them.
set(mbgen_words ${CMAKE_CURRENT_BINARY_DIR}/words)
add_custom_command(OUTPUT ${mbgen_words}/mbgen.1 ${mbgen_words}/mbgen ${mbgen_words}/_mbgen ${mbgen_words}/mbgen.fish
  COMMAND ${CMAKE_COMMAND} -E make_directory ${mbgen_words}
  COMMAND mbgen manual > ${mbgen_words}/mbgen.1
  COMMAND mbgen completion bash > ${mbgen_words}/mbgen
  COMMAND mbgen completion zsh > ${mbgen_words}/_mbgen
  COMMAND mbgen completion fish > ${mbgen_words}/mbgen.fish
  VERBATIM)
add_custom_target(mbgen_words ALL DEPENDS ${mbgen_words}/mbgen.1)
install(FILES ${mbgen_words}/mbgen.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
install(FILES ${mbgen_words}/mbgen DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions OPTIONAL)
install(FILES ${mbgen_words}/_mbgen DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/zsh/vendor-completions OPTIONAL)
install(FILES ${mbgen_words}/mbgen.fish DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/fish/vendor_completions.d OPTIONAL)

install(TARGETS mbgen RUNTIME)
if(TARGET mbgen_least_squares)
  install(TARGETS mbgen_least_squares LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/mbgen)
endif()
install(DIRECTORY runtime/include/mbgen DESTINATION ${mbgen_include_directory} FILES_MATCHING PATTERN *.hpp)
install(FILES ${package_files}/mbgenConfig.cmake ${package_files}/mbgenFunctions.cmake
  ${package_files}/mbgenConfigVersion.cmake DESTINATION ${package_directory})
install(FILES ${package_files}/mbgen.pc DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/pkgconfig)

install(FILES cmake/copyright DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/mbgen)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mbgen)
set(CPACK_PACKAGE_CONTACT "maintainers of mbgen <mbgen@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "compiler from multibody systems to specialised C++ solvers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# `simulate` compiles what it runs, unless it is told to use another engine.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "g++, cmake")
include(CPack)
