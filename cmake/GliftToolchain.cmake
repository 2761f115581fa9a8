# Language level, build type, warnings, linker, compiler cache, fuzzer and sanitizers of this project's own targets.
# These settings have directory scope, and the build type is set only if this is the top project: one that adds Glift as
# a subdirectory keeps its own.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
# The flags of a test that has its own definitions may not match the shared precompiled header; the test is then
# compiled without that header.
set(CMAKE_PCH_WARN_INVALID OFF)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)
endif()
if(PROJECT_IS_TOP_LEVEL)
    # -g1: line numbers for back traces, which programs pay no time for.
    set(CMAKE_CXX_FLAGS_RELEASE "-O2 -g1 -DNDEBUG")
    set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1")
endif()

# A switch over an enum that misses a value and has no `default:` is an error in every build: most switches over kinds
# of nodes have none, so that a new kind cannot be forgotten.
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-Wall> $<$<COMPILE_LANGUAGE:CXX>:-Wextra> $<$<COMPILE_LANGUAGE:CXX>:-Wno-missing-field-initializers>
                    $<$<COMPILE_LANGUAGE:CXX>:-Werror=switch>)
if(GLIFT_WERROR)
    add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()

find_program(GLIFT_LLD ld.lld)
if(GLIFT_LLD)
    add_link_options(-fuse-ld=lld)
endif()

find_program(GLIFT_CCACHE ccache)
if(GLIFT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # These sloppiness settings let ccache store compilations that use a precompiled header. NOHASHDIR and BASEDIR let
    # checkouts in different folders share their compilations.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_NOHASHDIR=1 CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${GLIFT_CCACHE})
    set(CMAKE_C_COMPILER_LAUNCHER ${GLIFT_CCACHE})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
    endif()
endif()

if(GLIFT_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(GLIFT_SANITIZE OR GLIFT_FUZZ)
    # Without the check vptr: it needs typeinfo, which glslang (built with -fno-rtti) lacks.
    set(GLIFT_SANITIZER_FLAGS -fsanitize=address,undefined -fno-sanitize=vptr -fno-sanitize-recover=all
        -fno-omit-frame-pointer)
    add_compile_options(${GLIFT_SANITIZER_FLAGS})
    add_link_options(${GLIFT_SANITIZER_FLAGS})
endif()
