# Packages for the runtime, the compiler, the tests and the benches; all are in Debian 12 (tools/setup installs them).
# glslangValidator, X11 and the libraries of the examples are found in the CMakeLists.txt of the folder that needs them.

# Before glslang and SPIRV-Tools, whose packages refer to the target Threads::Threads.
find_package(Threads REQUIRED)
# Dependencies of the runtime.
find_package(Vulkan REQUIRED)
find_package(TBB CONFIG REQUIRED)
# Of the compiler and the benches; before SPIRV-Tools-link, whose package refers to its target.
if(NOT GLIFT_GLIFTC OR GLIFT_BUILD_BENCH)
    find_package(SPIRV-Tools-opt CONFIG REQUIRED)
endif()
# Dependencies of the compiler, not needed if GLIFT_GLIFTC names a gliftc that is built already. The benches need some
# of them, too.
if(NOT GLIFT_GLIFTC)
    find_package(SPIRV-Tools-link CONFIG REQUIRED)
    find_package(glslang CONFIG REQUIRED)
    find_package(fmt CONFIG REQUIRED)
endif()
if(NOT GLIFT_GLIFTC OR GLIFT_BUILD_BENCH)
    find_package(CLI11 CONFIG REQUIRED)
    find_package(nlohmann_json CONFIG REQUIRED)
endif()
# The library of files is built where all that it needs is found: HDF5 1.10.7 or newer (the serial one), xxHash, CLI11
# and nlohmann-json.
if(GLIFT_BUILD_FILES)
    find_package(HDF5 1.10.7 COMPONENTS C QUIET)
    find_package(CLI11 CONFIG QUIET)
    find_package(nlohmann_json CONFIG QUIET)
    find_library(GLIFT_XXHASH xxhash)
    find_path(GLIFT_XXHASH_INCLUDE xxhash.h)
    if(HDF5_FOUND AND CLI11_FOUND AND nlohmann_json_FOUND AND GLIFT_XXHASH AND GLIFT_XXHASH_INCLUDE)
        set(GLIFT_HAS_FILES TRUE)
    endif()
endif()
if(GLIFT_BUILD_TESTS)
    find_package(GTest REQUIRED)
endif()
if(GLIFT_BUILD_BENCH)
    find_package(benchmark CONFIG REQUIRED)
endif()
if(GLIFT_BUILD_INTEROP AND NOT GLIFT_GLIFTC)
    # PATHS and NO_DEFAULT_PATH: where several LLVMs are installed, Clang of another version could be found otherwise.
    find_package(LLVM 14.0 REQUIRED CONFIG)
    find_package(Clang REQUIRED CONFIG PATHS ${LLVM_INSTALL_PREFIX}/lib/cmake/clang NO_DEFAULT_PATH)
endif()
