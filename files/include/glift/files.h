// Files: any structure or container, saved to HDF5 and loaded again on any device. Of the library libglift_files
// (CMake: glift::files); programs that do not use it link no HDF5.
//
//     glift::save("grid.h5", "grid", grid);
//     Grid again = glift::load<Grid>("grid.h5", "grid", device);
//
// What is stored is all that the structure consists of: the constructor's arguments, what it keeps on the host, and all
// of its memories, with those of structures that it was given. No container is known by name: generated classes hand
// over their parts (`visit_state`). docs/reference/file-formats.md describes the file.
//
// Structures of a world's device (ranks/world.h) are saved and loaded by all its ranks together: each rank makes the
// same calls. They may be as many ranks as they like; every rank gets all elements.
//
// All functions wait for the device, and throw wrong_argument within a body of Device::record. Memory beyond the
// structure's own is bounded: some chunks of 4 MiB, whatever the structure's size.
#pragma once

#include <glift/files/api.h>
#include <glift/files/collect.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace glift {

/// Called with the bytes of memory that were moved so far, and those to be moved in all.
using FileProgress = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// How what a file has differs from the structure into which it was loaded.
struct LoadReport {
    std::vector<std::string> added;    ///< fields that the file does not have: their numbers are 0
    std::vector<std::string> removed;  ///< fields of the file that the structure does not have: they were skipped
    /// Whether elements went to their addresses in a structure of another size or order of elements. Elements that the
    /// file does not have are 0.
    bool is_by_address = false;
};

/// A file that is being written. It has another name, `<path>.saving`, until commit() renames it: a file that has the
/// path already stays whole until then, whenever the process ends.
class GLIFT_FILES_API NewFile {
public:
    /// Throws wrong_argument where the file cannot be made, or another process is writing it.
    explicit NewFile(std::string path);
    /// For structures of a world's device (ranks/world.h): all ranks make the file, save to it and commit it alike. The
    /// first rank writes; what fails there is thrown on every rank. For other devices the same as without one.
    NewFile(std::string path, const Device& device);
    NewFile(NewFile&&) noexcept;
    NewFile& operator=(NewFile&&) noexcept;
    ~NewFile();  ///< without commit(): discards what was written

    /// Saves a structure as the group `name`. Throws wrong_argument for a name that is empty, was used already, or has
    /// a slash or a dot at its begin, and where the disk is full.
    template <class S> void save(const std::string& name, const S& structure, const FileProgress& progress = {}) {
        S shared = structure;
        write(files::part_of(shared, name, files::Role::root), shared.device(), progress);
    }
    /// Closes the file: hashes it, waits until the disk has it, gives it its name.
    void commit();

    /// What save() does, for a structure that has no class: gliftinfo makes such from arrays.
    void write(const files::Part& part, const Device& device, const FileProgress& progress);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// A file of saved structures. Its user block, its list of hashes and all of HDF5's metadata are verified when it is
/// opened, and elements when they are read.
class GLIFT_FILES_API File {
public:
    /// Throws bad_file where the file is damaged, cut off, or of another format; wrong_argument where there is none.
    explicit File(std::string path);
    /// For structures of a world's device: all ranks open the file, which each of them reads, and load from it alike.
    /// What fails on one is thrown on every rank; bad_file, too, where the files of ranks differ.
    File(std::string path, const Device& device);
    File(File&&) noexcept;
    File& operator=(File&&) noexcept;
    ~File();

    /// The names under which structures were saved, in alphabetical order.
    std::vector<std::string> names() const;

    /// Loads into a structure that exists. One of the same declaration that was made with the same arguments is
    /// afterwards as the saved one was, bit for bit: elements, tables, what it keeps on the host. Fields of elements
    /// are matched by name. A structure all of whose elements are resident may have another size, or another order of
    /// elements: they go to their addresses. Throws wrong_argument, before anything is changed, where the declarations
    /// or arguments do not fit; bad_file where elements are damaged: some of them may be loaded then.
    template <class S> LoadReport load(const std::string& name, S& structure, const FileProgress& progress = {}) {
        files::Part part = files::part_of(structure, name, files::Role::root);
        return read(part, structure.device(), progress);
    }
    /// Makes the structure with the arguments that the saved one was made with, and loads it. Not for structures that
    /// are given other structures: make these, and load into it.
    template <class S> S load(const std::string& name, const Device& device, const FileProgress& progress = {}) {
        S made = make<S>(name, device, typename S::Arguments{});
        load(name, made, progress);
        return made;
    }

private:
    template <class S, class... T> S make(const std::string& name, const Device& device, Types<T...>) {
        S empty;
        files::Part part = files::part_of(empty, name, files::Role::root);
        read_arguments(part);
        return [&]<std::size_t... at>(std::index_sequence<at...>) {
            return S(Commands(device), *static_cast<const T*>(part.values[at].data)...);
        }
        (std::index_sequence_for<T...>());
    }
    LoadReport read(files::Part& part, const Device& device, const FileProgress& progress);
    void read_arguments(files::Part& part);

    struct State;
    std::unique_ptr<State> state_;
};

/// Saves one structure as a file of its own: NewFile, save and commit.
template <class S>
void save(const std::string& path, const std::string& name, const S& structure, const FileProgress& progress = {}) {
    NewFile file(path, structure.device());
    file.save(name, structure, progress);
    file.commit();
}

/// As File::load into a structure that exists.
template <class S>
LoadReport load(const std::string& path, const std::string& name, S& structure, const FileProgress& progress = {}) {
    return File(path, structure.device()).load(name, structure, progress);
}

/// As File::load that makes the structure.
template <class S>
S load(const std::string& path, const std::string& name, const Device& device, const FileProgress& progress = {}) {
    return File(path, device).load<S>(name, device, progress);
}

}  // namespace glift
