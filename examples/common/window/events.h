// What a person does at a window: pointer, wheel and keys, since the last frame.
#pragma once

#include <glift/vector.h>

#include <cstdint>
#include <vector>

namespace window {

enum class Button : std::uint8_t { left, right, middle };

/// A bit for each, together.
struct Modifiers {
    bool shift = false, control = false, alt = false;
};

/// The pointer, in pixels of the picture that the window shows: (0, 0) is the corner at the top left, the centre of the
/// first pixel (0.5, 0.5). Outside the picture coordinates are negative or beyond its size.
struct PointerEvent {
    enum class Kind : std::uint8_t { press, move, release } kind = Kind::move;
    Button button = Button::left;  ///< of a press or a release
    bool is_down = false;          ///< after the event: some button that was pressed over the picture
    glift::float2 place;
    float pressure = 1;  ///< 0 to 1; 1 of a mouse, which has none
    Modifiers modifiers;
};

struct KeyEvent {
    int key = 0;  ///< as GLFW numbers them: 'A' to 'Z', '0' to '9', ' ', and those that Key names
    bool is_down = false;
    Modifiers modifiers;
};

/// Those of KeyEvent::key without a character.
enum Key : int { escape = 256, enter = 257, tab = 258, backspace = 259, right = 262, left = 263, down = 264, up = 265 };

/// In the order in which they happened. What the panel takes is left out: presses over it, keys while it has the focus.
struct Events {
    std::vector<PointerEvent> pointer;
    std::vector<KeyEvent> keys;
    float wheel = 0;  ///< notches away from the person
};

}  // namespace window
