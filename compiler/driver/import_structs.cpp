#include "driver/import_structs.h"

#include "interop/interop.h"

#include <algorithm>
#include <filesystem>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

std::string_view scalar_name(ImportedScalar scalar) {
    switch (scalar) {
    case ImportedScalar::Bool: return "bool";
    case ImportedScalar::Int: return "int";
    case ImportedScalar::Uint: return "uint";
    case ImportedScalar::Float: return "float";
    case ImportedScalar::Half: return "half";
    case ImportedScalar::Double: return "double";
    case ImportedScalar::Int64: return "int64";
    case ImportedScalar::Uint64: return "uint64";
    case ImportedScalar::Struct: break;
    }
    return "";
}

/// "Spin" of "sim::Spin".
std::string last_part(const std::string& name) {
    std::size_t colon = name.rfind(':');
    return colon == std::string::npos ? name : name.substr(colon + 1);
}

/// Size and alignment in shaders, in bytes.
struct Size {
    std::uint64_t bytes = 0, align = 1;
};

Size size_of(const ImportResult& imported, const ImportedType& type);

/// The size is that of C++, with the padding at the end. The alignment is the largest of the fields', as in shaders.
Size size_of(const ImportResult& imported, const ImportedStruct& record) {
    Size size{record.size, 1};
    for (const ImportedField& field : record.fields)
        size.align = std::max(size.align, size_of(imported, field.type).align);
    return size;
}

Size size_of(const ImportResult& imported, const ImportedType& type) {
    const bool is_long = type.scalar == ImportedScalar::Double || type.scalar == ImportedScalar::Int64 ||
                         type.scalar == ImportedScalar::Uint64;
    const std::uint64_t scalar = type.scalar == ImportedScalar::Half ? 2 : is_long ? 8 : 4;
    Size size{scalar * type.components, scalar};
    if (type.scalar == ImportedScalar::Struct) size = size_of(imported, imported.structs[type.record]);
    for (std::uint64_t extent : type.array_extents) size.bytes *= extent;
    return size;
}

/// Why shaders cannot use the layout that C++ gives the struct; empty if they can. In shaders each field begins at the
/// next multiple of the size of its largest scalar, and a bool has four bytes.
std::string misfit_of(const ImportResult& imported, const ImportedStruct& record) {
    std::uint64_t end = 0;
    for (const ImportedField& field : record.fields) {
        const Size size = size_of(imported, field.type);
        const std::uint64_t place = (end + size.align - 1) / size.align * size.align;
        const std::string at = "line " + std::to_string(field.line) + ": '" + field.name + "' ";
        if (field.type.scalar == ImportedScalar::Bool)
            return at + "is a bool, of one byte in C++ and four in shaders: make it a uint";
        if (place != field.offset)
            return at + "lies at byte " + std::to_string(field.offset) + ", for shaders at byte " +
                   std::to_string(place) + ": declare what lies between as fields";
        end = place + size.bytes;
    }
    return {};
}

class Importer {
public:
    Importer(const Options& options, const FileSystem& files, Compilation& c)
        : options_(options), files_(files), c_(c) {}

    void complete(ast::Module& module) {
        // Only declarations that are in the source: import() appends others, which are complete already.
        std::size_t written = module.decls.size();
        for (std::size_t i = 0; i < written; ++i) {
            const auto* record = std::get_if<ast::Struct>(&c_.tree.decls[module.decls[i]].body);
            if (record && !record->extern_header.empty()) import(module, module.decls[i]);
        }
        for (const NestedUse& use : nested_uses_) check(module, use);
        nested_uses_.clear();
    }

private:
    /// A struct that a field of an imported struct has as its type.
    struct NestedUse {
        std::string qualified;  ///< its name in C++
        ast::DeclId outer;
    };

    void import(ast::Module& module, ast::DeclId id) {
        const ast::Decl decl = c_.tree.decls[id];
        const auto& record = std::get<ast::Struct>(decl.body);
        ImportRequest request;
        request.name = c_.names[decl.name.name];
        request.include_dirs = options_.import_folders;
        request.header = find_header(record.extern_header, module.file);
        if (request.header.empty())
            return fail(record, request.name, "there is no such file beside this one or in a folder given by -I");
        ImportResult imported = import_struct(request);
        if (!imported.error.empty()) {
            std::string place = imported.error_file;
            if (imported.error_line) place += ":" + std::to_string(imported.error_line);
            return fail(record, request.name, (place.empty() ? "" : place + ": ") + imported.error);
        }
        c_.read_files.insert(c_.read_files.end(), imported.read_files.begin(), imported.read_files.end());
        for (const ImportedStruct& one : imported.structs)
            if (const std::string misfit = misfit_of(imported, one); !misfit.empty())
                return fail(record, request.name, misfit);
        for (std::size_t i = 0; i + 1 < imported.structs.size(); ++i) {
            nested_uses_.push_back({imported.structs[i].name, id});
            add_nested(module, decl, imported, i);
        }
        fill(std::get<ast::Struct>(c_.tree.decls[id].body), decl.name.span, imported, imported.structs.size() - 1);
    }

