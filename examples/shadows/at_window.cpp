#include "at_window.h"

#include "show.glift.hpp"
#include "shown.glift.hpp"

#include <imgui/imgui.h>

#include <cmath>
#include <cstring>
#include <optional>

namespace {

class Show {
public:
    Show(window::Window& window, Choice& choice, camera::Camera& view, camera::Camera& light,
         const std::function<scenes::Scene(float)>& scene_at, const std::function<void(const picture::Picture&)>& save)
        : window_(window), choice_(choice), view_(view), light_(light), scene_at_(scene_at), save_(save) {
        fit();
    }

    void frame() {
        react();
        if (has_panel_) panel();
        if (window_.is_minimised()) return;
        if (frame_->size() != window_.size()) fit();
        if (choice_.moves) {
            choice_.time += 1.0f / 30;
            scene_ = scene_at_(choice_.time);
        }
        scene_.view = view_, scene_.light = light_;
        frame_->set_knobs(choice_.settings);
        frame_->set_scene(scene_);
        frame_->draw(choice_.method);
        look_at_counts();
        show::to_screen(window_.device(), frame_->image(choice_.view), *shown_);
        window_.show(shown_->data());
    }

private:
    void fit() {
        counts_ = {};
        frame_.emplace(window_.device(), choice_.settings, window_.size());
        shown_.emplace(window_.device(), window_.size());
        scene_ = scene_at_(choice_.time);
    }
    /// Dragging turns the camera, with the right button the light; the wheel moves the camera closer.
    void react() {
        for (const window::PointerEvent& event : window_.events().pointer) {
            if (event.kind == window::PointerEvent::Kind::press) button_ = event.button;
            if (event.kind == window::PointerEvent::Kind::move && event.is_down) {
                const glift::float2 way = (event.place - place_) * 0.005f;
                camera::Camera& turned = button_ == window::Button::right ? light_ : view_;
                turned = camera::orbited(turned, -way.x, way.y, 1);
            }
            place_ = event.place;
        }
        if (window_.events().wheel != 0) view_ = camera::orbited(view_, 0, 0, std::pow(1.1f, window_.events().wheel));
        for (const window::KeyEvent& event : window_.events().keys) {
            if (!event.is_down) continue;
            if (event.key == window::escape) window_.close();
            if (event.key == window::tab) has_panel_ = !has_panel_;
            if (event.key == 'S') save_(frame_->picture(choice_.view));
        }
    }
    /// Takes over the counts of an earlier frame, once their download is ready, as the texts that the panel shows. Then
    /// begins to download those of the last frame. Nothing waits for the device.
    void look_at_counts() {
        if (counts_ && counts_.ready()) {
            shadows::Status status;
            std::memcpy(&status, counts_.get().data(), sizeof status);
            told_ = text_of(status, counted_);
            lost_ = status.lost > 0 ? text_of_lost(status) : "";
            counts_ = {};
        }
        if (counts_) return;
        counts_ = frame_->download_counts();
        counted_ = choice_.method;
    }
    void panel() {
        Settings& s = choice_.settings;
        int method = static_cast<int>(choice_.method), view = static_cast<int>(choice_.view),
            filter = static_cast<int>(s.filter), finest = static_cast<int>(s.finest),
            step = static_cast<int>(std::log2(s.step));
        ImGui::SetNextWindowPos({10, 10}, ImGuiCond_FirstUseEver);
        ImGui::Begin("Shadows", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
        ImGui::PushItemWidth(160);
        ImGui::Combo("method", &method, "standard\0ASM\0RMSM\0");
        ImGui::Combo("show", &view, "picture\0levels\0borders\0map\0pool\0");
        ImGui::SliderInt("finest level", &finest, 0, static_cast<int>(s.levels) - 1, "%d",
                         ImGuiSliderFlags_AlwaysClamp);
        ImGui::Combo("analysis", &step, "every pixel\0every 2nd\0every 4th\0every 8th\0");
        ImGui::Combo("filter", &filter, "nearest\0bilinear\0trilinear\0");
        ImGui::Checkbox("cached", &s.cached);
        ImGui::Checkbox("moves", &choice_.moves);
        ImGui::PopItemWidth();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 22);
        ImGui::TextUnformatted(told_.c_str());
        if (!lost_.empty()) ImGui::TextColored({1, 0.3f, 0.2f, 1}, "%s", lost_.c_str());
        ImGui::PopTextWrapPos();
        ImGui::TextUnformatted("Left: camera.  Right: light.  Wheel: closer.\nTab: hide this.  S: save.  Esc: close.");
        ImGui::End();
        choice_.method = static_cast<Method>(method), choice_.view = static_cast<View>(view);
        s.filter = static_cast<Filter>(filter);
        s.finest = static_cast<std::uint32_t>(finest), s.step = 1u << static_cast<unsigned>(step);
    }

    window::Window& window_;
    Choice& choice_;
    camera::Camera &view_, &light_;
    const std::function<scenes::Scene(float)>& scene_at_;
    const std::function<void(const picture::Picture&)>& save_;
    std::optional<Frame> frame_;
    std::optional<shown::Shown> shown_;
    scenes::Scene scene_;
    glift::Download counts_;
    Method counted_ = Method::matched;  ///< the method of the frame that `counts_` are of
    std::string told_, lost_;           ///< about an earlier frame: its counts; what is missing
    window::Button button_ = window::Button::left;
    glift::float2 place_{};
    bool has_panel_ = true;
};

}  // namespace

void show_at(window::Window& window, Choice& choice, camera::Camera& view, camera::Camera& light,
             const std::function<scenes::Scene(float)>& scene_at,
             const std::function<void(const picture::Picture&)>& save) {
    Show show(window, choice, view, light, scene_at, save);
    while (window.next()) show.frame();
}
