# glift_compile(TARGET target SOURCES file.glift… [IMPORT_DIRS dir…] [DEFINES name=value…] [OPTIONS option…]
#               [SHARDS n] [ADDRESS_BITS n] [CHECKED])
#
# Compiles the files with gliftc, in one run, and adds the output to the target, with its include directory and the
# runtime that it calls. Works the same with add_subdirectory and with find_package(glift). The target also gets the
# include directories in which gliftc looks for the headers of `extern struct`: the folders of the files, and
# IMPORT_DIRS.
#
# Outputs for each file: docs/reference/language.md, "Names". Code that several files use is in the sources of one of
# them: the first in an order in which a file comes after those that it imports.
#
# IMPORT_DIRS: folders in which `use` finds modules (gliftc -I). DEFINES: name=value, values for constants of the
# files (gliftc -D). OPTIONS: further options of gliftc.
#
# SHARDS (default 4): the number of C++ sources for the kernels of a file's module; as many again are for the kernels of
# other modules that the file uses. CMake has to know the sources before gliftc runs; the number of kernels decides how
# many of them are used, and a kernel's name, with its generic arguments, in which of these it is. So an edit of a
# kernel's body that keeps the number of lines recompiles the sources of its instances, and file.glift.cpp only if what
# the host passes to the kernel changes.
#
# ADDRESS_BITS (32 or 64, default 32): of physical addresses in kernels (gliftc --address-bits). With 64, memories may
# have 2^32 elements and more.
#
# CHECKED: kernels report accesses by address outside a structure (gliftc --checked; docs/reference/language.md,
# "Checked builds").
#
# GLIFT_SPIRV_FILES, a cache variable (detected once; set it to OFF for C++ that needs no files): SPIR-V is in files
# beside the sources, which the assembler embeds.
#
# GLIFT_RELOAD, a variable (OFF without it): a running program takes newer code of kernels and pipelines (gliftc
# --reload). The options of `gliftc watch` for the files are in glift/<target>/<first file>.watch of the build folder,
# and programs load from the folder glift/<target>/<first file>.reload beside it.
#
# In builds of type Debug and RelWithDebInfo (gliftc -g) debuggers show kernels on the host device at the lines of the
# .glift files.
#
# Call it in the folder that makes the target. The files of a target must differ in name. Kernels are compiled with -O3
# in builds of every type, and without a type, Debug aside. In builds of type Release and MinSizeRel their SPIR-V is
# made smaller (gliftc -O), and `print` and `assert` are left out (gliftc --no-print; OPTIONS --print keeps them).
#
# gliftc rewrites an output only if its bytes change. So the build rule's output is a stamp file, and gliftc's outputs
# are byproducts: where an import was touched but not changed, no C++ is compiled again, and a second build does
# nothing.

include(CheckCXXSourceCompiles)

