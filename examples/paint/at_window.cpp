#include "at_window.h"

#include <glift/host/math.h>

#include <imgui/imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

namespace {

using glift::float2;
using glift::float3;
using window::PointerEvent;

constexpr float radians_a_pixel = 0.008f, steepest = 1.5f;

const ImVec4 red{1, 0.4f, 0.3f, 1};

double now() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double megabytes(std::uint64_t bytes) { return 1e-6 * static_cast<double>(bytes); }

class Painter {
public:
    Painter(window::Window& window, Canvas& canvas, Orbit& orbit, painted::Layers layers, strokes::Brush brush,
            std::vector<strokes::Stroke> strokes, const std::function<void()>& save)
        : window_(window), canvas_(canvas), orbit_(orbit), layers_(layers), save_(save),
          shown_(canvas.device(), window.size()), brush_(std::move(brush)), done_(std::move(strokes)),
          undoable_(done_.size()) {}

    void frame() {
        for (const PointerEvent& event : window_.events().pointer) react(event);
        for (const window::KeyEvent& event : window_.events().keys)
            if (event.is_down) react(event.key);
        if (window_.events().wheel != 0) {
            orbit_.closer = std::clamp(orbit_.closer * std::pow(1.2f, window_.events().wheel), Orbit::least_closer,
                                       Orbit::most_closer);
            is_old_ = true;
        }
        if (has_panel_) panel();
        if (window_.is_minimised()) return;
        if (shown_.extent() != window_.size()) {
            shown_ = shown::Shown(canvas_.device(), window_.size());
            is_old_ = true;
        }
        if (is_old_) canvas_.render(orbit_.camera(), layers_, shown_);
        is_old_ = false;
        window_.show(shown_.data());
    }

    void end_stroke() {
        if (!is_painting_) return;
        done_.resize(undoable_);
        done_.push_back(stroke_);  // before what may throw: an error does not lose it
        ++undoable_;
        is_painting_ = false;
        lost_ = canvas_.end();
        is_old_ = true;
    }

    /// The strokes that are on the model, also the one that is being painted.
    std::vector<strokes::Stroke> strokes() const {
        std::vector<strokes::Stroke> all(done_.begin(), done_.begin() + static_cast<std::ptrdiff_t>(undoable_));
        if (is_painting_) all.push_back(stroke_);
        return all;
    }

private:
    void react(const PointerEvent& event) {
        const float2 moved = event.place - last_;
        last_ = event.place;
        if (event.kind == PointerEvent::Kind::press) {
            held_ = event.button;
            if (event.button == window::Button::left) begin_stroke(event);
        } else if (event.kind == PointerEvent::Kind::release) {
            if (event.button == window::Button::left) end_stroke();
            if (!event.is_down) held_.reset();
        } else if (event.is_down && held_ == window::Button::left) {
            if (is_painting_) dab_to(event);
        } else if (event.is_down && held_) {
            turn(moved, *held_);
        }
    }

    void turn(const float2& moved, window::Button button) {
        if (button == window::Button::right) {
            orbit_.turn -= radians_a_pixel * moved.x;
            orbit_.upwards = std::clamp(orbit_.upwards + radians_a_pixel * moved.y, -steepest, steepest);
        } else {
            const camera::Camera camera = orbit_.camera();
            const float3 arm = camera.eye - camera.target, right = glift::normalize(glift::cross(camera.up, arm)),
                         up = glift::normalize(glift::cross(arm, right));
            const float pixel = strokes::viewpoint_of(camera, window_.size()).pixel * glift::length(arm);
            orbit_.target = orbit_.target + (right * -moved.x + up * moved.y) * pixel;
        }
        is_old_ = true;
    }

    void begin_stroke(const PointerEvent& event) {
        end_stroke();
        stroke_ = {orbit_.camera(), window_.size(), strokes::allowed(brush_), {}};
        canvas_.begin(stroke_);
        dabs_.emplace(stroke_.brush);
        count_ = 0;
        is_painting_ = true;
        dab_to(event);
    }

    void dab_to(const PointerEvent& event) {
        const strokes::Touch touch{event.place, event.pressure};
        stroke_.path.push_back(touch);
        const double start = now();
        unsigned n = 0;
        for (const paint::Brush& dab : dabs_->to(touch)) {
            canvas_.dab(dab);
            ++n;
        }
        if (n == 0) return;
        canvas_.device().wait();
        dab_milliseconds_ = (now() - start) / n;
        is_old_ = true;
        count_ += n;
        // Files of strokes allow most_dabs dabs in a stroke. A touch adds few, so that beginning a new stroke after
        // half of them keeps every stroke within the limit.
        if (count_ > strokes::most_dabs / 2) begin_stroke(event);
    }

    /// Shows an error in the panel instead of throwing it: painting goes on, and saving can be tried again.
    void save() {
        try {
            end_stroke();
            save_();
            save_error_.clear();
        } catch (const std::exception& error) {
            save_error_ = error.what();
            std::fprintf(stderr, "paint: %s\n", error.what());
            has_panel_ = true;
        }
    }

    void undo() {
        end_stroke();
        if (canvas_.undo()) --undoable_;
        is_old_ = true;
    }

    void redo() {
        end_stroke();
        if (canvas_.redo()) ++undoable_;
        is_old_ = true;
    }

