// Reading a file: verified before HDF5 opens it.
#include "descriptor.h"
#include "error.h"
#include "pieces.h"
#include "progress.h"
#include "structure_reader.h"

#include <glift/error.h>
#include <glift/files.h>

#include <algorithm>
#include <fcntl.h>

namespace glift {

namespace files {

namespace {

ByteSource source_of(const Descriptor& file) {
    return {file.path(), file.size(),
            [&file](std::uint64_t offset, std::span<std::byte> to) { return file.read(offset, to); }};
}

Id open_hdf5(const std::string& path) {
    const Id access(H5Pcreate(H5P_FILE_ACCESS), "H5Pcreate");
    check(H5Pset_file_locking(access, false, true), "H5Pset_file_locking");
    return Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), "H5Fopen");
}

herr_t add_name(hid_t, const char* name, const H5L_info_t*, void* names) {
    static_cast<std::vector<std::string>*>(names)->push_back(name);
    return 0;
}

std::vector<std::string> names_in(hid_t file) {
    std::vector<std::string> names;
    check(H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, nullptr, add_name, &names), "H5Literate");
    return names;
}

FiledPart schema_of(hid_t file, const std::string& name, const std::string& path) {
    const std::vector<std::string> names = names_in(file);
    if (std::ranges::find(names, name) == names.end()) {
        std::string all;
        for (const std::string& other : names) all += (all.empty() ? "" : ", ") + other;
        throw Error(ErrorCode::wrong_argument, "the file has no structure of this name", path, "'" + name + "'",
                    "it has: " + (all.empty() ? "none" : all));
    }
    const Id group(H5Gopen2(file, name.c_str(), H5P_DEFAULT), "H5Gopen2");
    return parse_schema(read_text_attribute(group, "glift.schema"), path);
}

}  // namespace

}  // namespace files

struct File::State {
    explicit State(std::string file)
        : path(std::move(file)), descriptor(path, O_RDONLY), pieces(files::source_of(descriptor)) {
        pieces.verify_metadata();
        const files::Hdf5Lock lock;
        hdf5 = files::open_hdf5(path);
    }
    ~State() {
        const files::Hdf5Lock lock;
        hdf5.close();
    }

    std::string path;
    files::Descriptor descriptor;
    files::Pieces pieces;
    files::Id hdf5;
};

File::File(std::string path) : state_(std::make_unique<State>(std::move(path))) {}
File::File(File&&) noexcept = default;
File& File::operator=(File&&) noexcept = default;
File::~File() = default;

std::vector<std::string> File::names() const {
    const files::Hdf5Lock lock;
    return files::names_in(state_->hdf5);
}

LoadReport File::read(files::Part& part, const Device& device, const FileProgress& progress) {
    const Commands commands(device);
    if (commands.is_recording()) detail::throw_not_in_recording("File::load");
    const files::Hdf5Lock lock;
    const files::FiledPart filed = files::schema_of(state_->hdf5, part.name, state_->path);
    LoadReport report;
    const files::LoadWay way = files::match(filed, part, state_->path, report);
    files::ProgressCount count(part, progress);
    files::StructureReader reader(state_->hdf5, state_->path, state_->pieces, commands,
                                  [&](std::uint64_t bytes) { count.add(bytes); });
    if (way == files::LoadWay::as_it_was) reader.read_all(filed, part);
    else reader.read_by_address(filed, part);
    commands.wait();
    return report;
}

void File::read_arguments(files::Part& part) {
    const files::Hdf5Lock lock;
    const files::FiledPart filed = files::schema_of(state_->hdf5, part.name, state_->path);
    for (const files::Value& value : part.values)
        if (const files::FiledValue* const other = files::find_value(filed, value.name))
            files::set_value(value, *other);
}

}  // namespace glift
