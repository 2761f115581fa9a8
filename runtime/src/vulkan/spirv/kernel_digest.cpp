#include "kernel_digest.h"

#include "spirv_words.h"

namespace glift::detail {

namespace {

/// FNV-1a, word by word.
class Digest {
public:
    void add(std::uint64_t value) { hash_ = (hash_ ^ value) * 1099511628211u; }
    void add(std::string_view text) {
        for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
        add(text.size());
    }
    void add(const Binding& binding) {
        add(std::string_view(binding.name));
        add(static_cast<std::uint64_t>(binding.as_bits) << 32 |
            static_cast<std::uint64_t>(binding.sampler.compare) << 36 | static_cast<std::uint64_t>(binding.kind) << 24 |
            static_cast<std::uint64_t>(binding.access) << 16 | static_cast<std::uint64_t>(binding.sampled) << 8 |
            static_cast<std::uint64_t>(binding.sampler.filter) << 4 |
            static_cast<std::uint64_t>(binding.sampler.address));
        add(binding.address_offset);
    }
    void add(const Drawing& drawing) {
        add(static_cast<std::uint64_t>(drawing.topology) << 24 | static_cast<std::uint64_t>(drawing.cull) << 16 |
            static_cast<std::uint64_t>(drawing.depth_test) << 8 | static_cast<std::uint64_t>(drawing.writes_depth));
        add(drawing.derives_loads);
        for (const ColourTarget& target : drawing.colours)
            add(static_cast<std::uint64_t>(target.format) << 8 | static_cast<std::uint64_t>(target.blend));
        add(drawing.depth != nullptr);
    }
    void add(const Form& form) {
        for (const Spirv& part : {form.spirv, form.fragment})
            for (const std::uint32_t word : words_of(part)) add(word);
        add(form.parameter_bytes);
        add(form.push_constants);
        add(form.uniform_buffer);
        add(form.size_offset);
        add(form.base_offset);
    }
    std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 14695981039346656037u;
};

std::uint64_t digest_of_contents(const Kernel& kernel) {
    Digest digest;
    digest.add(std::string_view(kernel.name));
    digest.add(std::string_view(kernel.file));
    digest.add(kernel.line);
    digest.add(kernel.rank);
    for (const std::uint32_t size : kernel.group) digest.add(size);
    for (const std::uint32_t count : kernel.items) digest.add(count);
    digest.add(kernel.loop_rounds);
    for (const Binding& binding : kernel.bindings) digest.add(binding);
    for (const Form* form : {&kernel.direct, &kernel.general}) digest.add(*form);
    if (kernel.drawing) digest.add(*kernel.drawing);
    digest.add(kernel.reports);
    digest.add(kernel.shared_bytes);
    for (const char* file : kernel.other_files) digest.add(std::string_view(file));
    for (const MessageFormat& format : kernel.messages) {
        digest.add(std::string_view(format.text));
        digest.add(std::string_view(format.file));
        digest.add(std::uint64_t{format.line} << 1 | static_cast<std::uint64_t>(format.is_assertion));
    }
    digest.add(kernel.address_rank);
    return digest.value();
}

}  // namespace

std::uint64_t digest_of(const Kernel& kernel) { return kernel.digest ? kernel.digest : digest_of_contents(kernel); }

}  // namespace glift::detail
