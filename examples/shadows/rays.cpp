#include "rays.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <thread>

namespace rays {

namespace {

using Vector = std::array<double, 3>;

Vector vector_of(const glift::float3& v) { return {v.x, v.y, v.z}; }
Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(const Vector& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& a) { return a * (1 / std::sqrt(dot(a, a))); }

/// A camera's axes, which give the line of sight through a place of its picture, from -1 to 1 (x to the right, y down).
struct Axes {
    Vector eye, forward, right, down;
    double scale_x,
        scale_y;  ///< half the picture's width and height at distance 1; of a parallel projection at any
    bool is_parallel;

    static Axes of(const camera::Camera& c, double aspect, double half_size) {
        const Vector eye = vector_of(c.eye), forward = unit(vector_of(c.target) - eye);
        const Vector right = unit(cross(forward, vector_of(camera::up_of(c))));
        const double opening = std::tan(0.5 * static_cast<double>(c.height_angle));
        const bool is_parallel = half_size > 0;
        return {eye,
                forward,
                right,
                cross(forward, right),
                is_parallel ? half_size : opening * aspect,
                is_parallel ? half_size : opening,
                is_parallel};
    }
    /// The line of sight through a place: its begin, and its direction, which has length 1 along `forward`.
    std::pair<Vector, Vector> line(double x, double y) const {
        const Vector aside = right * (x * scale_x) + down * (y * scale_y);
        return is_parallel ? std::pair(eye + aside, forward) : std::pair(eye, forward + aside);
    }
};

/// The axes of the light's faces. As in shadow_map.glift, a single face covers the whole map; a point light's six faces
/// cover one of its 4 x 4 squares each.
std::vector<Axes> faces_of(const Frame& frame) {
    const camera::Camera& light = frame.light();
    if (frame.light_kind() == LightKind::spot) return {Axes::of(light, 1, 0)};
    if (frame.light_kind() == LightKind::directional)
        return {Axes::of(light, 1, static_cast<double>(frame.scene().light_half_size))};
    std::vector<Axes> faces;
    for (unsigned i = 0; i < 6; ++i) {
        const camera::CubeFace face = camera::cube_face(i);
        const double opening = static_cast<double>(frame.opening());
        faces.push_back({vector_of(light.eye), vector_of(face.forward), vector_of(face.right), vector_of(face.down),
                         opening, opening, false});
    }
    return faces;
}

class Scene {
public:
    explicit Scene(const mesh::Mesh& mesh) : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        if (!device_) throw std::runtime_error("Embree finds no device for its rays");
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* points = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.points.size()));
        for (std::size_t i = 0; i < mesh.points.size(); ++i)
            for (unsigned k = 0; k < 3; ++k) points[3 * i + k] = mesh.points[i][k];
        auto* corners = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles()));
        std::copy(mesh.corners.begin(), mesh.corners.end(), corners);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(scene_);
    }
    ~Scene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    bool is_hit(const Vector& from, const Vector& direction, double least, double most) const {
        if (most <= least) return false;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay ray{};
        ray.org_x = static_cast<float>(from[0]), ray.org_y = static_cast<float>(from[1]);
        ray.org_z = static_cast<float>(from[2]);
        ray.dir_x = static_cast<float>(direction[0]), ray.dir_y = static_cast<float>(direction[1]);
        ray.dir_z = static_cast<float>(direction[2]);
        ray.tnear = static_cast<float>(least), ray.tfar = static_cast<float>(most), ray.mask = ~0u;
        rtcOccluded1(scene_, &context, &ray);
        return ray.tfar < 0;
    }

private:
    RTCDevice device_;
    RTCScene scene_;
};

class Tracer {
public:
    Tracer(const Frame& frame, const Lighting& lighting, float bias)
        : scene_(frame.scene().mesh), lighting_(lighting), size_(frame.size()),
          eye_(Axes::of(frame.scene().view, static_cast<double>(size_.x) / size_.y, 0)), faces_(faces_of(frame)),
          near_(static_cast<double>(frame.light().near)), far_(static_cast<double>(frame.light().far)),
          bias_(static_cast<double>(bias) * (far_ - near_)) {}

    bool is_known(std::size_t pixel) const { return lighting_.surface[pixel].w >= 0; }

    Light light_of(std::size_t pixel) const {
        if (!is_known(pixel)) return Light::unknown;
        const glift::float4& s = lighting_.surface[pixel];
        return light_at(point_of(face_at(s.x, s.y), s.x, s.y, s.z));
    }

