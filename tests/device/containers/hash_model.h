// A model on the host of std.ordered_hash_map and std.ordered_hash_set: a std::unordered_map, with the order of the
// entries and the layout of the index that the library promises.
#pragma once

#include "property.h"

#include "hashes.glift.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hash_model {

using Number = std::uint32_t;

inline Number hash(Number key) {
    const Number a = (key ^ key >> 16) * 0x7feb352d, b = (a ^ a >> 15) * 0x846ca68b;
    return b ^ b >> 16;
}

inline Number hash_of(Number key) { return hash(key); }
inline Number hash_of(glift::uint2 key) { return hash(hash(key.x) ^ key.y); }
inline Number hash_of(float key) { return hash(std::bit_cast<Number>(key == 0 ? 0.0f : key)); }
inline Number hash_of(glift::float2 key) { return hash(hash(hash_of(key.x)) ^ hash_of(key.y)); }
inline Number hash_of(const hashes::Spot& key) { return hash(hash_of(key.at) ^ hash(static_cast<Number>(key.level))); }

struct Hash {
    std::size_t operator()(const auto& key) const { return hash_of(key); }
};

/// Whether a key is equal to itself: it has no NaN.
template <class Key> bool can_be_a_key(const Key& key) { return key == Key(key); }

/// A map whose entries keep the order of insertion. Of keys that are equal but differ in their bits (0 and -0) it keeps
/// the one that was inserted first.
template <class Key, class Value> class Model {
public:
    explicit Model(Number capacity) : capacity_(capacity) {}

    void insert(Key key, Value value) {
        if (!can_be_a_key(key)) {
            ++refused_;
            return;
        }
        const auto [at, is_new] = numbers_.try_emplace(key, static_cast<Number>(keys_.size()));
        if (is_new && keys_.size() == capacity_) {
            numbers_.erase(at);
            ++refused_;
            return;
        }
        if (is_new) {
            keys_.push_back(key);
            values_.push_back(value);
            alive_.push_back(1);
        }
        values_[at->second] = value;
        alive_[at->second] = 1;
    }

    void erase(Key key) {
        if (const auto at = numbers_.find(key); at != numbers_.end()) alive_[at->second] = 0;
    }

    std::optional<Value> find(Key key) const {
        const auto at = numbers_.find(key);
        return at == numbers_.end() || !alive_[at->second] ? std::nullopt : std::optional(values_[at->second]);
    }

    void rehash() {
        const std::vector<Key> keys = std::exchange(keys_, {});
        const std::vector<Value> values = std::exchange(values_, {});
        const std::vector<Number> alive = std::exchange(alive_, {});
        numbers_.clear();
        for (std::size_t i = 0; i < keys.size(); ++i)
            if (alive[i]) insert(keys[i], values[i]);
    }

    void clear() {
        std::ranges::fill(alive_, 0);
        rehash();
        refused_ = 0;
    }

    /// The hash table: linear probing from each key's slot, in the order of the entries.
    std::vector<Number> index() const {
        std::vector<Number> places(2 * capacity_);
        for (Number number = 0; number < keys_.size(); ++number) {
            Number place = hash_of(keys_[number]) % (2 * capacity_);
            while (places[place]) place = (place + 1) % (2 * capacity_);
            places[place] = ~number;
        }
        return places;
    }

    Number refused() const { return refused_; }
    const std::vector<Key>& keys() const { return keys_; }
    const std::vector<Value>& values() const { return values_; }
    const std::vector<Number>& alive() const { return alive_; }

private:
    Number capacity_, refused_ = 0;
    std::unordered_map<Key, Number, Hash> numbers_;
    std::vector<Key> keys_;
    std::vector<Value> values_;
    std::vector<Number> alive_;
};

template <class T> std::vector<T> first(std::vector<T> all, std::size_t n) {
    all.resize(n);
    return all;
}

template <class Line, class T> Line on_device(const glift::Device& device, const std::vector<T>& all) {
    Line line(device, static_cast<Number>(all.size()));
    line.write(all);
    return line;
}

/// Compares bit for bit, structs too: 0 is not -0.
template <class T> testing::AssertionResult same_bits(const property::Round& round, const std::vector<T>& expected,
                                                      const std::vector<T>& found, const char* which) {
    using Words = std::array<Number, sizeof(T) / sizeof(Number)>;
    const auto words = [](const std::vector<T>& all) {
        std::vector<Words> words;
        for (const T& each : all) words.push_back(std::bit_cast<Words>(each));
        return words;
    };
    return property::equal(round, words(expected), words(found), which);
}

}  // namespace hash_model