    void react(int key) {
        if (key == window::escape) window_.close();
        if (key == window::tab) has_panel_ = !has_panel_;
        if (key == 'S') save();
        if (key == 'Z') undo();
        if (key == 'Y') redo();
        if (key == 'L') layers_.levels = !layers_.levels;
        if (key == 'B') layers_.borders = !layers_.borders;
        if (key == 'P') layers_.pool = !layers_.pool;
        if (key == 'T') layers_.table = !layers_.table;
        is_old_ = true;
    }

    void panel() {
        ImGui::SetNextWindowPos({10, 10}, ImGuiCond_FirstUseEver);
        ImGui::Begin("Paint", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
        ImGui::PushItemWidth(150);
        if (!save_error_.empty()) ImGui::TextColored(red, "not saved: %s", save_error_.c_str());
        brush_panel();
        ImGui::Separator();
        bool levels = layers_.levels, borders = layers_.borders, pool = layers_.pool, table = layers_.table;
        is_old_ |= ImGui::Checkbox("levels", &levels);
        ImGui::SameLine();
        is_old_ |= ImGui::Checkbox("borders", &borders);
        ImGui::SameLine();
        is_old_ |= ImGui::Checkbox("pool", &pool);
        ImGui::SameLine();
        is_old_ |= ImGui::Checkbox("table", &table);
        layers_.levels = levels;
        layers_.borders = borders;
        layers_.pool = pool;
        layers_.table = table;
        if (ImGui::Button("undo")) undo();
        ImGui::SameLine();
        if (ImGui::Button("redo")) redo();
        ImGui::Separator();
        statistics();
        ImGui::PopItemWidth();
        ImGui::End();
    }

    void brush_panel() {
        // Numbers can also be typed into sliders: AlwaysClamp clamps those, too.
        constexpr ImGuiSliderFlags clamped = ImGuiSliderFlags_AlwaysClamp,
                                   even = clamped | ImGuiSliderFlags_Logarithmic;
        ImGui::ColorEdit3("colour", &brush_.colour.x);
        ImGui::SliderFloat("radius", &brush_.radius, 1, 300, "%.0f pixels", even);
        ImGui::SliderFloat("hardness", &brush_.hardness, 0, 1, "%.3f", clamped);
        ImGui::SliderFloat("grain", &brush_.grain, 0, 1, "%.3f", clamped);
        ImGui::SliderFloat("opacity", &brush_.opacity, 0, 1, "%.3f", clamped);
        ImGui::SliderFloat("flow", &brush_.flow, 0, 1, "%.3f", clamped);
        ImGui::SliderFloat("cells", &brush_.cells, 4, 256, "%.0f", even);
        int blend = static_cast<int>(brush_.blend);
        if (ImGui::Combo("blend", &blend, "over\0multiply\0erase\0")) brush_.blend = static_cast<glift::uint>(blend);
        brush_ = strokes::allowed(brush_);
    }

    void statistics() const {
        const Canvas::Bytes bytes = canvas_.bytes();
        const History& history = canvas_.history();
        ImGui::Text("pages: %u of %u", canvas_.pages(), canvas_.octree().capacity());
        ImGui::Text("pool %.1f MB, table %.1f MB", megabytes(bytes.pool), megabytes(bytes.table));
        ImGui::Text("history: %zu strokes, %.1f + %.1f MB", history.undoable(), megabytes(history.device_bytes()),
                    megabytes(history.host_bytes()));
        ImGui::Text("%.1f ms a dab", dab_milliseconds_);
        if (lost_ != 0) ImGui::TextColored(red, "pool full: %u requests for pages in vain, counted in each dab", lost_);
        ImGui::TextUnformatted("left: paint  right: turn  middle: move  wheel: closer");
        ImGui::TextUnformatted("Z undo  Y redo  L levels  B borders  P pool  T table  S save  Tab");
    }

    window::Window& window_;
    Canvas& canvas_;
    Orbit& orbit_;
    painted::Layers layers_;
    const std::function<void()>& save_;
    shown::Shown shown_;
    strokes::Brush brush_;
    strokes::Stroke stroke_;
    std::optional<strokes::Dabs> dabs_;
    std::vector<strokes::Stroke> done_;
    std::size_t undoable_;  ///< the first so many strokes of `done_` are on the model; the others were undone
    std::optional<window::Button> held_;
    float2 last_;
    std::size_t count_ = 0;  ///< number of the current stroke's dabs
    std::string save_error_;
    double dab_milliseconds_ = 0;
    glift::uint lost_ = 0;
    bool is_painting_ = false, is_old_ = true, has_panel_ = true;
};

}  // namespace

camera::Camera Orbit::camera() const {
    camera::Camera camera;
    camera.target = target;
    camera.eye = target + float3(0, 0, 1.6f);
    camera.near = 0.01f;
    camera.far = 8;
    return camera::orbited(camera, turn, upwards, closer);
}

void paint_at(window::Window& window, Canvas& canvas, Orbit& orbit, painted::Layers layers, strokes::Brush brush,
              std::vector<strokes::Stroke>& strokes, const std::function<void()>& save) {
    Painter painter(window, canvas, orbit, layers, std::move(brush), strokes, save);
    try {
        while (window.next_event()) painter.frame();
        painter.end_stroke();
    } catch (...) {
        strokes = painter.strokes();
        throw;
    }
    strokes = painter.strokes();
}
