// The documents that the editor has open: their texts, which take precedence over the files on disk.
#pragma once

#include "driver/file_system.h"

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <optional>
#include <string>

namespace gliftc::lsp {

struct Document {
    std::string uri;  ///< as the editor writes it
    std::int64_t version = 0;
    std::string text;
};

class Documents {
public:
    /// The notifications of these names, with their parameters. Throw InvalidParams. A document that is not open is
    /// opened by none of them but `open`: changes and the closing of such a document are errors.
    std::string open(const nlohmann::json& params);
    std::string change(const nlohmann::json& params);
    std::string close(const nlohmann::json& params);

    const Document* find(const std::string& path) const;
    const std::map<std::string, Document>& all() const { return by_path_; }
    /// The files of the disk, under the texts of the open documents. The documents must outlive it.
    FileSystem overlay() const;

private:
    std::map<std::string, Document> by_path_;
};

}  // namespace gliftc::lsp
