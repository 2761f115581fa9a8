// Reading a file into structures.
#include "progress.h"
#include "structure_reader.h"
#include "together.h"
#include "verified_file.h"

#include <glift/error.h>
#include <glift/files.h>

#include <algorithm>

namespace glift {

struct File::State {
    std::unique_ptr<files::VerifiedFile> file;
    files::Together together;
};

namespace files {

namespace {

/// Throws bad_file where ranks have opened different files under the name.
void require_same_on_all(VerifiedFile& file, const ranks::Group& group) {
    for (const std::vector<std::byte>& hash : group.all_gather(file.pieces().hash_of_list()))
        if (!std::ranges::equal(hash, file.pieces().hash_of_list()))
            throw Error(ErrorCode::bad_file, "the ranks have different files of this name", file.path(), "",
                        "put the file where all hosts see it, or copy it to each of them");
}

}  // namespace

}  // namespace files

File::File(std::string path) : state_(new State{std::make_unique<files::VerifiedFile>(std::move(path)), {}}) {}
File::File(std::string path, const Device& device) : state_(new State{nullptr, files::Together(device)}) {
    state_->together.run([&] { state_->file = std::make_unique<files::VerifiedFile>(std::move(path)); });
    if (!state_->together.is_alone()) files::require_same_on_all(*state_->file, state_->together.group());
}
File::File(File&&) noexcept = default;
File& File::operator=(File&&) noexcept = default;
File::~File() = default;

std::vector<std::string> File::names() const { return state_->file->names(); }

LoadReport File::read(files::Part& part, const Device& device, const FileProgress& progress) {
    const Commands commands(device);
    if (commands.is_recording()) detail::throw_not_in_recording("File::load");
    files::Together& together = state_->together;
    files::VerifiedFile& file = *state_->file;
    files::require_together(together, device, file.path(), "File(path, world.device())");
    LoadReport report;
    together.run([&] {
        const files::Hdf5Lock lock;
        const files::FiledPart filed = file.schema(part.name);
        const files::LoadWay way = files::match(filed, part, file.path(), report);
        files::ProgressCount count(part, progress);
        files::StructureReader reader(file.hdf5(), file.path(), file.pieces(), commands, [&](std::uint64_t bytes) {
            count.add(bytes);
            together.note(bytes);
        });
        if (way == files::LoadWay::as_it_was) reader.read_all(filed, part);
        else reader.read_by_address(filed, part);
        commands.wait();
    });
    return report;
}

void File::read_arguments(files::Part& part) {
    const files::FiledPart filed = state_->file->schema(part.name);
    for (const files::Value& value : part.values)
        if (const files::FiledValue* const other = files::find_value(filed, value.name))
            files::set_value(value, *other);
}

}  // namespace glift
