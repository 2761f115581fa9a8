# Rules of `cmake --install`: the compiler, the runtime, the standard library, and files for find_package(glift) and
# pkg-config. Only where both the compiler and the runtime are built.

include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/glift)

if(TARGET gliftc AND TARGET glift_runtime)
    set_target_properties(glift_runtime PROPERTIES EXPORT_NAME runtime)
    install(TARGETS gliftc glift_runtime EXPORT gliftTargets
            RUNTIME DESTINATION bin
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(EXPORT gliftTargets NAMESPACE glift:: DESTINATION ${config_dir})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/stdlib/ DESTINATION share/glift/stdlib FILES_MATCHING PATTERN "*.glift")
    # The files that `gliftc explain ID` shows as examples of diagnostics.
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/tests/errors/ DESTINATION share/glift/diagnostics
            FILES_MATCHING PATTERN "*.glift" PATTERN "*.*.glift" EXCLUDE PATTERN support EXCLUDE)
    if(TARGET glift_clang)
        install(TARGETS glift_clang LIBRARY DESTINATION lib/glift)
    endif()
    configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/gliftConfig.cmake.in
        ${PROJECT_BINARY_DIR}/gliftConfig.cmake INSTALL_DESTINATION ${config_dir})
    write_basic_package_version_file(${PROJECT_BINARY_DIR}/gliftConfigVersion.cmake COMPATIBILITY SameMinorVersion)
    install(FILES ${PROJECT_BINARY_DIR}/gliftConfig.cmake ${PROJECT_BINARY_DIR}/gliftConfigVersion.cmake
                  ${PROJECT_SOURCE_DIR}/cmake/GliftCompile.cmake ${PROJECT_SOURCE_DIR}/cmake/GliftDepfile.cmake
            DESTINATION ${config_dir})
    # find_package(glift) finds the build tree, too.
    export(EXPORT gliftTargets NAMESPACE glift:: FILE ${PROJECT_BINARY_DIR}/gliftTargets.cmake)
    foreach(file GliftCompile.cmake GliftDepfile.cmake)
        configure_file(${PROJECT_SOURCE_DIR}/cmake/${file} ${PROJECT_BINARY_DIR}/${file} COPYONLY)
    endforeach()
    # The prefix in glift.pc is relative to that file, since `cmake --install --prefix` may put it anywhere.
    cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/pkgconfig
               OUTPUT_VARIABLE GLIFT_PREFIX_FROM_PKGCONFIG)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/glift.pc.in ${PROJECT_BINARY_DIR}/glift.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/glift.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
