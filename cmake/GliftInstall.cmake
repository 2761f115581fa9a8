# Rules of `cmake --install`, in the components that tools/package makes packages of: the compiler, the runtime, the library
# of files with gliftinfo (files), what programs are built with (development), and documents with the examples (docs). Only where both the compiler and the
# runtime are built.

if(NOT TARGET gliftc OR NOT TARGET glift_runtime)
    return()
endif()

include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/glift)
set(GLIFT_DEBIAN OFF CACHE BOOL "Install what Debian's policy asks of packages: tools/package sets it")
set(GLIFT_ZSH_COMPLETIONS share/zsh/site-functions CACHE STRING "Where completion for zsh is installed")
set(GLIFT_DOC_DIR share/doc/glift CACHE STRING "Where the documents and examples are installed")

# The compiler.
install(TARGETS gliftc EXPORT gliftTargets RUNTIME DESTINATION bin COMPONENT compiler)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/stdlib/ DESTINATION share/glift/stdlib COMPONENT compiler
        FILES_MATCHING PATTERN "*.glift")
# The files that `gliftc explain ID` shows as examples of diagnostics.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tests/errors/ DESTINATION share/glift/diagnostics COMPONENT compiler
        FILES_MATCHING PATTERN "*.glift" PATTERN "*.*.glift" EXCLUDE PATTERN support EXCLUDE)
if(TARGET glift_clang)
    install(TARGETS glift_clang LIBRARY DESTINATION lib/glift COMPONENT compiler)
endif()
# Manual pages and shell completion, from the options that gliftc declares.
set(shell_files ${PROJECT_BINARY_DIR}/shell)
set(compress)
if(GLIFT_DEBIAN)
    set(compress COMMAND gzip -9nf ${shell_files}/man1/*.1)
endif()
add_custom_command(OUTPUT ${shell_files}/stamp
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${shell_files} COMMAND gliftc shell-files ${shell_files} ${compress}
    COMMAND ${CMAKE_COMMAND} -E touch ${shell_files}/stamp DEPENDS gliftc)
add_custom_target(gliftc_shell_files ALL DEPENDS ${shell_files}/stamp)
install(DIRECTORY ${shell_files}/man1/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT compiler)
install(FILES ${shell_files}/bash/gliftc DESTINATION share/bash-completion/completions COMPONENT compiler)
install(FILES ${shell_files}/zsh/_gliftc DESTINATION ${GLIFT_ZSH_COMPLETIONS} COMPONENT compiler)
install(FILES ${shell_files}/fish/gliftc.fish DESTINATION share/fish/vendor_completions.d COMPONENT compiler)

# The runtime, and what programs are built with.
set_target_properties(glift_runtime PROPERTIES EXPORT_NAME runtime)
install(TARGETS glift_runtime EXPORT gliftTargets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
if(TARGET glift_files)
    set_target_properties(glift_files PROPERTIES EXPORT_NAME files)
    install(TARGETS glift_files EXPORT gliftTargets
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT files NAMELINK_COMPONENT development
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/files/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
    install(TARGETS gliftinfo RUNTIME DESTINATION bin COMPONENT files)
    set(manual ${PROJECT_SOURCE_DIR}/files/gliftinfo/gliftinfo.1)
    if(GLIFT_DEBIAN)  # manual pages of packages are compressed
        configure_file(${manual} ${PROJECT_BINARY_DIR}/packaging/gliftinfo.1 COPYONLY)
        execute_process(COMMAND gzip -9nf ${PROJECT_BINARY_DIR}/packaging/gliftinfo.1 COMMAND_ERROR_IS_FATAL ANY)
        set(manual ${PROJECT_BINARY_DIR}/packaging/gliftinfo.1.gz)
    endif()
    install(FILES ${manual} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT files)
endif()
install(EXPORT gliftTargets NAMESPACE glift:: DESTINATION ${config_dir} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(PROGRAMS ${PROJECT_SOURCE_DIR}/tools/inspect DESTINATION share/glift/tools COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/gliftConfig.cmake.in
    ${PROJECT_BINARY_DIR}/gliftConfig.cmake INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gliftConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gliftConfig.cmake ${PROJECT_BINARY_DIR}/gliftConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/GliftCompile.cmake ${PROJECT_SOURCE_DIR}/cmake/GliftDepfile.cmake
        DESTINATION ${config_dir} COMPONENT development)
# glift::mpi has a file of its own, which gliftConfig.cmake reads where MPI is found.
if(TARGET glift_mpi)
    set_target_properties(glift_mpi PROPERTIES EXPORT_NAME mpi)
    install(TARGETS glift_mpi EXPORT gliftMpiTargets
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
    install(EXPORT gliftMpiTargets NAMESPACE glift:: DESTINATION ${config_dir} COMPONENT development)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime/mpi/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
            COMPONENT development)
    export(EXPORT gliftMpiTargets NAMESPACE glift:: FILE ${PROJECT_BINARY_DIR}/gliftMpiTargets.cmake)
endif()
# find_package(glift) finds the build tree, too: tests/cmake uses it so.
export(EXPORT gliftTargets NAMESPACE glift:: FILE ${PROJECT_BINARY_DIR}/gliftTargets.cmake)
foreach(file GliftCompile.cmake GliftDepfile.cmake)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/${file} ${PROJECT_BINARY_DIR}/${file} COPYONLY)
endforeach()
# The prefix in glift.pc is relative to that file, since `cmake --install --prefix` may put it anywhere.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/pkgconfig
           OUTPUT_VARIABLE GLIFT_PREFIX_FROM_PKGCONFIG)
configure_file(${PROJECT_SOURCE_DIR}/cmake/glift.pc.in ${PROJECT_BINARY_DIR}/glift.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/glift.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

# Documents and examples.
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/LICENCE DESTINATION ${GLIFT_DOC_DIR} COMPONENT docs)
if(NOT GLIFT_DEBIAN)  # there it is changelog.gz
    install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${GLIFT_DOC_DIR} COMPONENT docs)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${GLIFT_DOC_DIR}/docs COMPONENT docs)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/ DESTINATION ${GLIFT_DOC_DIR}/examples COMPONENT docs)

if(PROJECT_IS_TOP_LEVEL)
    include(GliftPackages)
endif()
