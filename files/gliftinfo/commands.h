// The commands of gliftinfo. Each returns the exit status.
#pragma once

#include <string>
#include <vector>

namespace gliftinfo {

/// Prints the structures of a file: type, arguments, what they keep on the host, memories.
int print(const std::string& file);
/// Verifies every piece of the files; 1: one is damaged.
int check(const std::vector<std::string>& files);
/// Compares all values and numbers of two files; 1: they differ.
int diff(const std::string& first, const std::string& second);
/// Writes the numbers at a path to a file of the kind that its name ends with: .npy, .vti, .nvdb.
int convert(const std::string& file, const std::string& path, const std::string& to);
/// Saves a NumPy array as a structure of this name, to a file of its own. The last axes are those of an element.
int convert_npy(const std::string& array, const std::string& name, const std::string& to, unsigned element_axes);

}  // namespace gliftinfo
