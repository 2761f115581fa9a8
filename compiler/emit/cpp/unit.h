// What the parts of the C++ printer share for one module.
#pragma once

#include "emit/cpp/emit.h"
#include "emit/cpp/printer.h"

#include <map>
#include <optional>
#include <set>

namespace gliftc::cpp {

/// What a module's C++ contains of the program.
struct Reach {
    std::set<ir::KernelId> kernels;
    std::set<ir::PipelineId> pipelines;
    std::set<ir::EnumId> enums;
    /// The kernels and pipelines that may be called on the host device, and on Vulkan devices. Others have no code for
    /// that kind of device.
    std::set<ir::KernelId> host_kernels, vulkan_kernels;
    std::set<ir::PipelineId> host_pipelines, vulkan_pipelines;
    std::vector<ir::StructId> structs;        ///< types of fields come first
    std::vector<ir::StructureId> structures;  ///< members, and what the signatures of its pipelines name, come first
    std::set<ir::StructureId> in_header;      ///< structures whose classes the public header has
    std::set<ir::StructureId> moved;          ///< structures of which boxes may be copied to or from the host
    std::set<ir::KernelId> pub_kernels;       ///< kernels that the public header declares
};

Reach reach_of(const ir::Program& program, ir::ModuleId module, const Options& options);
/// Adds the structs, enums and structures that the lowered code of the kernels for the host device uses.
void add_inner_structs(Reach& reach, const ir::Program& program, const ir::Lowered& lowered);

/// How a test program checks the translation of one structure.
struct TranslationCheck {
    ir::StructureId structure;
    std::string title;
    std::string of_one;  ///< the function that checks a structure already made; empty: this structure is not checked
    /// The function that makes structures of several extents and checks each by `of_one`; empty: only structures that
    /// tests make are checked.
    std::string of_extents;
    std::string why_not_alone;  ///< if `of_extents` is empty: the reason, for the user
};

class SpirvFile;

/// What the printers of a module's code get.
struct ModuleParts {
    const ir::Program& program;
    const ir::Lowered& lowered;
    const Sources& sources;
    ir::ModuleId module;
    const KernelCodes& code;
    const Options& options;
    const Reach& reach;
    const ProgramNames& names;
};

/// The code in one namespace that is made for a module. The namespace is the module's own, or that of another module
/// that it uses. Another module's namespace gets only what the module uses and what neither a header that the module
/// includes nor an earlier source of this run defines: mostly instances of generics, and what it uses of modules that
/// this run makes no files for.
struct Unit {
    const ir::Program& program;
    const ir::Lowered& lowered;
    const Sources& sources;
    ir::ModuleId module;  ///< the one that code is made for
    ir::ModuleId home;    ///< the one whose namespace it is
    const KernelCodes& code;
    const Options& options;
    const Reach& reach;
    const ProgramNames& own;  ///< names without their namespaces
    Globals globals;
    std::string tests;                                   ///< name of the table of tests; empty: there is none
    std::vector<TranslationCheck> translation_checks{};  ///< in a test program
    /// In a test program: the functions that give the addresses in the blocks of structures.
    std::map<ir::StructureId, std::string> block_lists{};
    std::vector<TestName> test_names{};     ///< in a test program
    std::set<std::string> reloadable{};     ///< Options::reload: names of the objects that know the newest code
    const SpirvFile* spirv_file = nullptr;  ///< of the printed source; null: the source has the SPIR-V

