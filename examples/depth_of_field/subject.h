// What is in front of the lens: pinhole pictures, and photographs of them.
#pragma once

#include "dof.glift.hpp"
#include "input.h"
#include "photograph.glift.hpp"

#include <memory>
#include <string>

/// What a photograph depends on, beside what is in front of the lens. May change from one to the next.
struct Settings {
    input::Camera camera;
    photograph::Cuts cuts{0.1f, 0.5f};
    unsigned layers = 2;
    bool blurred = false;

    glift::uint holes() const { return blurred ? dof::Holes::blurred : dof::Holes::raised; }
};

/// A picture on a device.
struct Images {
    dof::Picture colour;
    dof::Distances distances;

    Images(const glift::Device& device, glift::uint2 size) : colour(device, size), distances(device, size) {}
    Images(const glift::Device& device, const picture::Picture& picture);
    picture::Picture read() const { return {colour.extent().x, colour.extent().y, colour.read(), distances.read()}; }
};

/// Takes photographs with the settings, which have to outlive it, as they are at each call.
class Subject {
public:
    Subject(const Settings& settings, glift::Device device, glift::uint2 size)
        : settings_(settings), device_(std::move(device)), result_(device_, size) {}
    virtual ~Subject() = default;

    /// One submission for each call.
    virtual void photograph() = 0;
    virtual const Images& pinhole() const = 0;
    /// Of so many pinholes all over the lens.
    virtual picture::Picture reference(unsigned places) = 0;
    /// Photographs of another size from now on; false where the subject has one of its own.
    virtual bool resize(glift::uint2 size) = 0;
    virtual unsigned most_layers() const = 0;

    const dof::Picture& image() const { return result_; }
    picture::Picture result() const;
    picture::Picture circles() const;
    picture::Picture layers() const;
    const glift::Device& device() const { return device_; }

protected:
    dof::Lens lens() const;

    const Settings& settings_;
    glift::Device device_;
    dof::Picture result_;
};

/// A generated scene or a mesh file, which is drawn for each photograph.
std::unique_ptr<Subject> scene_subject(const Settings& settings, const glift::Device& device,
                                       const scenes::Scene& scene, glift::uint2 size);

/// Pictures from files.
std::unique_ptr<Subject> picture_subject(const Settings& settings, const glift::Device& device,
                                         const input::Pictures& pictures);