# Sets GLIFT_SPIRV_FILES: whether the compiler's assembler can embed a file as the macro GLIFT_SPIRV_FILE of
# glift/kernel.h does.
function(glift_check_spirv_files)
    set(words ${CMAKE_BINARY_DIR}/CMakeFiles/glift_spirv_words)
    file(WRITE ${words} "word")
    check_cxx_source_compiles("
        asm(R\"asm(
            .pushsection .rodata.glift, \"a\"
            .balign 4
            .weak words
            .hidden words
            words: .incbin \"${words}\"
            .popsection
        )asm\");
        extern \"C\" __attribute__((visibility(\"hidden\"))) const unsigned words[1];
        int main() { return words[0] == 0; }" GLIFT_SPIRV_FILES)
endfunction()

# Ends with an error if two files of the target, of this call or of earlier ones, have one name: their outputs would, too.
function(glift_check_names target)
    foreach(source IN LISTS ARGN)
        cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
        cmake_path(GET source STEM LAST_ONLY name)
        string(MAKE_C_IDENTIFIER "GLIFT_FILE_${name}" property)
        get_target_property(earlier ${target} ${property})
        if(earlier)
            message(FATAL_ERROR "glift_compile: target '${target}' has two files whose outputs would have one name: "
                    "${earlier} and ${source}. Rename one of them, or compile it for another target")
        endif()
        set_target_properties(${target} PROPERTIES ${property} ${source})
    endforeach()
endfunction()

# Writes the options of `gliftc watch`, one a line, as a response file of gliftc.
function(glift_write_watch_file file out)
    set(text)
    foreach(word IN ITEMS -o ${out} LISTS ARGN)
        if(NOT word MATCHES "^[$]<")  # a generator expression may be empty, and is then no word
            string(REPLACE "\\" "\\\\" word "${word}")
            string(REPLACE "\"" "\\\"" word "${word}")
            set(word "\"${word}\"")
        endif()
        string(APPEND text "${word}\n")
    endforeach()
    get_property(has_several GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
    if(has_several)
        string(APPEND file .$<CONFIG>)
    endif()
    file(GENERATE OUTPUT ${file} CONTENT "${text}")
endfunction()

function(glift_compile)
    cmake_parse_arguments(PARSE_ARGV 0 arg "CHECKED" "TARGET;SHARDS;ADDRESS_BITS" "SOURCES;IMPORT_DIRS;DEFINES;OPTIONS")
    if(arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "glift_compile: unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
    endif()
    if(NOT arg_TARGET OR NOT TARGET ${arg_TARGET})
        message(FATAL_ERROR "glift_compile: TARGET must name an existing target")
    endif()
    if(NOT arg_SOURCES)
        message(FATAL_ERROR "glift_compile: SOURCES is empty")
    endif()

    # CMake attaches custom commands and properties of sources only to targets of the same folder.
    get_target_property(target_folder ${arg_TARGET} SOURCE_DIR)
    if(NOT target_folder STREQUAL CMAKE_CURRENT_SOURCE_DIR)
        message(FATAL_ERROR "glift_compile: call it in the folder that makes the target '${arg_TARGET}': ${target_folder}")
    endif()
    glift_check_names(${arg_TARGET} ${arg_SOURCES})

    if(NOT arg_SHARDS)
        set(arg_SHARDS 4)
    endif()
    glift_check_spirv_files()

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
    if(arg_ADDRESS_BITS)
        list(APPEND arguments --address-bits=${arg_ADDRESS_BITS})
    endif()
    list(APPEND arguments --shards=${arg_SHARDS})
    if(GLIFT_SPIRV_FILES)
        list(APPEND arguments --spirv-files)
    endif()
    if(GLIFT_RELOAD)
        list(APPEND arguments --reload)
    endif()
    list(APPEND arguments ${arg_OPTIONS})

    set(sources)
    set(headers)
    set(bindings)
    set(kernels)
    set(spirv)
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
        list(APPEND headers ${out}/${name}.glift.hpp ${out}/${name}.glift.types.hpp ${out}/${name}.glift.internal.hpp)
        list(APPEND bindings ${out}/${name}.glift.cpp ${out}/${name}.glift.library.cpp)
        foreach(shard RANGE 1 ${arg_SHARDS})
            set(number .${shard})
            if(shard EQUAL 1)
                set(number)
            endif()
            foreach(part kernels library.kernels)
                list(APPEND kernels ${out}/${name}.glift.${part}${number}.cpp)
                list(APPEND spirv ${out}/${name}.glift.${part}${number}.spirv)
            endforeach()
        endforeach()
    endforeach()
    set(codes ${bindings} ${kernels})
    list(REMOVE_DUPLICATES include_dirs)
    # In a build of the compiler itself: for `extern struct`, gliftc loads the library glift_clang at run time, which
    # reads C++ headers.
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

    if(NOT GLIFT_SPIRV_FILES)
        set(spirv)
    endif()
    set(by_type "$<$<CONFIG:Debug,RelWithDebInfo>:-g>" "$<$<CONFIG:Release,MinSizeRel>:-O>"
        "$<$<CONFIG:Release,MinSizeRel>:--no-print>")
    if(GLIFT_RELOAD)
        glift_write_watch_file(${out}/${first}.watch ${out}/${first}.reload ${by_type} ${arguments} ${sources})
    endif()
    set(stamp ${out}/${first}.stamp)
    add_custom_command(
        OUTPUT ${stamp}
        BYPRODUCTS ${headers} ${codes} ${spirv}
        COMMAND glift::gliftc -o ${out} --depfile ${out}/${first}.d --target=cpp --target=host
                ${by_type} ${arguments} ${sources}
        COMMAND ${CMAKE_COMMAND} -D DEPFILE=${out}/${first}.d -D STAMP=${stamp}
                -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/GliftDepfile.cmake
        DEPENDS ${sources} $<TARGET_FILE:glift::gliftc>
        DEPFILE ${out}/${first}.d
        COMMENT "Compiling ${arg_SOURCES}"
        VERBATIM COMMAND_EXPAND_LISTS)
    target_sources(${arg_TARGET} PRIVATE ${stamp} ${headers} ${codes})
    # No contraction of sums and products and no fast math, whatever the program's flags, so that the host device and the
    # GPU agree bit for bit; signed integers wrap around, as in the language. -fno-math-errno and -fno-trapping-math
    # change no value: they let the compiler vectorise, which GCC 12 does at -O3 only. Bindings only call the runtime: -O1
    # compiles them in half the time of -O2.
    set(flags -fno-fast-math -fno-finite-math-only -ffp-contract=off -fwrapv -fno-math-errno -fno-trapping-math)
    set(optimised "$<NOT:$<CONFIG:Debug>>")  # without a build type, too
    set_source_files_properties(${bindings} PROPERTIES COMPILE_OPTIONS "${flags};$<${optimised}:-O1>")
    set_source_files_properties(${kernels} PROPERTIES COMPILE_OPTIONS "${flags};$<${optimised}:-O3>")
    # A precompiled header of the target was compiled with other flags.
    set_source_files_properties(${codes} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    # Sources of one module define the same internal names (the structs of kernels' parameters), so that they cannot be
    # compiled as one.
    set_source_files_properties(${codes} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    # The folder from which sources embed SPIR-V files. ninja compiles in the build's root; a relative path lets
    # compiler caches serve several builds.
    set(folder ${out})
    if(CMAKE_GENERATOR MATCHES Ninja)
        cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${CMAKE_BINARY_DIR})
    endif()
    foreach(reader compiler assembler)  # both read escapes
        string(REPLACE "\\" "\\\\" folder "${folder}")
        string(REPLACE "\"" "\\\"" folder "${folder}")
    endforeach()
    set_source_files_properties(${codes} PROPERTIES COMPILE_DEFINITIONS "GLIFT_SPIRV_FOLDER=\"${folder}\"")

    set_property(TARGET ${arg_TARGET} APPEND PROPERTY INCLUDE_DIRECTORIES ${include_dirs})
    set_property(TARGET ${arg_TARGET} APPEND PROPERTY INTERFACE_INCLUDE_DIRECTORIES
        "$<BUILD_INTERFACE:${include_dirs}>")
    target_include_directories(${arg_TARGET} PUBLIC $<BUILD_INTERFACE:${out}>)
    target_link_libraries(${arg_TARGET} PUBLIC glift::runtime)
endfunction()
