# glift_compile(TARGET target SOURCES file.glift… [IMPORT_DIRS dir…] [DEFINES name=value…] [OPTIONS option…]
#               [CHECKED])
#
# Compiles each file with gliftc and adds what comes out (<name>.glift.hpp, <name>.glift.cpp) to the target, with its
# include directory, the runtime it calls and the threads (oneTBB) of its host kernels. Works the same beside add_subdirectory and after find_package(glift).
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
    foreach(dir IN LISTS arg_IMPORT_DIRS)
        cmake_path(ABSOLUTE_PATH dir BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
        list(APPEND arguments -I ${dir})
    endforeach()
    foreach(define IN LISTS arg_DEFINES)
        list(APPEND arguments -D ${define})
    endforeach()
    if(arg_CHECKED)
        list(APPEND arguments --checked)
    endif()
    list(APPEND arguments ${arg_OPTIONS})

    foreach(source IN LISTS arg_SOURCES)
        cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
        cmake_path(GET source STEM LAST_ONLY name)
        set(header ${out}/${name}.glift.hpp)
        set(code ${out}/${name}.glift.cpp)
        set(stamp ${out}/${name}.stamp)
        add_custom_command(
            OUTPUT ${stamp}
            BYPRODUCTS ${header} ${code}
            COMMAND glift::gliftc -o ${out} --depfile ${out}/${name}.d --target=cpp --target=host ${arguments} ${source}
            COMMAND ${CMAKE_COMMAND} -D DEPFILE=${out}/${name}.d -D STAMP=${stamp}
                    -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/GliftDepfile.cmake
            DEPENDS ${source} $<TARGET_FILE:glift::gliftc>
            DEPFILE ${out}/${name}.d
            COMMENT "Compiling ${name}.glift"
            VERBATIM)
        target_sources(${arg_TARGET} PRIVATE ${stamp} ${header} ${code})
        # Sums and products stay as written, so that the host device and the GPU agree to the bit. The other two
        # change no value: they let the compiler vectorise.
        set_source_files_properties(${code} PROPERTIES COMPILE_OPTIONS
            "-ffp-contract=off;-fwrapv;-fno-math-errno;-fno-trapping-math;$<$<CONFIG:Release>:-O3>")
    endforeach()

    target_include_directories(${arg_TARGET} PUBLIC $<BUILD_INTERFACE:${out}>)
    target_link_libraries(${arg_TARGET} PUBLIC glift::runtime TBB::tbb)
endfunction()
