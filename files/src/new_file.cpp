// Writing a file: under another name, hashed, synchronised, renamed.
#include "descriptor.h"
#include "error.h"
#include "hdf5_driver.h"
#include "pieces.h"
#include "progress.h"
#include "structure_writer.h"
#include "together.h"

#include <glift/error.h>
#include <glift/files.h>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <set>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace glift {

namespace files {

namespace {

/// Opens the file and locks it, so that two processes do not write it at once. The name may have gone to another file
/// in between: then again.
Descriptor open_locked(const std::string& path) {
    for (;;) {
        Descriptor file(path, O_RDWR | O_CREAT);
        if (::flock(file.number(), LOCK_EX | LOCK_NB) != 0) {
            if (errno != EWOULDBLOCK) throw_system("flock", path);
            throw Error(ErrorCode::wrong_argument, "the file is being saved already", path,
                        "a process has it locked, or another NewFile of this one",
                        "wait until that save has ended, or save under another name");
        }
        struct stat locked {
        }, named{};
        if (::fstat(file.number(), &locked) == 0 && ::stat(path.c_str(), &named) == 0 &&
            locked.st_ino == named.st_ino && locked.st_dev == named.st_dev)
            return file;
    }
}

void sync_folder(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    Descriptor(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY).sync();
}

void check_name(const std::string& name, const std::set<std::string>& names, const std::string& path) {
    if (name.empty() || name.find('/') != std::string::npos || name[0] == '.')
        throw Error(ErrorCode::wrong_argument, "a structure cannot be saved under this name", path, "'" + name + "'",
                    "name it with letters and digits, without '/'");
    if (names.contains(name))
        throw Error(ErrorCode::wrong_argument, "the file has a structure of this name already", path, "'" + name + "'",
                    "save each structure under a name of its own");
}

}  // namespace

}  // namespace files

struct NewFile::State {
    State(std::string file, files::Together ranks) : path(std::move(file)), together(std::move(ranks)) {}
    ~State() {
        const files::Hdf5Lock lock;
        if (data) data->discard();
        hdf5.close();
        if (is_locked && !is_committed) ::unlink(temporary.c_str());
    }
    void open() {
        if (!together.is_writer()) return;
        const files::Hdf5Lock lock;
        descriptor = files::open_locked(temporary);
        is_locked = true;
        descriptor.resize(0);
        data = std::make_shared<files::DataMap>(descriptor);
        hdf5 = files::create_hdf5(*data);
        data->rethrow();
    }
    void commit();

    std::string path, temporary = path + ".saving";
    files::Together together;
    files::Descriptor descriptor;  ///< of the rank that writes, as is all until `names`
    std::shared_ptr<files::DataMap> data;
    files::Id hdf5;
    std::set<std::string> names;
    bool is_locked = false, is_committed = false;
};

void NewFile::State::commit() {
    const files::Hdf5Lock lock;
    const herr_t result = hdf5.close();
    data->rethrow();
    files::check(result, "H5Fclose");
    data->finish();
    const std::uint64_t end = descriptor.size();
    const files::ByteSource source{
        path, end, [&](std::uint64_t offset, std::span<std::byte> to) { return descriptor.read(offset, to); }};
    const files::Seal seal = files::seal_of(source, end, data->ranges(), data->hashes());
    descriptor.write(end, seal.list);
    descriptor.write(0, seal.user_block);
    descriptor.sync();
    if (::rename(temporary.c_str(), path.c_str()) != 0) files::throw_system("rename", path);
    is_committed = true;
    files::sync_folder(path);
}

NewFile::NewFile(std::string path) : state_(std::make_unique<State>(std::move(path), files::Together())) {
    state_->open();
}
NewFile::NewFile(std::string path, const Device& device)
    : state_(std::make_unique<State>(std::move(path), files::Together(device))) {
    state_->together.run([&] { state_->open(); });
}
NewFile::NewFile(NewFile&&) noexcept = default;
NewFile& NewFile::operator=(NewFile&&) noexcept = default;
NewFile::~NewFile() = default;

void NewFile::write(const files::Part& part, const Device& device, const FileProgress& progress) {
    if (!state_ || state_->is_committed)
        throw Error(ErrorCode::wrong_argument, "the file was closed already", "NewFile::save", "",
                    "save all structures before commit()");
    const Commands commands(device);
    if (commands.is_recording()) detail::throw_not_in_recording("NewFile::save");
    files::Together& together = state_->together;
    files::require_together(together, device, state_->path, "NewFile(path, world.device())");
    files::check_name(part.name, state_->names, state_->path);
    together.run([&] {
        const files::Hdf5Lock lock;
        files::ProgressCount count(part, progress);
        files::StructureWriter* calling = nullptr;
        files::StructureWriter writer(state_->hdf5, commands, state_->data.get(), [&](std::uint64_t bytes) {
            count.add(bytes);
            together.note(bytes, calling->error());
        });
        calling = &writer;
        if (!together.is_alone()) writer.write_for_all(together.is_writer());
        writer.write(part);
        if (writer.error()) std::rethrow_exception(writer.error());
    });
    state_->names.insert(part.name);
}

void NewFile::commit() {
    if (!state_ || state_->is_committed)
        throw Error(ErrorCode::wrong_argument, "the file was closed already", "NewFile::commit", "",
                    "call commit() once");
    state_->together.run_on_writer([&] { state_->commit(); });
    state_->is_committed = true;
}

}  // namespace glift
