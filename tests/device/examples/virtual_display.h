// A virtual display (Xvfb) and the actions of a user: pointer and keys by XTest, messages of a window manager, and the
// contents of the window.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// The pixels of a window: eight bits per channel, row by row.
struct Seen {
    std::uint32_t width = 0, height = 0;
    struct Colour {
        std::uint8_t red, green, blue;
        bool operator==(const Colour&) const = default;
    };
    std::vector<Colour> pixels;
};

class VirtualDisplay {
public:
    /// Starts Xvfb with a screen of 1000 x 700. Throws std::runtime_error where that fails.
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;

    const std::string& name() const { return name_; }  ///< for DISPLAY

    /// Whether there is a window of this title. The calls below, except press(), release() and end(), are about the
    /// last window that this found.
    bool has_window(const std::string& title);
    Seen seen() const;
    void move_to(int x, int y) const;
    /// Presses a button of the pointer, as X numbers them: 1 is the left one, 3 the right one.
    void press(unsigned button = 1) const;
    void release(unsigned button = 1) const;
    void type(const std::string& key) const;  ///< key: its name in X, such as `Tab`
    void resize(unsigned width, unsigned height) const;
    void minimise() const;
    void restore() const;
    void ask_to_close() const;
    void end();  ///< ends Xvfb, as if the display went away

private:
    struct Connection;
    std::string name_;
    int process_ = 0;
    Connection* connection_ = nullptr;
    unsigned long window_ = 0;
};
