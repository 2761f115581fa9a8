// Names in GLSL: as in the source where possible, different from all that are visible, never reserved in GLSL.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace gliftc::glsl {

/// Whether it is a keyword, a built-in function, a reserved word, or a name that the printer itself uses; or begins
/// like one of these (gl_, atomic, …), contains "__", or is empty.
bool is_reserved(std::string_view name);

/// `text` with every run of characters that a GLSL name can't have replaced by one '_', or left out at the beginning
/// and the end; an 'n' is put before a digit. "value" if nothing is left.
std::string identifier(std::string_view text);

/// Nested scopes. A name declared inside never hides one declared outside.
class Scopes {
public:
    Scopes() { enter(); }

    void enter() { scopes_.emplace_back(); }
    void leave();

    /// Declares identifier(wanted), or the first of wanted_1, wanted_2, … that is free, in the innermost scope; with
    /// "the_" before it if the beginning is reserved.
    std::string declare(std::string_view wanted);
    bool is_free(const std::string& name) const { return !is_reserved(name) && !used_.contains(name); }

private:
    std::unordered_set<std::string> used_;
    std::vector<std::vector<std::string>> scopes_;
};

}  // namespace gliftc::glsl
