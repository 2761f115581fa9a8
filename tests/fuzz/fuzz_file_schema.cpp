// Parses arbitrary bytes as the schema of a saved structure: there must be no crash, hang or sanitizer report, and no
// error other than bad_file. A schema that is read is written and read again, which must give the same text.

#include "schema.h"

#include <glift/error.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        const std::string once = glift::files::text_of(glift::files::parse_schema(text, "fuzz.h5"));
        if (glift::files::text_of(glift::files::parse_schema(once, "fuzz.h5")) != once) std::abort();
    } catch (const glift::Error& error) {
        if (error.code() != glift::ErrorCode::bad_file) std::abort();
    }
    return 0;
}
