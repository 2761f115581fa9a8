// Reading a file into structures.
#include "progress.h"
#include "structure_reader.h"
#include "verified_file.h"

#include <glift/files.h>

namespace glift {

struct File::State {
    files::VerifiedFile file;
};

File::File(std::string path) : state_(new State{files::VerifiedFile(std::move(path))}) {}
File::File(File&&) noexcept = default;
File& File::operator=(File&&) noexcept = default;
File::~File() = default;

std::vector<std::string> File::names() const { return state_->file.names(); }

LoadReport File::read(files::Part& part, const Device& device, const FileProgress& progress) {
    const Commands commands(device);
    if (commands.is_recording()) detail::throw_not_in_recording("File::load");
    const files::Hdf5Lock lock;
    files::VerifiedFile& file = state_->file;
    const files::FiledPart filed = file.schema(part.name);
    LoadReport report;
    const files::LoadWay way = files::match(filed, part, file.path(), report);
    files::ProgressCount count(part, progress);
    files::StructureReader reader(file.hdf5(), file.path(), file.pieces(), commands,
                                  [&](std::uint64_t bytes) { count.add(bytes); });
    if (way == files::LoadWay::as_it_was) reader.read_all(filed, part);
    else reader.read_by_address(filed, part);
    commands.wait();
    return report;
}

void File::read_arguments(files::Part& part) {
    const files::FiledPart filed = state_->file.schema(part.name);
    for (const files::Value& value : part.values)
        if (const files::FiledValue* const other = files::find_value(filed, value.name))
            files::set_value(value, *other);
}

}  // namespace glift
