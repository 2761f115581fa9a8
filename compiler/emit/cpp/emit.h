// C++ for one module: what a program includes, and what it links.
#pragma once

#include "ir/pass.h"
#include "source/source.h"

#include <set>
#include <string>
#include <vector>

namespace gliftc::cpp {

/// The SPIR-V words of one form of a kernel.
struct FormCode {
    std::vector<std::uint32_t> shader;    ///< of a draw, the vertex shader; empty if no output needs it
    std::vector<std::uint32_t> fragment;  ///< the fragment shader of a draw that has one; else empty
    bool operator==(const FormCode&) const = default;
};

struct KernelCode {
    FormCode direct, general;
};

/// The code of all kernels of a program; empty if no Vulkan code is wanted.
using KernelCodes = Table<KernelCode, ir::Kernel>;

struct Globals;

struct Options {
    /// There are this many sources for the code of the module's own kernels, and as many more for that of the kernels
    /// of other modules that it uses. Where there are few kernels, the last ones are empty.
    std::uint32_t shards = 1;
    bool spirv_files = false;  ///< SPIR-V in files beside the sources, else within
    bool reload = false;       ///< functions run newer code that the program has loaded (glift/reload.h)
    bool tests = false;        ///< a test program: also tests, checks of translators, a table of them, main
    /// Prints `static void <name>(const glift::HostCall& call)` for a pass: kernel_of of emit/cpp/host, or null if no
    /// code for the host device is wanted.
    std::string (*host_kernel)(Globals& globals, const ir::Pass& pass, const std::string& name) = nullptr;
};

/// A test of the module, or the check of a structure's translators (TranslationCheck).
struct TestName {
    std::string title, place;  ///< `place`: where the test or the structure is declared, as in "grid.glift:8"
};

struct File {
    std::string name;  ///< what follows file_stem in the file's name: `.glift.hpp`
    std::string text;
    bool is_code = true;  ///< C++, else bytes
};

/// C++ for one module (module.cpp lists the files).
struct Module {
    std::vector<File> files;
    std::vector<TestName> tests;  ///< of a test program: what its table lists; else empty
};

/// What the code of modules that were printed earlier in the same run defines: later modules
/// do not define it again.
struct Defined {
    std::set<ir::KernelId> kernels;
    std::set<ir::PipelineId> pipelines;
    std::set<ir::StructureId> structures;
    std::set<ir::StructureId> moved;  ///< structures whose functions for copying boxes to or from the host are defined
};

/// The kernels whose Vulkan code the module's C++ contains: it needs no SPIR-V of the others.
std::vector<ir::KernelId> vulkan_kernels_of(const ir::Program& program, ir::ModuleId module, const Options& options,
                                            const Defined& defined);

/// The stem of the names of the module's output files: the name of its source file without the extension; for standard
/// input, the last part of the module's name.
std::string file_stem(const ir::Program& program, const Sources& sources, ir::ModuleId module);

/// Prints one module. Adds to `defined` what the module's code defines, unless it is a test program.
Module module_of(const ir::Program& program, const ir::Lowered& lowered, const Sources& sources, ir::ModuleId module,
                 const KernelCodes& code, const Options& options, Defined& defined);

}  // namespace gliftc::cpp
