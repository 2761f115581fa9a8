#include "lsp/probes.h"

#include "lsp/uris.h"

namespace gliftc::lsp {

namespace {

bool is_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

}  // namespace

Written name_before(std::string_view text, std::size_t offset) {
    std::size_t begin = offset;
    while (begin > 0 && is_word(text[begin - 1])) --begin;
    return {begin, offset};
}

std::size_t last_before(std::string_view text, std::size_t offset) {
    return offset == 0 ? std::string_view::npos : text.find_last_not_of(" \t\r\n", offset - 1);
}

std::unique_ptr<Analysis> probe(const Workspace& workspace, const std::string& path, std::string_view text,
                                Written written) {
    constexpr std::string_view unknown = "name_that_is_being_completed";
    std::string changed(text);
    changed.replace(written.begin, written.end - written.begin, unknown);
    FileSystem files = workspace.documents.overlay();
    files.read = [&changed, &path, read = files.read](const std::string& wanted) {
        return canonical(wanted) == path ? ReadResult{changed, {}} : read(wanted);
    };
    return analyse(workspace.options(), files, path);
}

}  // namespace gliftc::lsp
