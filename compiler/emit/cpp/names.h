// Names in generated C++: as in the source where C++ allows it, else with a '_' or a number appended, an 'n' before, or
// one '_' in place of several in a row. docs/reference/language.md, "Names in C++".
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace gliftc::cpp {

/// `text` as a C++ name: every run of '_' and of characters that a name can't have becomes one '_', which is left out
/// at the end unless `text` ends with '_'; an 'n' is put before names that would begin with a digit or '_' or be empty,
/// and a '_' is appended to the names of is_word and is_macro (reserved.h).
std::string identifier(std::string_view text);

/// Variables that the C++ code of a kernel for the host device (the CPU) may declare itself. A variable of the source
/// with such a name gets a number.
inline constexpr const char* locals_of_kernels[] = {
    "address", "block", "call",       "count", "first", "i",       "inside",    "interior", "is_whole",
    "lane",    "part",  "parameters", "row",   "rows",  "stretch", "unclamped", "x",
};
/// Further variables, which only the code of draws declares.
inline constexpr const char* locals_of_draws[] = {
    "corner", "corners", "drawn", "fragments", "instance", "left", "parts", "pixel", "pointer", "running", "targets",
};
/// Further variables, which only the code of kernels with a `group` declares.
inline constexpr const char* locals_of_groups[] = {
    "global_id",   "group_count", "group_id",    "group_index", "group_size",
    "group_total", "local_id",    "local_index", "number",      "returned",
};

/// The C++ namespace of a module: laplacian stays, std.array becomes std_array. A global name of C or POSIX (is_global
/// in reserved.h) gets a '_': dup2 becomes dup2_.
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

    /// Says which names the generated code around the scopes uses itself: a '_' is appended to a name of the source
    /// that equals one.
    void reserve(std::initializer_list<const char*> names);
    /// The same for a set, which must outlive the scopes.
    void avoid(const NameSet& names) { avoided_.push_back(&names); }

    /// Declares identifier(wanted) in the innermost scope, with a '_' at its end if it is reserved or avoided; or the
    /// first of wanted_2, wanted_3, … that is free. Returns the name.
    std::string declare(std::string_view wanted);
    /// Returns a stem: identifier(wanted), or the first of wanted_2, wanted_3, … such that no name made of the stem and
    /// a suffix is taken. Declares these names, but not the stem itself.
    std::string declare_stem(std::string_view wanted, std::span<const char* const> suffixes);

    const NameSet& used() const { return used_; }
    /// Whether the name is declared or reserved. Names that are only avoided do not count.
    bool holds(const std::string& name) const { return used_.contains(name) || reserved_.contains(name); }

private:
    bool is_kept(const std::string& name) const;
    void take(const std::string& name);

    NameSet used_, reserved_;
    std::vector<const NameSet*> avoided_;
    std::vector<std::vector<const std::string*>> scopes_;  ///< the used names, by the scope that declares them
};

}  // namespace gliftc::cpp
