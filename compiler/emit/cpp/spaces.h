#pragma once

#include "emit/cpp/writer.h"

#include <string>

namespace gliftc::cpp {

/// Opens and closes namespaces, so that consecutive declarations of one namespace share a block.
class Spaces {
public:
    explicit Spaces(Writer& out) : out_(out) {}
    void enter(const std::string& space) {
        if (open_ == space) return;
        leave();
        out_.gap();
        out_.line("namespace " + space + " {");
        out_.raw("\n");
        open_ = space;
    }
    void leave() {
        if (open_.empty()) return;
        out_.gap();
        out_.line("}  // namespace " + open_);
        open_.clear();
    }

private:
    Writer& out_;
    std::string open_;
};

}  // namespace gliftc::cpp