    std::string name(Name n) const { return (*program.names)[n]; }
    std::string type(ir::TypeId id, bool qualified = false) const { return type_text(globals, id, qualified); }
    const std::string& class_name(ir::StructureId structure) const { return globals.structure_names[structure]; }
    /// The class's name without its namespace: as the class itself and the definitions of its members spell it.
    const std::string& own_name(ir::StructureId structure) const { return own.structures[structure]; }
    /// What stands before the definition of what has this key (ir::Kernel::key and so on): GLIFT_SHARED (a weak symbol)
    /// if another module's code may define it, too, so that the linker takes one; else nothing.
    const char* linkage(const std::string& key) const;
};

Unit make_unit(const ModuleParts& parts, ir::ModuleId home);

/// What `print` makes of each kernel. Those that add functions to the file are printed first, one after the other, so
/// that the functions have a fixed order. The others change nothing that they share, and are printed in parallel.
std::vector<std::string> printed_kernels(Unit& unit, const std::vector<ir::KernelId>& kernels,
                                         bool (&adds_functions)(const Unit&, ir::KernelId),
                                         std::string (&print)(Unit&, ir::KernelId));

/// The comment with which each generated C++ file begins.
std::string begin_of_file(const std::string& stem);

/// The structure to which the path of members in `place` leads from `root_structure`.
ir::StructureId structure_at(const ir::Program& program, ir::StructureId root_structure, const ir::Place& place);

// structures.cpp
void print_class(Unit& unit, Writer& out, ir::StructureId structure);
void print_class_members(Unit& unit, Writer& out, ir::StructureId structure);

// transfers.cpp
/// The functions that move boxes of the structure between host and device, fill it, and list the resident elements:
/// each only if the program has a kernel for it (ir::Program::transfers).
void print_transfers(Unit& unit, Writer& out, ir::StructureId structure);
/// In the class: the declaration of the function that lists the resident elements; nothing for views, and for
/// structures without blocks all of whose translators are total and one-to-one (ir::has_resident_part).
void print_list_declaration(const Unit& unit, Writer& out, ir::StructureId structure);

// descriptions.cpp
/// The function `describe` of a class, which names its parts.
void print_description(const Unit& unit, Writer& out, ir::StructureId structure);
/// The function `visit_state` of a class, which hands what the structure consists of to a program that stores it, and
/// the type `Arguments`.
void print_state_visit(const Unit& unit, Writer& out, ir::StructureId structure);
/// The function `describe` of a struct; nothing if it has no fields.
void print_description(const Unit& unit, Writer& out, const std::vector<ir::StructField>& fields,
                       const std::vector<std::string>& names);

// state_key.cpp
/// Equal for structures whose states mean the same, whatever their elements and the layout of these.
std::uint64_t state_key(const Unit& unit, ir::StructureId structure);

// structs.cpp
void print_struct(const Unit& unit, Writer& out, ir::StructId id);
void print_enum(const Unit& unit, Writer& out, ir::EnumId id);

// kernel_code.cpp
std::string kernel_code(Unit& unit, ir::KernelId kernel);
/// Whether the kernel's code will add functions to those that the file shares (Globals::functions).
bool code_adds_functions(const Unit& unit, ir::KernelId kernel);

// drawing.cpp
/// The constant `<name>_drawing` of a kernel that draws: its targets and fixed state (glift::Drawing).
void print_drawing(const Unit& unit, Writer& out, const ir::Kernel& kernel, const std::string& name,
                   bool derives_loads);
/// The statements that pass the arguments of a call to the glift::DrawIteration `iteration`.
void print_draw_arguments(const Unit& unit, Writer& out, const ir::Kernel& kernel);

// kernel_sources.cpp
/// Sources of the kernels' code, `<stem>.glift.<part>.cpp` and so on, and with Options::spirv_files a file of SPIR-V
/// for each.
std::vector<File> kernel_sources(const ModuleParts& parts, const std::string& stem,
                                 const std::vector<ir::KernelId>& kernels, const std::string& part);

// kernel_calls.cpp
/// The head of the function that calls a kernel, with the kernel's parameters from number `first` on.
std::string kernel_signature(Unit& unit, ir::KernelId kernel, bool qualified, std::size_t first = 0);
std::string kernel_function(Unit& unit, ir::KernelId kernel);
/// Whether kernel_function will add functions to those that the file shares (Globals::functions).
bool function_adds_functions(const Unit& unit, ir::KernelId kernel);
/// A kernel whose first parameter is `at` may be called without it. Returns the number of the parameter whose range it
/// then takes (ir::range_giver); none: the first parameter is not `at`, or no parameter has such a range.
std::optional<std::size_t> range_of_first_at(const ir::Kernel& kernel);
/// The function that calls a kernel without its first parameter, which is `at`; empty: range_of_first_at() gives none.
std::string short_kernel_function(Unit& unit, ir::KernelId kernel);

// pipelines.cpp
std::string pipeline_signature(Unit& unit, ir::PipelineId pipeline, bool qualified);
void print_pipeline(Unit& unit, Writer& out, ir::PipelineId pipeline);

// translation_checks.cpp
/// Prints the functions that check translators. The result has an entry for each stored structure with translators that
/// the module's C++ contains. For each structure with translators that the module declares but its C++ does not
/// contain, the result has an entry that only says why the structure is not checked.
std::vector<TranslationCheck> print_translation_checks(Unit& unit, Writer& out);
/// Prints the functions that give the addresses in the blocks of structures, where the host can evaluate these.
std::map<ir::StructureId, std::string> print_block_lists(Unit& unit, Writer& out);

// tests.cpp
/// One letter for each scalar of a type, and a '.' for each byte of padding, as glift::KeptStructure has them.
std::string scalars_of(const ir::Program& program, ir::TypeId type);
/// The same for a structure's elements, but with `n` for floats in eight-bit formats if some kernel draws to the
/// structure: devices round colours differently.
std::string kept_scalars(const ir::Program& program, ir::StructureId structure);
/// The table `tests` of the module's tests and checks; nothing if it has none.
void print_tests(Unit& unit, Writer& out);

/// Reserves the names of the variables that the functions which call kernels have.
void reserve_locals_of_calls(Scopes&);

}  // namespace gliftc::cpp
