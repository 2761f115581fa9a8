// Names in GLSL: those of the source where possible, different from all other names in scope, never reserved in GLSL.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace gliftc::glsl {

/// Whether generated code must not declare the name: it is a keyword, a built-in function or a reserved word of GLSL,
/// or a name that the printer itself uses; or it begins like names of these kinds (gl_, atomic, …), contains "__", or
/// is empty.
bool is_reserved(std::string_view name);

/// `text` as a GLSL name: every run of characters other than ASCII letters and digits becomes one '_', which is left
/// out at the beginning, and at the end unless `text` ends with '_'; an 'n' is put before a digit at the beginning.
/// "value" if nothing is left.
std::string identifier(std::string_view text);

/// Nested scopes. A name declared inside never hides one declared outside.
class Scopes {
public:
    Scopes() { enter(); }

    void enter() { scopes_.emplace_back(); }
    void leave();

    /// Declares identifier(wanted), or the first of wanted_1, wanted_2, … that is free, in the innermost scope, and
    /// returns the name. It begins with "the_" if the beginning of the wanted name is reserved (gl_, atomic, …).
    std::string declare(std::string_view wanted);
    /// As declare(), but in the outermost scope: for what the text that is being printed turns out to need outside
    /// functions. The name is none of those in the scopes that are entered.
    std::string declare_outermost(std::string_view wanted);
    bool is_free(const std::string& name) const { return !is_reserved(name) && !used_.contains(name); }

private:
    std::string declare_in(std::vector<std::string>& scope, std::string_view wanted);

    std::unordered_set<std::string> used_;
    std::vector<std::vector<std::string>> scopes_;
};

}  // namespace gliftc::glsl
