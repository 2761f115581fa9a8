// How a broken promise (@disjoint) is found: the pass is run again while the elements that it writes hold other values,
// but only for reads through the parameter that promises not to read them. If that changes any result, some invocation
// has read such an element.
#include "promises.h"

#include "../text.h"

#include <glift/error.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <string_view>
#include <vector>

namespace glift::detail {

namespace {

using Bytes = std::vector<std::byte>;

/// Bits that are flipped in a word, one in each run. Both change a word by little, so that a loop that runs as often as
/// the word says still ends; the second one also changes a bool.
constexpr std::uint32_t changes[] = {0x40, 0x01};

bool writes(const Binding& binding) { return binding.access != Access::read; }

bool is_promised(const Binding& read, const Binding& written) {
    return !writes(read) && writes(written) && read.is_apart_from(written.parameter);
}

void change_word(Bytes& bytes, std::size_t word, std::uint32_t by) {
    std::uint32_t value;
    std::memcpy(&value, bytes.data() + 4 * word, 4);
    value ^= by;
    std::memcpy(bytes.data() + 4 * word, &value, 4);
}

std::string_view parameter_of(const Binding& binding) {
    const std::string_view name = binding.name;
    return name.substr(0, name.find('.'));
}

/// Checks one promise of a call: that what it writes to a memory through the binding `written` is not read through the
/// binding `read` of the same memory.
class Promise {
public:
    Promise(const Kernel& kernel, const Form& form, std::span<const Memory> memories, const HostCall& call,
            std::size_t read, std::size_t written)
        : kernel_(kernel), form_(form), memories_(memories), call_(call), read_(read), written_(written) {
        const HostMemory& memory = call.memories[read];
        before_.assign(memory.data, memory.data + memory.bytes);
    }

    void check() {
        const Outcome plain = run(before_, before_);
        if (run(before_, before_) != plain) return;  // results depend on the order of invocations: nothing can be said
        const std::vector<std::size_t> words = written_words(plain);
        for (std::uint32_t by : changes)
            if (differs(words, by, plain)) refuse(found(words, by, plain));
    }

private:
    /// The contents after the call of the memories that it writes, by the address of the memory's first byte.
    using Outcome = std::map<const std::byte*, Bytes>;

    /// Runs the call on copies. The memory holds `seen` for reads through each parameter that promises not to read what
    /// `written` writes; for all other parameters it holds `initial` before the call.
    Outcome run(const Bytes& seen, const Bytes& initial) const {
        Outcome copies;
        for (std::size_t i = 0; i < memories_.size(); ++i) {
            const HostMemory& memory = call_.memories[i];
            if (!writes(kernel_.bindings[i])) continue;
            copies.try_emplace(memory.data, memory.data, memory.data + memory.bytes);
        }
        copies.at(call_.memories[written_].data) = initial;
        Bytes read = seen;
        std::vector<HostMemory> views(call_.memories.begin(), call_.memories.end());
        for (std::size_t i = 0; i < views.size(); ++i) {
            const auto copy = copies.find(views[i].data);
            const bool is_seen = memories_[i].object() == memories_[read_].object() &&
                                 is_promised(kernel_.bindings[i], kernel_.bindings[written_]);
            if (is_seen) views[i].data = read.data();
            else if (copy != copies.end()) views[i].data = copy->second.data();
        }
        HostCall again = call_;
        StatusRecord record;
        again.memories = views;
        again.status = &record;
        MessageHeader no_messages;
        again.messages = &no_messages;
        form_.host(again);
        return copies;
    }

    /// The words that the call writes: those that it changes, and those whose value after the call does not depend on
    /// their value before it.
    std::vector<std::size_t> written_words(const Outcome& plain) const {
        Bytes other = before_;
        const std::size_t count = before_.size() / 4;
        for (std::size_t word = 0; word < count; ++word) change_word(other, word, changes[0] | changes[1]);
        const std::byte* const memory = call_.memories[written_].data;
        const Outcome over_other = run(before_, other);
        const Bytes &one = plain.at(memory), &two = over_other.at(memory);
        std::vector<std::size_t> words;
        for (std::size_t word = 0; word < count; ++word) {
            const bool is_changed = std::memcmp(&one[4 * word], &before_[4 * word], 4) != 0;
            if (is_changed || std::memcmp(&one[4 * word], &two[4 * word], 4) == 0) words.push_back(word);
        }
        return words;
    }

    /// Whether changing these words, for the promising parameter alone, changes any result.
    bool differs(std::span<const std::size_t> words, std::uint32_t by, const Outcome& plain) const {
        if (words.empty()) return false;
        Bytes seen = before_;
        for (std::size_t word : words) change_word(seen, word, by);
        return run(seen, before_) != plain;
    }

    /// A word whose change changes a result, found by bisection.
    std::size_t found(std::span<const std::size_t> words, std::uint32_t by, const Outcome& plain) const {
        while (words.size() > 1) {
            const auto half = words.first(words.size() / 2);
            words = differs(half, by, plain) ? half : words.subspan(half.size());
        }
        return words[0];
    }

    [[noreturn]] void refuse(std::size_t word) const {
        const Binding &read = kernel_.bindings[read_], &written = kernel_.bindings[written_];
        const std::string from(parameter_of(read)), to(parameter_of(written));
        const bool is_buffer = read.kind == MemoryKind::buffer;
        throw Error(ErrorCode::aliased_memory,
                    "'" + from + "' reads what '" + to +
                        "' writes in the same pass, though the kernel promises that it "
                        "does not",
                    kernel_text(kernel_) + ", " + memory_text(memories_[read_].description()),
                    is_buffer ? "element " + std::to_string(4 * word / read.element_bytes) + " of " + read.name +
                                    " is read by one invocation and written by one"
                              : "byte " + std::to_string(4 * word) + " of " + read.name + " is read and written",
                    "write into another structure, or take back @disjoint(" + from + ", " + to + ")");
    }

    const Kernel& kernel_;
    const Form& form_;
    std::span<const Memory> memories_;
    const HostCall& call_;
    std::size_t read_, written_;
    Bytes before_;
};

/// Calls `visit(read, written)` with the indices of each two bindings of one memory that a promise is about.
template <class Visit> void for_each_promise(const Kernel& kernel, std::span<const Memory> memories, Visit&& visit) {
    for (std::size_t read = 0; read < memories.size(); ++read)
        for (std::size_t written = 0; written < memories.size(); ++written)
            if (memories[read].object() == memories[written].object() &&
                is_promised(kernel.bindings[read], kernel.bindings[written]))
                visit(read, written);
}

}  // namespace

bool relies_on_promise(const Kernel& kernel, std::span<const Memory> memories) {
    bool relies = false;
    for_each_promise(kernel, memories, [&](std::size_t, std::size_t) { relies = true; });
    return relies;
}

void check_promises(const Kernel& kernel, const Form& form, std::span<const Memory> memories, const HostCall& call) {
    for_each_promise(kernel, memories, [&](std::size_t read, std::size_t written) {
        Promise(kernel, form, memories, call, read, written).check();
    });
}

}  // namespace glift::detail
