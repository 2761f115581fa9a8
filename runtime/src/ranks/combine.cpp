// Combines what the ranks' parts of a pass wrote to memories that every rank has.
#include "rank_stream.h"

#include <bit>
#include <cstring>

namespace glift::detail {

namespace {

using Words = std::vector<std::uint32_t>;

Words words_of(const std::vector<std::byte>& bytes) {
    Words words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), words.size() * 4);
    return words;
}

template <class T, class Less> std::uint32_t chosen(std::uint32_t a, std::uint32_t b, Less is_before) {
    return is_before(std::bit_cast<T>(b), std::bit_cast<T>(a)) ? b : a;
}

std::uint32_t least(Number number, std::uint32_t a, std::uint32_t b) {
    const auto less = [](auto x, auto y) { return x < y; };
    if (number == Number::real) return chosen<float>(a, b, less);
    return number == Number::signed_integer ? chosen<std::int32_t>(a, b, less) : chosen<std::uint32_t>(a, b, less);
}

std::uint32_t most(Number number, std::uint32_t a, std::uint32_t b) {
    const auto greater = [](auto x, auto y) { return x > y; };
    if (number == Number::real) return chosen<float>(a, b, greater);
    return number == Number::signed_integer ? chosen<std::int32_t>(a, b, greater)
                                            : chosen<std::uint32_t>(a, b, greater);
}

/// The word after one more rank's part of the pass, which changed it from `before` to `after`.
std::uint32_t combined(const Binding& binding, std::uint32_t word, std::uint32_t before, std::uint32_t after) {
    switch (binding.update) {
    case Update::min: return least(binding.number, word, after);
    case Update::max: return most(binding.number, word, after);
    case Update::add: return word + (after - before);
    case Update::bit_and: return word & after;
    case Update::bit_or: return word | after;
    case Update::bit_xor: return word ^ before ^ after;
    case Update::store:
    case Update::assign:
    case Update::other: break;
    }
    return after != before ? after : word;
}

}  // namespace

std::vector<RankStream::Before> RankStream::keep_before(const Kernel& kernel, const Call& call, const PassPlan& plan) {
    std::vector<Before> before;
    for (std::size_t k : plan.scattered) {
        const Update update = kernel.bindings[k].update;
        const bool needs_it = update == Update::store || update == Update::add || update == Update::bit_xor;
        before.push_back({k, needs_it ? copy_of(call.memories[k]) : Memory()});
    }
    return before;
}

void RankStream::combine(const Kernel& kernel, const Call& call, const std::vector<Before>& before) {
    for (const Before& one : before) {
        const Memory& memory = call.memories[one.binding];
        const std::vector<std::byte> mine = bytes_of(memory);
        const Words old = one.copy ? words_of(bytes_of(one.copy)) : Words(mine.size() / 4);
        const std::vector<std::vector<std::byte>> all = messenger_.all_gather(mine);
        statistics_.combined_bytes += mine.size() * (messenger_.size() - 1);
        ++statistics_.combinations;
        Words result = one.copy ? old : words_of(all[0]);
        for (const std::vector<std::byte>& bytes : all) {
            const Words words = words_of(bytes);
            for (std::size_t i = 0; i < words.size(); ++i)
                result[i] = combined(kernel.bindings[one.binding], result[i], old[i], words[i]);
        }
        const CopyRegion region = {0, 0, 4 * result.size()};
        local().upload(memory, {&region, 1}, std::as_bytes(std::span(result)));
    }
}

}  // namespace glift::detail
