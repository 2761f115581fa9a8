// The options of the command line.
#pragma once

#include "diag/diagnostics.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gliftc {

enum class Command : std::uint8_t { compile, test, watch, explain, fmt, make_project, lsp };

/// What gliftc writes; each is one `--target=`.
enum class Target : std::uint8_t { glsl, spirv, cpp, host, json };

/// The stages that `--stop-after=` and `--dump=` name.
enum class Stage : std::uint8_t { syntax, sema, lower, layout };

enum class DiagnosticsFormat : std::uint8_t { text, json };
enum class ColourChoice : std::uint8_t { automatic, always, never };

struct Options {
    Command command = Command::compile;
    std::vector<std::string> files;  ///< "-" is standard input
    std::string output_folder = ".";
    std::vector<std::string> import_folders;
    std::string library_folder;  ///< of the standard library; empty: beside the executable
    std::vector<std::pair<std::string, std::string>> defines;
    std::vector<Target> targets;  ///< empty: all, but with host_only not spirv
    std::optional<Stage> stop_after, dump;
    std::string stop_after_pass, dump_after;  ///< names of passes (lower/passes.h); empty: none
    bool check_only = false;                  ///< --check: report, write nothing (fmt: say what is not formatted)
    bool checked = false;                     ///< --checked: generated code reports accesses out of range
    bool messages = true;                     ///< --no-print: `print` and `assert` make no code
    bool optimize = false;                    ///< -O: SPIR-V through spirv-opt
    std::uint32_t address_bits = 32;          ///< --address-bits: of physical addresses in kernels, 32 or 64
    bool host_only = false;                   ///< --host-only: C++ without SPIR-V inside
    std::uint32_t shards = 1;                 ///< --shards: sources for the kernels of a module, and as many for those
                                              ///< that it uses of other modules
    bool spirv_files = false;                 ///< --spirv-files: generated C++ embeds SPIR-V from files in the folder
                                              ///< that its macro GLIFT_SPIRV_FOLDER names
    bool reload = false;                      ///< --reload: functions run newer code that `gliftc watch` makes
    bool source_lines = false;                ///< -g: #line in generated C++, so that debuggers show the .glift file
    bool list_outputs = false;
    bool time_report = false;
    std::string depfile;          ///< --depfile, -MF: the path of the Makefile rule; empty: not given
    bool writes_depfile = false;  ///< -MD: write the rule beside the outputs (NAME.glift.d), even if --target is given
    std::string style;            ///< --style, of generated C++: a .clang-format file or a name; empty: as printed
    DiagnosticsFormat diagnostics_format = DiagnosticsFormat::text;
    ColourChoice colour = ColourChoice::automatic;
    bool warnings_are_errors = false;
    std::vector<Diag> silenced, promoted;
    std::size_t error_limit = 50;
    std::string device;                ///< test: which device to compare with the host; empty: as Device::open chooses
    std::string test_filter;           ///< test: only tests with this in their title
    bool validate = true;              ///< test: with Vulkan's validation layer
    std::uint32_t test_timeout = 600;  ///< test: seconds that one test may take; 0: no limit
    bool list_tests = false;           ///< test: print titles, run nothing
    std::string project;               ///< new: the folder to make; its last part is the project's name
    bool explain_as_json = false;
    std::vector<std::string> explain_made;  ///< --made: structures with arguments; prints the sizes of their memories

    bool wants(Target target) const {
        for (Target each : targets)
            if (each == target) return true;
        return targets.empty() && !(host_only && target == Target::spirv);
    }
    bool stops_after(Stage stage) const { return stop_after && *stop_after <= stage; }
};

}  // namespace gliftc
