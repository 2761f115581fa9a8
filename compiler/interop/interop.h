// What gliftc uses clang for: import of C++ structs, and formatting of generated code in the user's style.
//
// Implemented in libglift_clang.so (interop/clang/), which is opened at the first call: a gliftc linked with libLLVM
// would take 15 ms longer to start, and most runs need neither function.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gliftc {

/// The scalar type of an imported field; Struct: the field is a struct, ImportedType::record.
enum class ImportedScalar : std::uint8_t { Bool, Int, Uint, Float, Half, Double, Int64, Uint64, Struct };

struct ImportedType {
    ImportedScalar scalar = ImportedScalar::Float;
    std::uint32_t components = 1;              ///< of a vector, 2 to 4; else 1
    std::uint32_t record = 0;                  ///< Struct: an index into ImportResult::structs
    std::vector<std::uint64_t> array_extents;  ///< outermost first; empty if the field is no array
};

struct ImportedField {
    std::string name;
    ImportedType type;
    std::uint64_t offset = 0;  ///< bytes
    std::uint32_t line = 0;    ///< line of the field in its header
};

struct ImportedStruct {
    std::string name;  ///< as C++ writes it from the global namespace, "sim::Particle"
    std::vector<ImportedField> fields;
    std::uint64_t size = 0;   ///< bytes
    std::uint64_t align = 0;  ///< bytes
};

struct ImportRequest {
    std::string header;                     ///< path of the header
    std::vector<std::string> include_dirs;  ///< the folders in which the header's own includes are looked for
    std::string name;                       ///< "Particle" or "sim::Particle"
};

/// The structs, or an error with its location in the C++ header.
struct ImportResult {
    std::vector<ImportedStruct> structs;  ///< each after those that it contains, so that the requested one is the last
    std::vector<std::string> read_files;  ///< the headers read, system headers left out: for the depfile and the cache
                                          ///< of `gliftc test`
    std::string error;                    ///< empty: done
    std::string error_file;               ///< empty if the error has no location
    std::uint32_t error_line = 0;         ///< 0 if unknown
};

/// Parses the header with clang as C++20 and lays the struct out as the C++ compiler does on this machine.
ImportResult import_struct(const ImportRequest& request);

struct FormatResult {
    std::string text;
    std::string error;  ///< empty: done
};

/// Formats C++. `style` is the path of a .clang-format file, or a name clang-format knows (LLVM, Google, …).
FormatResult format_code(std::string_view text, std::string_view style);

}  // namespace gliftc