    /// Reports a nested struct if the last part of its C++ name means something else in the module.
    void check(const ast::Module& module, const NestedUse& use) {
        const auto is_it = [&](ast::DeclId id) {
            return c_.names[c_.tree.decls[id].name.name] == last_part(use.qualified);
        };
        const auto found = std::ranges::find_if(module.decls, is_it);
        const auto* declared = std::get_if<ast::Struct>(&c_.tree.decls[*found].body);
        if (declared && declared->extern_name == use.qualified) return;
        const std::string name = last_part(use.qualified);
        const bool is_imported = declared && !declared->extern_name.empty();
        const ast::Decl& outer = c_.tree.decls[use.outer];
        fail(std::get<ast::Struct>(outer.body), c_.names[outer.name.name],
             "it holds a '" + use.qualified + "', but '" + name + "' is " +
                 (is_imported ? "'" + declared->extern_name + "'" : "something else") +
                 " in this module: rename one of them");
    }

    void fail(const ast::Struct& record, const std::string& name, const std::string& why) {
        c_.diagnostics.report(Diag::cannot_import, record.extern_span, {name, record.extern_header, why});
    }

    std::string find_header(const std::string& header, std::uint32_t file) const {
        std::vector<fs::path> folders{fs::path(c_.sources[file].path).parent_path()};
        folders.insert(folders.end(), options_.import_folders.begin(), options_.import_folders.end());
        for (const fs::path& folder : folders) {
            std::string path = (folder / header).lexically_normal().generic_string();
            if (files_.exists(path)) return path;
        }
        return {};
    }

    /// Declares the struct that is the type of an imported struct's field, unless the module declares that name
    /// already.
    void add_nested(ast::Module& module, const ast::Decl& outer, const ImportResult& imported, std::size_t index) {
        Name name = c_.names.intern(last_part(imported.structs[index].name));
        for (ast::DeclId other : module.decls)
            if (c_.tree.decls[other].name.name == name) return;
        ast::Decl nested;
        nested.name = {name, outer.name.span};
        nested.span = outer.span;
        nested.is_pub = outer.is_pub;
        nested.is_extern = true;
        ast::Struct record;
        record.extern_header = std::get<ast::Struct>(outer.body).extern_header;
        record.extern_span = std::get<ast::Struct>(outer.body).extern_span;
        fill(record, outer.name.span, imported, index);
        nested.body = std::move(record);
        module.decls.push_back(c_.tree.decls.add(std::move(nested)));
    }

    void fill(ast::Struct& record, Span span, const ImportResult& imported, std::size_t index) {
        const ImportedStruct& from = imported.structs[index];
        record.extern_name = from.name;
        record.size = static_cast<std::uint32_t>(from.size);
        record.fields.clear();
        record.offsets.clear();
        for (const ImportedField& field : from.fields) {
            ast::Field made;
            made.name = {c_.names.intern(field.name), span};
            made.type = type_of(field.type, span, imported);
            record.fields.push_back(std::move(made));
            record.offsets.push_back(static_cast<std::uint32_t>(field.offset));
        }
    }

    ast::ExprId type_of(const ImportedType& type, Span span, const ImportResult& imported) {
        bool is_struct = type.scalar == ImportedScalar::Struct;
        std::string name =
            is_struct ? last_part(imported.structs[type.record].name) : std::string(scalar_name(type.scalar));
        if (type.components > 1) name += std::to_string(type.components);
        ast::Expr element;
        element.kind = ast::ExprKind::name;
        element.span = span;
        element.name = c_.names.intern(name);
        ast::ExprId made = c_.tree.exprs.add(std::move(element));
        for (auto extent = type.array_extents.rbegin(); extent != type.array_extents.rend(); ++extent) {
            ast::Expr count;
            count.kind = ast::ExprKind::int_literal;
            count.span = span;
            count.value = *extent;
            ast::Expr array;
            array.kind = ast::ExprKind::index;
            array.span = span;
            array.operands = {made, c_.tree.exprs.add(std::move(count))};
            made = c_.tree.exprs.add(std::move(array));
        }
        return made;
    }

    const Options& options_;
    const FileSystem& files_;
    Compilation& c_;
    std::vector<NestedUse> nested_uses_;  ///< of the module being completed
};

}  // namespace

void import_structs(const Options& options, const FileSystem& files, Compilation& compilation) {
    Importer importer(options, files, compilation);
    for (ast::Module& module : compilation.loaded.trees) importer.complete(module);
}

}  // namespace gliftc
