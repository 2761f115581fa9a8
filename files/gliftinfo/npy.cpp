#include "npy.h"

#include "output.h"

namespace gliftinfo {

using namespace glift::files;

void write_npy(VerifiedFile& file, const Content& content, const std::string& to, const Progress& progress) {
    const std::vector<hsize_t> axes = with_field(content.axes(), content.field);
    Output output(to);
    output.write(npy_header(content.field.scalar, {axes.begin(), axes.end()}));
    read(file, content, [&](std::span<const std::byte> part) {
        output.write(part);
        progress(part.size());
    });
    output.close();
}

}  // namespace gliftinfo
