# Debian packages, one for each component of the install rules: tools/package makes them.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME glift)
set(CPACK_PACKAGE_VENDOR Glift)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL compiler runtime development docs)
if(TARGET glift_files)
    list(APPEND CPACK_COMPONENTS_ALL files)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
# The address is a placeholder: the owner's is not known.
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "Glift <glift@example.org>" CACHE STRING "Name and address in the packages")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib)

set(soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(library libglift${soversion})
set(same "(= ${PROJECT_VERSION}-1)")
set(packaging ${PROJECT_BINARY_DIR}/packaging)

# glift_package(component package section description): a package, and what Debian's policy asks of it.
macro(glift_package component package section description)
    string(TOUPPER ${component} upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
    set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
    if(GLIFT_DEBIAN)
        install(FILES ${PROJECT_SOURCE_DIR}/packaging/copyright ${packaging}/changelog.Debian.gz
                DESTINATION share/doc/${package} COMPONENT ${component})
        set(PACKAGE ${package})
        configure_file(${PROJECT_SOURCE_DIR}/packaging/${component}.overrides.in ${packaging}/${package} @ONLY)
        install(FILES ${packaging}/${package} DESTINATION share/lintian/overrides COMPONENT ${component})
    endif()
endmacro()

glift_package(compiler gliftc devel "compiler of Glift, a language for GPU data structures
gliftc compiles structures and kernels to C++ bindings, to SPIR-V for Vulkan,
and to C++ for the CPU's cores.")
glift_package(runtime ${library} libs "runtime of Glift, a language for GPU data structures
The library that programs which use Glift are linked with. It needs a driver
of Vulkan only for GPUs.")
if(TARGET glift_files)
    glift_package(files libglift-files${soversion} libs "files of structures of Glift, a language for GPU data structures
The library with which programs save structures to HDF5 and load them, and
gliftinfo, which shows, checks, compares and converts such files.")
endif()
glift_package(development libglift-dev libdevel "files for programs that use Glift
Headers, files for CMake and pkg-config, and the inspector of structures.")
glift_package(docs glift-doc doc "documents and examples of Glift
The tutorial, the reference, and the sources of the examples.")

set(CPACK_DEBIAN_COMPILER_PACKAGE_RECOMMENDS "g++, libglift-dev ${same}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "libvulkan1")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "mesa-vulkan-drivers, vulkan-validationlayers")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${packaging}/shlibs ${packaging}/triggers)
set(development_depends "${library} ${same}, gliftc ${same}, libtbb-dev")
if(TARGET glift_files)
    set(CPACK_DEBIAN_FILES_PACKAGE_CONTROL_EXTRA ${packaging}/files/shlibs ${packaging}/triggers)
    string(APPEND development_depends ", libglift-files${soversion} ${same}")
endif()
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${development_depends}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "python3, glift-doc")
set(CPACK_DEBIAN_DOCS_PACKAGE_ARCHITECTURE all)

if(GLIFT_DEBIAN)
    file(WRITE ${packaging}/shlibs "libglift ${soversion} ${library} (>= ${PROJECT_VERSION}-1)\n")
    file(WRITE ${packaging}/files/shlibs
        "libglift_files ${soversion} libglift-files${soversion} (>= ${PROJECT_VERSION}-1)\n")
    file(WRITE ${packaging}/triggers "activate-noawait ldconfig\n")
    string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
    file(WRITE ${packaging}/changelog.Debian
        "glift (${PROJECT_VERSION}-1) bookworm; urgency=medium\n\n"
        "  * Version ${PROJECT_VERSION}: see changelog.gz in glift-doc.\n\n"
        " -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}\n")
    configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${packaging}/changelog COPYONLY)
    execute_process(COMMAND gzip -9nf ${packaging}/changelog.Debian ${packaging}/changelog COMMAND_ERROR_IS_FATAL ANY)
    install(FILES ${packaging}/changelog.gz DESTINATION share/doc/glift-doc COMPONENT docs)
endif()

include(CPack)
