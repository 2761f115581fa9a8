// JSON as text, written from the front to the back: one entry per line, indented by two spaces per level.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace gliftc::json {

class Text {
public:
    /// An object. `entries` is called to write its entries, each by key() and then a value.
    template <class Entries> void object(Entries&& entries) { enclose('{', '}', entries); }
    /// An array. `entries` is called to write its values.
    template <class Entries> void array(Entries&& entries) { enclose('[', ']', entries); }

    void key(std::string_view name);
    void value(std::string_view string);
    void value(const char* string) { value(std::string_view(string)); }
    void value(std::same_as<bool> auto truth) { literal(truth ? "true" : "false"); }
    void value(std::unsigned_integral auto number) requires(!std::same_as<decltype(number), bool>) {
        literal(std::to_string(number));
    }
    void null() { literal("null"); }
    template <class Value> void field(std::string_view name, const Value& what) {
        key(name);
        value(what);
    }

    std::string take() { return std::move(text_); }

private:
    template <class Entries> void enclose(char open, char close, Entries&& entries) {
        begin_value();
        text_ += open;
        ++depth_;
        is_empty_ = true;
        entries();
        --depth_;
        if (!is_empty_) break_line();
        text_ += close;
        is_empty_ = false;
    }
    void literal(std::string_view text);
    void begin_value();
    void begin_entry();
    void break_line();
    void quote(std::string_view string);

    std::string text_;
    std::size_t depth_ = 0;
    bool is_empty_ = true;  ///< the object or array that is being written has no entry yet
    bool follows_key_ = false;
};

}  // namespace gliftc::json
