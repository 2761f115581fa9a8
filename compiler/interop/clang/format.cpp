// The part of format_code (interop.h) in libglift_clang.so: formats code by the library clangFormat.

#include "interop/plugin.h"

#include <clang/Format/Format.h>
#include <clang/Tooling/Core/Replacement.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/MemoryBuffer.h>

namespace gliftc {
namespace {

using clang::format::FormatStyle;

/// The style in the .clang-format file with the path `wanted`, or, if there is no such file, clang-format's style of
/// that name. The error says whether neither exists, or the file cannot be read or parsed.
llvm::Expected<FormatStyle> find_style(std::string_view wanted) {
    const llvm::StringRef style(wanted.data(), wanted.size());
    if (!llvm::sys::fs::exists(style)) {
        FormatStyle named = clang::format::getLLVMStyle(FormatStyle::LK_Cpp);
        if (clang::format::getPredefinedStyle(style, FormatStyle::LK_Cpp, &named)) return named;
        return llvm::createStringError(std::errc::invalid_argument,
                                       "there is no file and no clang-format style named '%s'", style.str().c_str());
    }
    auto file = llvm::MemoryBuffer::getFile(style, /*IsText=*/true);
    if (!file) {
        return llvm::createStringError(file.getError(), "cannot read '%s': %s", style.str().c_str(),
                                       file.getError().message().c_str());
    }
    FormatStyle parsed = clang::format::getLLVMStyle(FormatStyle::LK_Cpp);
    if (const std::error_code error = clang::format::parseConfiguration(**file, &parsed)) {
        return llvm::createStringError(error, "'%s' is no clang-format file: %s", style.str().c_str(),
                                       error.message().c_str());
    }
    return parsed;
}

}  // namespace

extern "C" void glift_clang_format(std::string_view text, std::string_view wanted, FormatResult& result) {
    auto style = find_style(wanted);
    if (!style) {
        result.error = llvm::toString(style.takeError());
        return;
    }
    // The order of includes in generated code matters.
    style->SortIncludes = FormatStyle::SI_Never;
    const llvm::StringRef code(text.data(), text.size());
    const clang::tooling::Range all(0, static_cast<unsigned>(text.size()));
    const auto edits = clang::format::reformat(*style, code, all, "generated.cpp");
    auto formatted = clang::tooling::applyAllReplacements(code, edits);
    if (!formatted) {
        result.error = llvm::toString(formatted.takeError());
        return;
    }
    result.text = std::move(*formatted);
}

extern "C" int glift_clang_version() { return plugin_version; }

}  // namespace gliftc
