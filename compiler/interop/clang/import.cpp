// Implements import_struct: parses a C++ header with clang and reads a struct's fields and layout from the AST.

#include "interop/plugin.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/RecordLayout.h>
#include <clang/Basic/Diagnostic.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Frontend/ASTUnit.h>
#include <clang/Tooling/Tooling.h>
#include <llvm/Support/FileSystem.h>

#include <map>
#include <optional>
#include <set>

namespace gliftc {
namespace {

using namespace clang;

/// Keeps the first error of the parse, with its location.
class FirstError final : public DiagnosticConsumer {
public:
    explicit FirstError(ImportResult& result) : result_(result) {}

    void HandleDiagnostic(DiagnosticsEngine::Level level, const clang::Diagnostic& info) override {
        DiagnosticConsumer::HandleDiagnostic(level, info);
        if (level < DiagnosticsEngine::Error || !result_.error.empty()) return;
        llvm::SmallString<128> text;
        info.FormatDiagnostic(text);
        result_.error = text.str().str();
        if (!info.hasSourceManager() || !info.getLocation().isValid()) return;
        const PresumedLoc place = info.getSourceManager().getPresumedLoc(info.getLocation());
        result_.error_file = place.getFilename();
        result_.error_line = place.getLine();
    }

private:
    ImportResult& result_;
};

struct NamedVector {
    ImportedScalar scalar;
    std::uint32_t components;
};

/// The vector type that a C++ name means, in whatever namespace it is declared: float2 or half4, which the runtime
/// declares, too, or int64_2 or uint64_4, which it does not. import_record() checks the size.
std::optional<NamedVector> vector_named(llvm::StringRef name) {
    static const std::pair<llvm::StringRef, ImportedScalar> stems[] = {
        {"float", ImportedScalar::Float},  {"int", ImportedScalar::Int},        {"uint", ImportedScalar::Uint},
        {"half", ImportedScalar::Half},    {"double", ImportedScalar::Double},  {"bool", ImportedScalar::Bool},
        {"int64_", ImportedScalar::Int64}, {"uint64_", ImportedScalar::Uint64},
    };
    if (name.empty() || name.back() < '2' || name.back() > '4') return std::nullopt;
    for (const auto& [stem, scalar] : stems) {
        if (name.drop_back() == stem) return NamedVector{scalar, static_cast<std::uint32_t>(name.back() - '0')};
    }
    return std::nullopt;
}

std::uint64_t scalar_bits(ImportedScalar scalar) {
    switch (scalar) {
    case ImportedScalar::Bool: return 8;
    case ImportedScalar::Half: return 16;
    case ImportedScalar::Int:
    case ImportedScalar::Uint:
    case ImportedScalar::Float: return 32;
    case ImportedScalar::Double:
    case ImportedScalar::Int64:
    case ImportedScalar::Uint64: return 64;
    case ImportedScalar::Struct: return 0;
    }
    return 0;
}

class Importer {
public:
    Importer(ASTContext& context, ImportResult& result) : context_(context), result_(result) {}

    /// Appends the struct, after those that it contains, and returns its index; none after an error.
    std::optional<std::uint32_t> import(const CXXRecordDecl& record) {
        if (const auto known = indices_.find(&record); known != indices_.end()) return known->second;
        if (!check(record)) return std::nullopt;
        ImportedStruct out;
        out.name = record.getQualifiedNameAsString();
        const ASTRecordLayout& layout = context_.getASTRecordLayout(&record);
        out.size = static_cast<std::uint64_t>(layout.getSize().getQuantity());
        out.align = static_cast<std::uint64_t>(layout.getAlignment().getQuantity());
        for (const FieldDecl* field : record.fields()) {
            ImportedField member;
            member.name = field->getNameAsString();
            member.line = line_of(field->getLocation());
            member.offset = layout.getFieldOffset(field->getFieldIndex()) / 8;
            if (!check(*field) || !import_type(field->getType(), *field, member.type)) return std::nullopt;
            out.fields.push_back(std::move(member));
        }
        const auto index = static_cast<std::uint32_t>(result_.structs.size());
        result_.structs.push_back(std::move(out));
        indices_.emplace(&record, index);
        return index;
    }

    void fail(SourceLocation location, std::string text) {
        if (!result_.error.empty()) return;
        result_.error = std::move(text);
        const PresumedLoc place = context_.getSourceManager().getPresumedLoc(location);
        if (place.isInvalid()) return;
        result_.error_file = place.getFilename();
        result_.error_line = place.getLine();
    }

private:
    std::uint32_t line_of(SourceLocation location) {
        return context_.getSourceManager().getPresumedLoc(location).getLine();
    }

