// Names in C++: as in the source where possible, unique in their scope, never a word of C++.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace gliftc::cpp {

/// True of C++ keywords and of the names that generated code relies on.
bool is_reserved(std::string_view name);

/// `text` with every run of characters that a C++ name can't have replaced by one '_', and no word of C++.
std::string identifier(std::string_view text);

/// Nested scopes. A name declared inside never hides one declared outside.
class Scopes {
public:
    Scopes() { enter(); }
    Scopes(Scopes&&) = default;
    Scopes& operator=(Scopes&&) = default;

    void enter() { scopes_.emplace_back(); }
    void leave();

    /// Declares `wanted`, or the first of wanted_2, wanted_3, … that is free, in the innermost scope.
    std::string declare(std::string_view wanted);

private:
    std::unordered_set<std::string> used_;
    std::vector<std::vector<const std::string*>> scopes_;  ///< of those used
};

}  // namespace gliftc::cpp
