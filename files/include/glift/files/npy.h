// NumPy's .npy files: dense structures out of them, and into them. Of the library libglift_files.
//
//     glift::save_npy("heat.npy", heat);
//     Heat again = glift::load_npy<Heat>("heat.npy", device);
//
// The array's axes are those of addresses, the slowest first, then those of the element: an Array<3, float2>(uint3(4,
// 5, 6)) is an array of shape (6, 5, 4, 2). Elements are numbers, bools, vectors, matrices or arrays of these, not
// structs. Types are not converted: `float` is float32.
//
// All functions wait for the device, and throw wrong_argument within a body of Device::record. Elements are moved in
// boxes of 4 MiB.
#pragma once

#include <glift/files/api.h>
#include <glift/files/collect.h>

#include <string>

namespace glift {

namespace files {

/// The extent of the structure that the array of a file fills. Throws as load_npy.
GLIFT_FILES_API Extent npy_extent(const std::string& path, unsigned rank, const ElementType& type);
GLIFT_FILES_API void read_npy(const std::string& path, const Elements& elements);
GLIFT_FILES_API void write_npy(const std::string& path, const Elements& elements);

template <class S>
concept IsNpyArray = IsDense<S> && !detail::Described<typename S::Element> && !is_array_of_structs<typename S::Element>;

}  // namespace files

/// Reads all elements of a structure, whose extent must be that of the array. Versions 1.0 to 3.0 of the format, C or
/// Fortran order; an array in Fortran order is read into the host's memory as a whole. Throws bad_file where the file
/// is no array that it can read, or is cut off; wrong_argument where the array has another type or shape than the
/// structure, or the file cannot be opened. Nothing is changed then.
template <files::IsNpyArray S> void load_npy(const std::string& path, S& structure) {
    if (Commands(structure.device()).is_recording()) detail::throw_not_in_recording("load_npy");
    files::read_npy(path, files::elements_of(structure));
}

/// Makes a structure of the array's extent, and reads it. For structures that are made with their extent alone.
template <files::IsNpyArray S>
requires std::is_constructible_v<S, const Device&, typename S::Address> S load_npy(const std::string& path,
                                                                                   const Device& device) {
    if (Commands(device).is_recording()) detail::throw_not_in_recording("load_npy");
    const Extent extent =
        files::npy_extent(path, detail::Axes<typename S::Address>::count, files::element_type<typename S::Element>());
    S made(device, files::address_of<typename S::Address>(extent));
    load_npy(path, made);
    return made;
}

/// Writes all elements, in C order. The file is complete when it gets its name; until then it is `<path>.saving`.
/// Throws wrong_argument where it cannot be written.
template <files::IsNpyArray S> void save_npy(const std::string& path, const S& structure) {
    if (Commands(structure.device()).is_recording()) detail::throw_not_in_recording("save_npy");
    S shared = structure;
    files::write_npy(path, files::elements_of(shared));
}

}  // namespace glift
