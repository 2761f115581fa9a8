// Names in C++, all of them: as in the source where C++ allows it, else with a '_' behind. docs/language.md, "Names in
// C++".
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace gliftc::cpp {

/// `text` with every run of characters that a C++ name can't have replaced by one '_', and no word or macro of C++.
std::string identifier(std::string_view text);

/// What the host's code of a kernel calls its own variables.
inline constexpr const char* locals_of_kernels[] = {
    "address", "block", "call",       "count", "first", "i",       "inside",    "interior",
    "lane",    "part",  "parameters", "row",   "rows",  "stretch", "unclamped", "x",
};
/// The same of draws.
inline constexpr const char* locals_of_draws[] = {
    "corner", "corners", "drawn", "fragments", "instance", "left", "parts", "pixel", "pointer", "running", "targets",
};
/// The same where the kernel has a group.
inline constexpr const char* locals_of_groups[] = {
    "global_id",   "group_count", "group_id",    "group_index", "group_size",
    "group_total", "local_id",    "local_index", "number",      "returned",
};

/// The namespace of a module: laplacian, std.array → std_array, dup2 → dup2_.
std::string space_of(std::string_view module);

using NameSet = std::unordered_set<std::string>;

/// Nested scopes. A name declared inside never hides one declared outside.
class Scopes {
public:
    Scopes() { enter(); }
    Scopes(Scopes&&) = default;
    Scopes& operator=(Scopes&&) = default;

    void enter() { scopes_.emplace_back(); }
    void leave();

    /// What generated code around the scopes names itself: a user's name is written with a '_' behind.
    void reserve(std::initializer_list<const char*> names);
    /// The same for a set that outlives the scopes.
    void avoid(const NameSet& names) { avoided_.push_back(&names); }

    /// Declares `wanted`, or the first of wanted_2, wanted_3, … that is free, in the innermost scope.
    std::string declare(std::string_view wanted);
    /// A name that is none itself, but begins others: it with each of the suffixes.
    std::string declare_stem(std::string_view wanted, std::span<const char* const> suffixes);

    const NameSet& used() const { return used_; }
    bool holds(const std::string& name) const { return used_.contains(name) || reserved_.contains(name); }

private:
    bool is_kept(const std::string& name) const;
    void take(const std::string& name);

    NameSet used_, reserved_;
    std::vector<const NameSet*> avoided_;
    std::vector<std::vector<const std::string*>> scopes_;  ///< of those used
};

}  // namespace gliftc::cpp
