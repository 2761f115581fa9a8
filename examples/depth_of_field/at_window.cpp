#include "at_window.h"

#include "on_screen.glift.hpp"

#include <glift/reload.h>

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>

namespace {

constexpr float least_focus = 0.3f, most_focus = 100.0f;  // metres

/// Focuses on the object at this place of the picture; false if the place is outside the picture or has no finite
/// distance.
bool focus_at(const Subject& subject, Settings& settings, glift::float2 place) {
    const glift::uint2 size = subject.image().extent();
    if (!(place.x >= 0 && place.y >= 0 && place.x < static_cast<float>(size.x) && place.y < static_cast<float>(size.y)))
        return false;
    const glift::uint2 pixel(static_cast<glift::uint>(place.x), static_cast<glift::uint>(place.y));
    const float distance = subject.pinhole().distances.read(pixel, {1, 1}).front();
    if (!std::isfinite(distance)) return false;
    settings.camera.focus = std::clamp(distance, least_focus, most_focus);
    return true;
}

/// Makes the sliders; true if one was moved.
bool sliders(const Subject& subject, Settings& settings) {
    input::Camera& camera = settings.camera;
    float millimetres = 1000 * camera.focal;
    int layers = static_cast<int>(settings.layers);
    ImGui::SetNextWindowPos({10, 10}, ImGuiCond_FirstUseEver);
    ImGui::Begin("Lens", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PushItemWidth(160);
    constexpr ImGuiSliderFlags even = ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp;
    bool moved = ImGui::SliderFloat("f-stop", &camera.f_stop, 0.2f, 22.0f, "f/%.2f", even);
    moved |= ImGui::SliderFloat("focal length", &millimetres, 18.0f, 200.0f, "%.0f mm", even);
    moved |= ImGui::SliderFloat("focus", &camera.focus, least_focus, most_focus, "%.2f m", even);
    moved |= ImGui::SliderInt("layers", &layers, 1, static_cast<int>(subject.most_layers()), "%d",
                              ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopItemWidth();
    ImGui::TextUnformatted("Click: focus there.  Tab: hide this.  S: save.  Esc: close.");
    ImGui::End();
    if (moved) {
        camera.focal = millimetres / 1000;
        settings.layers = static_cast<unsigned>(layers);
    }
    return moved;
}

class Show {
public:
    Show(window::Window& window, Subject& subject, Settings& settings, const std::string& reload,
         const std::function<void()>& save)
        : reload_(reload), window_(window), subject_(subject), settings_(settings), save_(save),
          shown_(subject.device(), subject.image().extent()) {}

    void frame() {
        react();
        is_old_ |= reload_.poll();
        if (has_sliders_) is_old_ |= sliders(subject_, settings_);
        if (window_.is_minimised()) return;
        fit();
        if (is_old_) {
            subject_.photograph();
            on_screen::to_screen(subject_.device(), subject_.image(), shown_);
            is_old_ = false;
        }
        window_.show(shown_.data());
    }

private:
    void react() {
        for (const window::PointerEvent& event : window_.events().pointer)
            if (event.is_down && !is_old_) is_old_ |= focus_at(subject_, settings_, event.place);
        for (const window::KeyEvent& event : window_.events().keys) {
            if (!event.is_down) continue;
            if (event.key == window::escape) window_.close();
            if (event.key == window::tab) has_sliders_ = !has_sliders_;
            if (event.key == 'S' && !is_old_) save_();
        }
    }
    /// Makes the photograph as large as the window, if the subject allows it.
    void fit() {
        if (subject_.image().extent() == window_.size() || !subject_.resize(window_.size())) return;
        shown_ = shown::Shown(subject_.device(), window_.size());
        is_old_ = true;
    }

    glift::Reload reload_;
    window::Window& window_;
    Subject& subject_;
    Settings& settings_;
    const std::function<void()>& save_;
    shown::Shown shown_;
    bool is_old_ = true, has_sliders_ = true;
};

}  // namespace

void show_at(window::Window& window, Subject& subject, Settings& settings, const std::string& reload,
             const std::function<void()>& save) {
    Show show(window, subject, settings, reload, save);
    while (window.next_event()) show.frame();
}
