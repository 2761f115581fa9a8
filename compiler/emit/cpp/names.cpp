#include "emit/cpp/names.h"

#include "emit/cpp/reserved.h"

#include <algorithm>

namespace gliftc::cpp {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The name with a '_' at its end, to which a number can be appended.
std::string stem_of(const std::string& name) { return name.ends_with('_') ? name : name + "_"; }

}  // namespace

std::string identifier(std::string_view text) {
    std::string result;
    result.reserve(text.size() + 1);
    for (char c : text) {
        if (is_letter(c) || is_digit(c)) result += c;
        else if (!result.ends_with('_')) result += '_';
    }
    // A '_' at the end that stands for other characters is left out, one that the source has is not. C++ reserves many
    // names that begin with '_', so none begins with it.
    while (result.size() > 1 && result.ends_with('_') && !text.ends_with('_')) result.pop_back();
    if (result.empty() || is_digit(result[0]) || result[0] == '_') result.insert(0, "n");
    if (is_word(result) || is_macro(result)) result += '_';
    return result;
}

std::string space_of(std::string_view module) {
    std::string name = identifier(module);
    if (is_global(name)) name += '_';
    return name;
}

void Scopes::leave() {
    for (const std::string* name : scopes_.back()) used_.erase(used_.find(*name));
    scopes_.pop_back();
}

void Scopes::reserve(std::initializer_list<const char*> names) { reserved_.insert(names.begin(), names.end()); }

bool Scopes::is_kept(const std::string& name) const {
    return reserved_.contains(name) ||
           std::ranges::any_of(avoided_, [&](const NameSet* names) { return names->contains(name); });
}

void Scopes::take(const std::string& name) {
    const auto [place, is_new] = used_.insert(name);
    if (is_new) scopes_.back().push_back(&*place);
}

std::string Scopes::declare(std::string_view wanted) {
    std::string name = identifier(wanted);
    if (is_kept(name)) name = stem_of(name);
    const std::string stem = stem_of(name);
    const bool is_plain = !is_macro(stem);  // else each name that begins so counts as a macro
    const auto is_free = [&] { return !used_.contains(name) && !is_kept(name) && !(is_plain && is_macro(name)); };
    for (int i = 2; !is_free(); ++i) name = stem + std::to_string(i);
    take(name);
    return name;
}

std::string Scopes::declare_stem(std::string_view wanted, std::span<const char* const> suffixes) {
    std::string name = identifier(wanted);
    const std::string stem = stem_of(name);
    const auto is_taken = [&](const char* suffix) { return used_.contains(name + suffix) || is_kept(name + suffix); };
    for (int i = 2; std::ranges::any_of(suffixes, is_taken); ++i) name = stem + std::to_string(i);
    for (const char* suffix : suffixes) take(name + suffix);
    return name;
}

}  // namespace gliftc::cpp