    /// Whether the plane that a pixel shows has another answer somewhere within one pixel of the pixel's centre: at
    /// eight places on each of three circles.
    bool differs_within_a_pixel(std::size_t pixel) const {
        const Light own = light_of(pixel);
        for (int k = 0; k < 24; ++k) {
            const double angle = 0.7853981633974483 * k, radius = 1.0 - 0.33 * (k / 8);
            if (light_beside(pixel, radius * std::cos(angle), radius * std::sin(angle)) != own) return true;
        }
        return false;
    }

private:
    /// The answer for the plane that a pixel shows, at the point that is seen `x` and `y` pixels from the pixel's
    /// centre.
    Light light_beside(std::size_t pixel, double x, double y) const {
        const glift::float4& s = lighting_.surface[pixel];
        const glift::float3& slope = lighting_.slopes[pixel];
        constexpr double step = 1e-4;
        const double s0 = s.x, t0 = s.y, z0 = s.z;
        const std::size_t face = face_at(s0, t0);
        const Vector a = point_of(face, s0, t0, z0),
                     b = point_of(face, s0 + step, t0, z0 + step * static_cast<double>(slope.x)),
                     c = point_of(face, s0, t0 + step, z0 + step * static_cast<double>(slope.y));
        const Vector normal = cross(b - a, c - a);
        const double column = static_cast<double>(pixel % size_.x) + 0.5 + x,
                     row = static_cast<double>(pixel / size_.x) + 0.5 + y;
        const auto [from, along] = eye_.line(2 * column / size_.x - 1, 2 * row / size_.y - 1);
        return light_at(from + along * (dot(a - from, normal) / dot(along, normal)));
    }

    /// The face in whose square of the map the place {s, t} lies.
    std::size_t face_at(double s, double t) const {
        return faces_.size() == 1 ? 0 : static_cast<std::size_t>(std::floor(4 * t) * 4 + std::floor(4 * s));
    }
    /// The point in the world of a place in light space, on a face.
    Vector point_of(std::size_t face, double s, double t, double depth) const {
        const double squares = faces_.size() == 1 ? 1 : 4;
        const double x = s * squares - static_cast<double>(face % 4), y = t * squares - static_cast<double>(face / 4);
        const auto [from, along] = faces_.at(face).line(2 * x - 1, 2 * y - 1);
        const double distance =
            faces_[0].is_parallel ? near_ + depth * (far_ - near_) : far_ * near_ / (far_ - depth * (far_ - near_));
        return from + along * distance;
    }
    /// The distance of a point from the light along the axis of the face that sees the point; `way` leads from the
    /// point to the light.
    double distance_before(const Vector& way) const {
        double most = dot(way, faces_[0].forward) * -1.0;
        for (const Axes& face : faces_) most = std::max(most, dot(way, face.forward) * -1.0);
        return most;
    }
    Light light_at(const Vector& point) const {
        const Axes& light = faces_[0];
        const Vector way = light.is_parallel ? light.forward * -1.0 : light.eye - point;
        const double distance =
            light.is_parallel ? far_ - near_ : std::sqrt(dot(way, way)) * (1 - near_ / distance_before(way));
        return scene_.is_hit(point, unit(way), bias_, distance) ? Light::shadowed : Light::reached;
    }

    Scene scene_;
    const Lighting& lighting_;
    glift::uint2 size_;
    Axes eye_;
    std::vector<Axes> faces_;
    double near_, far_, bias_;
};

/// Whether one of the eight pixels around a pixel has the other answer, lit or shadowed.
bool differs_around(const std::vector<Light>& light, glift::uint2 size, std::size_t pixel) {
    for (std::size_t side = 0; side < 9; ++side) {
        const std::size_t column = pixel % size.x + side % 3 - 1, row = pixel / size.x + side / 3 - 1;
        if (column >= size.x || row >= size.y) continue;
        const Light other = light[row * size.x + column];
        if (other != Light::unknown && other != light[pixel]) return true;
    }
    return false;
}

/// Calls `visit(i)` for all i below n, from as many threads as the machine can run at a time.
template <class Visit> void in_parallel(std::size_t n, const Visit& visit) {
    constexpr std::size_t part = 1024;
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t begin; (begin = next.fetch_add(part)) < n;)
            for (std::size_t i = begin; i < std::min(begin + part, n); ++i) visit(i);
    };
    std::vector<std::jthread> others;
    for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k) others.emplace_back(work);
    work();
}

}  // namespace

Reference trace(const Frame& frame, const Lighting& lighting, float bias,
                const std::function<bool(std::size_t, Light)>& is_doubted) {
    const Tracer tracer(frame, lighting, bias);
    const glift::uint2 size = frame.size();
    const std::size_t pixels = lighting.surface.size();
    Reference reference{std::vector<Light>(pixels), std::vector<unsigned char>(pixels)};
    in_parallel(pixels, [&](std::size_t i) { reference.light[i] = tracer.light_of(i); });
    in_parallel(pixels, [&](std::size_t i) {
        if (reference.light[i] != Light::unknown)
            reference.at_edge[i] = differs_around(reference.light, size, i) ||
                                   (is_doubted(i, reference.light[i]) && tracer.differs_within_a_pixel(i));
    });
    return reference;
}

}  // namespace rays
