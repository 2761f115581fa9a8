#include "lsp/documents.h"

#include "lsp/positions.h"
#include "lsp/protocol.h"
#include "lsp/uris.h"

namespace gliftc::lsp {

namespace {

std::int64_t version_in(const nlohmann::json& document) {
    return document.contains("version") && document["version"].is_number_integer()
               ? document["version"].get<std::int64_t>()
               : 0;
}

/// Replaces the range of the change, or the whole text if it has none. A range whose end is before its start is empty.
void apply(const nlohmann::json& change, std::string& text) {
    const std::string& inserted = string_member(change, "text");
    if (!change.contains("range")) {
        text = inserted;
        return;
    }
    const nlohmann::json& range = change["range"];
    const std::size_t begin = offset_of(text, read_position(member(range, "start")));
    const std::size_t end = std::max(begin, offset_of(text, read_position(member(range, "end"))));
    text.replace(begin, end - begin, inserted);
}

}  // namespace

std::string Documents::open(const nlohmann::json& params) {
    const nlohmann::json& document = member(params, "textDocument");
    const std::string& uri = string_member(document, "uri");
    std::string path = path_of(uri);
    by_path_[path] = {uri, version_in(document), string_member(document, "text")};
    return path;
}

std::string Documents::change(const nlohmann::json& params) {
    const nlohmann::json& document = member(params, "textDocument");
    std::string path = path_of(string_member(document, "uri"));
    const auto found = by_path_.find(path);
    if (found == by_path_.end()) throw InvalidParams("the document '" + path + "' is not open");
    std::string text = found->second.text;  // changed as a whole or, after an error, not at all
    for (const nlohmann::json& each : array_member(params, "contentChanges")) apply(each, text);
    found->second.text = std::move(text);
    found->second.version = version_in(document);
    return path;
}

std::string Documents::close(const nlohmann::json& params) {
    std::string path = path_of(string_member(member(params, "textDocument"), "uri"));
    if (by_path_.erase(path) == 0) throw InvalidParams("the document '" + path + "' is not open");
    return path;
}

const Document* Documents::find(const std::string& path) const {
    const auto found = by_path_.find(path);
    return found == by_path_.end() ? nullptr : &found->second;
}

FileSystem Documents::overlay() const {
    FileSystem files = disk();
    files.read = [this, read = files.read](const std::string& path) {
        const Document* document = find(canonical(path));
        return document != nullptr ? ReadResult{document->text, {}} : read(path);
    };
    files.exists = [this, exists = files.exists](const std::string& path) {
        return find(canonical(path)) != nullptr || exists(path);
    };
    return files;
}

}  // namespace gliftc::lsp
