// Whether what a file has of a structure fits the structure into which it is loaded.
#pragma once

#include "schema.h"

#include <glift/files.h>

namespace glift::files {

enum class LoadWay {
    as_it_was,   ///< all parts become what they were; memories of other sizes are replaced
    by_address,  ///< elements go to their addresses
};

/// Decides how to load, and fills the report. Throws wrong_argument, with both sides and the remedy, where the file
/// does not fit.
LoadWay match(const FiledPart& filed, const Part& part, const std::string& file, LoadReport& report);

/// The field of a memory in a file; null: the file has none of that name. Throws wrong_argument where it has another
/// type.
const Field* find_field(const FiledMemory& memory, const Field& field, const std::string& what);

/// The file's value of a name; null: it has none.
const FiledValue* find_value(const FiledPart& part, const std::string& name);

/// Puts the file's bytes into a value, field by field.
void set_value(const Value& value, const FiledValue& filed);

}  // namespace glift::files
