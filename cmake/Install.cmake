# What `cmake --install` lays down: the programs, the runtime with its headers, the manual page, the examples, and the two ways in which
# other builds find them: find_package(mbcc) and pkg-config mbrt. The tree may be moved as a whole.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/mbcc)

set_target_properties(mbcc_program PROPERTIES EXPORT_NAME mbcc)
set_target_properties(mbrt PROPERTIES EXPORT_NAME runtime)
install(TARGETS mbcc_program mbcc_compare mbrt EXPORT mbccTargets)
install(DIRECTORY runtime/include/mbrt DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.hpp)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN *.mbd PATTERN *.md)
install(FILES ${PROJECT_BINARY_DIR}/compiler/driver/mbcc.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)

install(EXPORT mbccTargets NAMESPACE mbcc:: DESTINATION ${package_dir})
configure_package_config_file(cmake/mbccConfig.cmake.in mbccConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(mbccConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/mbccConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/mbccConfigVersion.cmake
              cmake/MbccModels.cmake
        DESTINATION ${package_dir})

file(RELATIVE_PATH prefix_from_pkgconfig /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(cmake/mbrt.pc.in mbrt.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/mbrt.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
