# glift_compile(TARGET target SOURCES file.glift… [IMPORT_DIRS dir…] [DEFINES name=value…] [OPTIONS option…]
#               [CHECKED])
#
# Compiles the files with gliftc, in one run, and adds what comes out to the target, with its include directory and the
# runtime that it calls. Works the same beside add_subdirectory and after find_package(glift). The include directories of the
# target get those in which gliftc looks for the headers of `extern struct`: the folders of the files, and IMPORT_DIRS.
#
# Of each file: <name>.glift.hpp, <name>.glift.cpp, and what it uses of other modules, <name>.glift.internal.hpp and
# <name>.glift.library.cpp. What several files use is in the library of the first: it is compiled once.
#
# CHECKED: kernels report accesses by address outside a structure (docs/language.md, "Checked builds").
#
# gliftc rewrites an output only when its bytes change. The stamp is what says that it ran; the outputs are byproducts,
# so an import that was only touched compiles no C++, and a second build does nothing.

function(glift_compile)
    cmake_parse_arguments(PARSE_ARGV 0 arg "CHECKED" "TARGET" "SOURCES;IMPORT_DIRS;DEFINES;OPTIONS")
    if(arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "glift_compile: unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
    endif()
    if(NOT arg_TARGET OR NOT TARGET ${arg_TARGET})
        message(FATAL_ERROR "glift_compile: TARGET must name an existing target")
    endif()
    if(NOT arg_SOURCES)
        message(FATAL_ERROR "glift_compile: SOURCES is empty")
    endif()

    set(out ${CMAKE_CURRENT_BINARY_DIR}/glift/${arg_TARGET})
    file(MAKE_DIRECTORY ${out})
    set(arguments)
    set(include_dirs)
    foreach(dir IN LISTS arg_IMPORT_DIRS)
        cmake_path(ABSOLUTE_PATH dir BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
        list(APPEND arguments -I ${dir})
        list(APPEND include_dirs ${dir})
    endforeach()
    foreach(define IN LISTS arg_DEFINES)
        list(APPEND arguments -D ${define})
    endforeach()
    if(arg_CHECKED)
        list(APPEND arguments --checked)
    endif()
    list(APPEND arguments ${arg_OPTIONS})

    set(sources)
    set(headers)
    set(codes)
    set(first)
    foreach(source IN LISTS arg_SOURCES)
        cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
        cmake_path(GET source STEM LAST_ONLY name)
        cmake_path(GET source PARENT_PATH folder)
        if(NOT first)
            set(first ${name})
        endif()
        list(APPEND sources ${source})
        list(APPEND include_dirs ${folder})
        list(APPEND headers ${out}/${name}.glift.hpp ${out}/${name}.glift.internal.hpp)
        list(APPEND codes ${out}/${name}.glift.cpp ${out}/${name}.glift.library.cpp)
    endforeach()
    list(REMOVE_DUPLICATES include_dirs)
    # In a build of the compiler itself: what reads C++ headers is a library that gliftc opens when it needs it.
    if(TARGET glift_clang)
        foreach(source IN LISTS sources)
            set(externs)
            if(EXISTS ${source})
                file(STRINGS ${source} externs REGEX "extern +struct")
            endif()
            if(externs)
                add_dependencies(${arg_TARGET} glift_clang)
            endif()
        endforeach()
    endif()

    set(stamp ${out}/${first}.stamp)
    add_custom_command(
        OUTPUT ${stamp}
        BYPRODUCTS ${headers} ${codes}
        COMMAND glift::gliftc -o ${out} --depfile ${out}/${first}.d --target=cpp --target=host ${arguments} ${sources}
        COMMAND ${CMAKE_COMMAND} -D DEPFILE=${out}/${first}.d -D STAMP=${stamp}
                -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/GliftDepfile.cmake
        DEPENDS ${sources} $<TARGET_FILE:glift::gliftc>
        DEPFILE ${out}/${first}.d
        COMMENT "Compiling ${arg_SOURCES}"
        VERBATIM)
    target_sources(${arg_TARGET} PRIVATE ${stamp} ${headers} ${codes})
    # Sums and products stay as written, so that the host device and the GPU agree to the bit. The other two
    # change no value: they let the compiler vectorise.
    set_source_files_properties(${codes} PROPERTIES COMPILE_OPTIONS
        "-ffp-contract=off;-fwrapv;-fno-math-errno;-fno-trapping-math;$<$<CONFIG:Release>:-O3>")

    set_property(TARGET ${arg_TARGET} APPEND PROPERTY INCLUDE_DIRECTORIES ${include_dirs})
    set_property(TARGET ${arg_TARGET} APPEND PROPERTY INTERFACE_INCLUDE_DIRECTORIES
        "$<BUILD_INTERFACE:${include_dirs}>")
    target_include_directories(${arg_TARGET} PUBLIC $<BUILD_INTERFACE:${out}>)
    target_link_libraries(${arg_TARGET} PUBLIC glift::runtime)
endfunction()
