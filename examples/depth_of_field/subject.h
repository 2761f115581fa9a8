// A subject is what is photographed: a scene or pictures from files. It gives pinhole pictures, without depth of field,
// and photographs, with it.
#pragma once

#include "dof.glift.hpp"
#include "input.h"
#include "photograph.glift.hpp"

#include <memory>
#include <string>

/// The settings of a photograph, which may change from one to the next.
struct Settings {
    input::Camera camera;
    photograph::Cuts cuts{0.1f, 0.5f};
    unsigned layers = 2;
    bool blurred = false;

    glift::uint holes() const { return blurred ? dof::Holes::blurred : dof::Holes::raised; }
};

/// A picture with distances on a device.
struct Images {
    dof::Picture colour;
    dof::Distances distances;

    Images(const glift::Device& device, glift::uint2 size) : colour(device, size), distances(device, size) {}
    Images(const glift::Device& device, const picture::Picture& picture);
    picture::Picture read() const { return {colour.extent().x, colour.extent().y, colour.read(), distances.read()}; }
};

/// Takes photographs. Each call uses the current values of the settings, which must outlive the subject.
class Subject {
public:
    Subject(const Settings& settings, glift::Device device, glift::uint2 size)
        : settings_(settings), device_(std::move(device)), result_(device_, size) {}
    virtual ~Subject() = default;

    /// Takes a photograph: one submission.
    virtual void photograph() = 0;
    virtual const Images& pinhole() const = 0;
    /// A reference for comparison: the mean of pinhole pictures from `places` points of the lens. Throws
    /// std::runtime_error if the subject is pictures from files.
    virtual picture::Picture reference(unsigned places) = 0;
    /// Sets the size of photographs; false if the subject's size is fixed.
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

/// Makes a subject of a scene, which is drawn for each photograph.
std::unique_ptr<Subject> scene_subject(const Settings& settings, const glift::Device& device,
                                       const scenes::Scene& scene, glift::uint2 size);

/// Makes a subject of pictures from files.
std::unique_ptr<Subject> picture_subject(const Settings& settings, const glift::Device& device,
                                         const input::Pictures& pictures);