    /// Whether the struct can be imported: it is no union and no instance of a template, has no base class and no
    /// virtual functions, and is trivially copyable. Reports an error if it cannot. Fields are checked one by one
    /// elsewhere: check(field), import_type().
    bool check(const CXXRecordDecl& record) {
        const std::string name = "'" + record.getQualifiedNameAsString() + "'";
        if (!record.isStruct() && !record.isClass()) {
            fail(record.getLocation(), name + " is a union; only structs can be imported");
        } else if (isa<ClassTemplateSpecializationDecl>(record)) {
            fail(record.getLocation(), name + " is an instance of a template; make it a struct of its own");
        } else if (record.getNumBases() != 0) {
            fail(record.getLocation(), name + " has a base class; put its members into the struct");
        } else if (record.isDynamicClass()) {
            fail(record.getLocation(), name + " has virtual functions");
        } else if (!context_.getRecordType(&record).isTriviallyCopyableType(context_)) {
            fail(record.getLocation(), name + " is not trivially copyable");
        } else {
            return true;
        }
        return false;
    }

    bool check(const FieldDecl& field) {
        if (field.isBitField()) {
            fail(field.getLocation(), "the field '" + field.getNameAsString() + "' is a bit field");
        } else if (field.getNameAsString().empty()) {
            fail(field.getLocation(), "an anonymous struct or union cannot be imported; give it a name");
        } else if (field.getAccess() != AS_public && field.getAccess() != AS_none) {
            fail(field.getLocation(), "the field '" + field.getNameAsString() + "' is not public");
        } else {
            return true;
        }
        return false;
    }

    bool import_type(QualType type, const FieldDecl& field, ImportedType& out) {
        if (const auto* array = context_.getAsConstantArrayType(type)) {
            out.array_extents.push_back(array->getSize().getZExtValue());
            return import_type(array->getElementType(), field, out);
        }
        if (const auto* record = type->getAsCXXRecordDecl()) return import_record(*record, field, out);
        if (type->isEnumeralType()) type = type->castAs<EnumType>()->getDecl()->getIntegerType();
        if (const auto scalar = scalar_of(type)) {
            out.scalar = *scalar;
            return true;
        }
        return no_counterpart(type, field);
    }

    bool import_record(const CXXRecordDecl& record, const FieldDecl& field, ImportedType& out) {
        if (const auto* array = dyn_cast<ClassTemplateSpecializationDecl>(&record);
            array != nullptr && array->getName() == "array" && array->isInStdNamespace()) {
            const TemplateArgumentList& arguments = array->getTemplateArgs();
            out.array_extents.push_back(arguments[1].getAsIntegral().getZExtValue());
            return import_type(arguments[0].getAsType(), field, out);
        }
        if (record.getName() == "half" && context_.getTypeSize(context_.getRecordType(&record)) == 16) {
            out.scalar = ImportedScalar::Half;
            return true;
        }
        if (const auto vector = vector_of(record, field)) {
            const QualType type = context_.getRecordType(&record);
            if (context_.getTypeSize(type) != scalar_bits(vector->scalar) * vector->components) {
                fail(field.getLocation(), "'" + type.getAsString() + "' has the name of a vector but not its size");
                return false;
            }
            out.scalar = vector->scalar;
            out.components = vector->components;
            return true;
        }
        if (!record.hasDefinition() || context_.getSourceManager().isInSystemHeader(record.getLocation())) {
            return no_counterpart(context_.getRecordType(&record), field);
        }
        const auto index = import(*record.getDefinition());
        if (!index) return false;
        out.scalar = ImportedScalar::Struct;
        out.record = *index;
        return true;
    }

    /// The vector type that `record` stands for, if it stands for one. `record` is the type of the field or, if that is
    /// an array, of its elements. It is named float3 (or like another vector), or is an instance of a class template
    /// called vec whose arguments are a scalar type and a number of components, in either order; more may follow. If
    /// the field is no array, it is enough that its type is written as an alias with such a name.
    std::optional<NamedVector> vector_of(const CXXRecordDecl& record, const FieldDecl& field) const {
        if (const auto vector = vector_named(record.getName())) return vector;
        const auto* alias = field.getType()->getAs<TypedefType>();
        if (alias != nullptr && field.getType()->getAsCXXRecordDecl() == &record) {
            if (const auto vector = vector_named(alias->getDecl()->getName())) return vector;
        }
        const auto* vec = dyn_cast<ClassTemplateSpecializationDecl>(&record);
        if (vec == nullptr || vec->getName() != "vec") return std::nullopt;
        std::optional<ImportedScalar> scalar;
        std::uint64_t components = 0;
        for (const TemplateArgument& argument : vec->getTemplateArgs().asArray()) {
            if (argument.getKind() == TemplateArgument::Type && !scalar) scalar = scalar_of(argument.getAsType());
            if (argument.getKind() == TemplateArgument::Integral && components == 0)
                components = argument.getAsIntegral().getZExtValue();
        }
        if (!scalar || components < 2 || components > 4) return std::nullopt;
        return NamedVector{*scalar, static_cast<std::uint32_t>(components)};
    }

