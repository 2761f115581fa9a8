// Input events of a window since the last frame: pointer, wheel and keys.
#pragma once

#include <glift/vector.h>

#include <cstdint>
#include <vector>

namespace window {

enum class Button : std::uint8_t { left, right, middle };

/// Which modifier keys are held.
struct Modifiers {
    bool shift = false, control = false, alt = false;
};

/// A pointer event. `place` is in pixels of the picture that the window shows: (0, 0) is its top left corner, (0.5,
/// 0.5) the centre of the first pixel. Outside the picture it is negative or beyond its size.
struct PointerEvent {
    enum class Kind : std::uint8_t { press, move, release } kind = Kind::move;
    Button button = Button::left;  ///< of a press or a release
    bool is_down = false;          ///< after the event, a button that was pressed over the picture is still down
    glift::float2 place;
    float pressure = 1;  ///< of the pointer, 0 to 1; Display leaves it at 1, since GLFW reports none
    Modifiers modifiers;
};

struct KeyEvent {
    int key = 0;  ///< GLFW's key code, such as 'A' to 'Z', '0' to '9', ' ' or one of Key
    bool is_down = false;
    Modifiers modifiers;
};

/// Codes of keys without a character.
enum Key : int { escape = 256, enter = 257, tab = 258, backspace = 259, right = 262, left = 263, down = 264, up = 265 };

/// Pointer events and key events, each in order. What ImGui's widgets use is left out (Panel::filter).
struct Events {
    std::vector<PointerEvent> pointer;
    std::vector<KeyEvent> keys;
    float wheel = 0;  ///< how many notches the wheel was turned away from the user; negative: towards the user
};

}  // namespace window
