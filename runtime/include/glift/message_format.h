// Messages of `print` and `assert` as kernels write them: words in a buffer, and what the words mean.
#pragma once

#include <cstdint>

namespace glift {

/// A message that a kernel may print. `text` has a placeholder for each scalar that the message prints; `{{` and `}}`
/// stand for braces. Placeholders: {b} bool, {i} int, {u} uint, {f} float, {h} half, whose word is that of a float,
/// {d} double, {I} int64, {U} uint64, and {e 0=red 1=green}, an enum with its enumerators. {d}, {I} and {U} take two
/// words, the lower half first; the others take one.
struct MessageFormat {
    const char* text;
    const char* file;
    std::uint32_t line;
    bool is_assertion = false;
};

/// The begin of a buffer of messages, which `capacity` words follow; the first `used` of them are taken, or more than
/// there are. A message is one word, its number in Kernel::messages plus 1, then the address of the visited element,
/// then its scalars. Messages that do not fit are counted in `lost`, and overflows of that in `lost_high`. Before a
/// pass the runtime appends one word that names the kernel. A word that is zero ends the messages.
struct MessageHeader {
    std::uint32_t used = 0, lost = 0, lost_high = 0, capacity = 0;
};

}  // namespace glift