    std::optional<ImportedScalar> scalar_of(QualType type) const {
        const auto* builtin = type.getCanonicalType()->getAs<BuiltinType>();
        if (builtin == nullptr) return std::nullopt;
        if (builtin->getKind() == BuiltinType::Bool) return ImportedScalar::Bool;
        const std::uint64_t bits = context_.getTypeSize(type);
        if (builtin->isFloatingPoint()) {
            if (bits == 16) return ImportedScalar::Half;
            if (bits == 32) return ImportedScalar::Float;
            if (bits == 64) return ImportedScalar::Double;
            return std::nullopt;
        }
        if (builtin->isInteger() && bits == 32) {
            return builtin->isSignedInteger() ? ImportedScalar::Int : ImportedScalar::Uint;
        }
        if (builtin->isInteger() && bits == 64) {
            return builtin->isSignedInteger() ? ImportedScalar::Int64 : ImportedScalar::Uint64;
        }
        return std::nullopt;
    }

    bool no_counterpart(QualType type, const FieldDecl& field) {
        fail(field.getLocation(), "the field '" + field.getNameAsString() + "' has the type '" + type.getAsString() +
                                      "', which has no counterpart on the device");
        return false;
    }

    ASTContext& context_;
    ImportResult& result_;
    std::map<const CXXRecordDecl*, std::uint32_t> indices_;
};

/// The definitions that `name` may mean: the one with exactly this qualified name; else, if `name` has no `::`, those
/// with this name in any namespace. Definitions within classes and in system headers are not found.
std::vector<const CXXRecordDecl*> find_records(ASTContext& context, llvm::StringRef name) {
    std::vector<const CXXRecordDecl*> found;
    const auto search = [&](const auto& self, const DeclContext& scope) -> void {
        for (const Decl* decl : scope.decls()) {
            if (context.getSourceManager().isInSystemHeader(decl->getLocation())) continue;
            if (const auto* record = dyn_cast<CXXRecordDecl>(decl);
                record != nullptr && record->isThisDeclarationADefinition()) {
                const std::string qualified = record->getQualifiedNameAsString();
                if (qualified == name || (!name.contains("::") && record->getName() == name)) found.push_back(record);
            }
            if (const auto* inner = dyn_cast<NamespaceDecl>(decl)) self(self, *inner);
            if (const auto* linkage = dyn_cast<LinkageSpecDecl>(decl)) self(self, *linkage);
        }
    };
    search(search, *context.getTranslationUnitDecl());
    for (const CXXRecordDecl* record : found) {
        if (record->getQualifiedNameAsString() == name) return {record};
    }
    return found;
}

std::vector<std::string> arguments_of(const ImportRequest& request) {
    std::vector<std::string> arguments = {"-std=c++20", "-fsyntax-only", "-Wno-everything"};
    if (llvm::sys::fs::exists(GLIFT_CLANG_RESOURCES)) {
        arguments.insert(arguments.end(), {"-resource-dir", GLIFT_CLANG_RESOURCES});
    }
    for (const std::string& dir : request.include_dirs) arguments.push_back("-I" + dir);
    return arguments;
}

void list_files(const SourceManager& sources, llvm::StringRef wrapper, ImportResult& result) {
    std::set<std::string> names;
    for (auto file = sources.fileinfo_begin(); file != sources.fileinfo_end(); ++file) {
        const FileID id = sources.translateFile(file->first);
        if (id.isInvalid() || sources.isInSystemHeader(sources.getLocForStartOfFile(id))) continue;
        const std::string name = file->first->getName().str();
        if (name != wrapper) names.insert(name);
    }
    result.read_files.assign(names.begin(), names.end());
}

}  // namespace

extern "C" void glift_clang_import_struct(const ImportRequest& request, ImportResult& result) {
    if (!llvm::sys::fs::exists(request.header)) {
        result.error = "cannot read '" + request.header + "'";
        return;
    }
    llvm::SmallString<256> header(request.header);
    llvm::sys::fs::make_absolute(header);
    const char* wrapper = "glift_import.cpp";
    FirstError first_error(result);
    const std::unique_ptr<ASTUnit> unit = tooling::buildASTFromCodeWithArgs(
        "#include \"" + header.str().str() + "\"\n", arguments_of(request), wrapper, "glift-import",
        std::make_shared<PCHContainerOperations>(), tooling::getClangSyntaxOnlyAdjuster(),
        tooling::FileContentMappings(), &first_error);
    if (!result.error.empty()) return;
    if (unit == nullptr) {
        result.error = "clang could not parse '" + request.header + "'";
        return;
    }
    ASTContext& context = unit->getASTContext();
    Importer importer(context, result);
    const auto found = find_records(context, request.name);
    if (found.empty()) {
        result.error = "there is no struct '" + request.name + "' in '" + request.header + "'";
        return;
    }
    if (found.size() > 1) {
        importer.fail(found[1]->getLocation(), "'" + request.name + "' may be '" +
                                                   found[0]->getQualifiedNameAsString() + "' or '" +
                                                   found[1]->getQualifiedNameAsString() + "'; write which one");
        return;
    }
    importer.import(*found.front());
    if (!result.error.empty()) result.structs.clear();
    list_files(unit->getSourceManager(), wrapper, result);
}

}  // namespace gliftc
