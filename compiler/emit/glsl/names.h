// Names in GLSL: as in the source where possible, unique in their scope, never a word of GLSL.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace gliftc::glsl {

/// Whether it is a keyword, a built-in function, a reserved word, or a name that the printer itself uses.
bool is_reserved(std::string_view name);

/// `text` with every run of characters that a GLSL name can't have replaced by one '_'.
std::string identifier(std::string_view text);

/// Nested scopes. A name declared inside never hides one declared outside.
class Scopes {
public:
    Scopes() { enter(); }

    void enter() { scopes_.emplace_back(); }
    void leave();

    /// Declares `wanted`, or the first of wanted_1, wanted_2, … that is free, in the innermost scope.
    std::string declare(std::string_view wanted);
    bool is_free(const std::string& name) const { return !is_reserved(name) && !used_.contains(name); }

private:
    std::unordered_set<std::string> used_;
    std::vector<std::vector<std::string>> scopes_;
};

}  // namespace gliftc::glsl
