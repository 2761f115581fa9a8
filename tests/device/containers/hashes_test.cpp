// Random insertions, erasures and searches of hash maps and sets, compared with std::unordered_map and with the order
// and the memory layout that the library promises.
#include "property.h"

#include "hashes.glift.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <unordered_map>

namespace {

using glift::uint2;
using property::Round;
using Number = std::uint32_t;

GLIFT_PROPERTY_SUITE(Hashes);

constexpr Number nothing = 0xffffffff;

Number hash(Number key) {
    const Number a = (key ^ key >> 16) * 0x7feb352d, b = (a ^ a >> 15) * 0x846ca68b;
    return b ^ b >> 16;
}

Number hash_of(uint2 key) { return hash(hash(key.x) ^ key.y); }
Number hash_of(Number key) { return hash(key); }

struct Hash {
    std::size_t operator()(const auto& key) const { return hash_of(key); }
};

/// The model: a map whose entries keep the order of insertion.
template <class Key> class Model {
public:
    explicit Model(Number capacity) : capacity_(capacity) {}

    void insert(Key key, Number value) {
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

    Number find(Key key) const {
        const auto at = numbers_.find(key);
        return at == numbers_.end() || !alive_[at->second] ? nothing : values_[at->second];
    }

    void tidy() {
        const std::vector<Key> keys = std::exchange(keys_, {});
        const std::vector<Number> values = std::exchange(values_, {}), alive = std::exchange(alive_, {});
        numbers_.clear();
        for (std::size_t i = 0; i < keys.size(); ++i)
            if (alive[i]) insert(keys[i], values[i]);
    }

    void clear() {
        tidy_none();
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
    const std::vector<Number>& values() const { return values_; }
    const std::vector<Number>& alive() const { return alive_; }

private:
    void tidy_none() {
        std::ranges::fill(alive_, 0);
        tidy();
    }

    Number capacity_, refused_ = 0;
    std::unordered_map<Key, Number, Hash> numbers_;
    std::vector<Key> keys_;
    std::vector<Number> values_, alive_;
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

std::vector<Number> numbers(Round& round, std::size_t n) {
    std::vector<Number> all(n);
    for (Number& each : all) each = round.below(1u << 31);
    return all;
}

/// Random keys out of `kinds` different ones, so that many are equal.
std::vector<uint2> keys(Round& round, Number kinds) {
    std::vector<uint2> all(1 + round.below(round.chance(3) ? 600 : 60));
    for (uint2& key : all) {
        const Number kind = round.below(kinds);
        key = {kind % 7, 0u - kind / 7};
    }
    return all;
}

class Maps {
public:
    Maps(const glift::Device& device, Round& round)
        : device_(device), round_(round), capacity_(1 + round.below(400)), kinds_(1 + round.below(600)),
          model_(capacity_), map_(device, capacity_) {
        round_.about("capacity " + std::to_string(capacity_) + ", keys " + std::to_string(kinds_));
    }

    void run() {
        for (int step = 0; step < 20 && !testing::Test::HasFailure(); ++step) {
            operate();
            ASSERT_TRUE(layout_is_right());
            ASSERT_TRUE(reads_are_right());
        }
    }

private:
    void operate() {
        const std::vector<uint2> some = keys(round_, kinds_);
        const auto given = on_device<hashes::Keys>(device_, some);
        switch (round_.below(8)) {
        case 0: map_.tidy(device_); return model_.tidy();
        case 1:
            if (!round_.chance(4)) break;
            map_.clear(device_);
            return model_.clear();
        case 2:
            map_.erase_all(device_, given);
            std::ranges::for_each(some, [&](uint2 key) { model_.erase(key); });
            return;
        case 3:
            hashes::erase(device_, given, map_);
            std::ranges::for_each(some, [&](uint2 key) { model_.erase(key); });
            return;
        default: break;
        }
        const std::vector<Number> values = numbers(round_, some.size());
        map_.insert_all(device_, given, on_device<hashes::Values>(device_, values));
        for (std::size_t i = 0; i < some.size(); ++i) model_.insert(some[i], values[i]);
    }

    testing::AssertionResult layout_is_right() {
        const std::size_t n = model_.keys().size();
        if (map_.entries(device_) != n) return round_.wrong("number of entries");
        if (map_.refused(device_) != model_.refused()) return round_.wrong("refused");
        if (auto same = property::equal(round_, model_.keys(), first(map_.keys().read(), n), "keys"); !same)
            return same;
        if (auto same = property::equal(round_, model_.values(), first(map_.values().read(), n), "values"); !same)
            return same;
        if (auto same = property::equal(round_, model_.alive(), first(map_.alive().read(), n), "alive"); !same)
            return same;
        return property::equal(round_, model_.index(), map_.index().read(), "index");
    }

    testing::AssertionResult reads_are_right() {
        const std::vector<uint2> asked = keys(round_, 2 * kinds_);
        const hashes::Values found(device_, static_cast<Number>(asked.size()));
        hashes::find(device_, on_device<hashes::Keys>(device_, asked), map_, found);
        std::vector<Number> expected;
        for (uint2 key : asked) expected.push_back(model_.find(key));
        return property::equal(round_, expected, found.read(), "find");
    }

    glift::Device device_;
    Round& round_;
    Number capacity_, kinds_;
    Model<uint2> model_;
    hashes::Map map_;
};

TEST_P(Hashes, MapsInBatches) {
    for_all("hash map", [&](Round& round) { Maps(device(), round).run(); });
}

/// Entries of a kernel have no order, so each key has one value in a pass. Invocations that insert a key at the same
/// moment may each take an entry; `tidy` removes the surplus ones.
TEST_P(Hashes, MapsFromKernels) {
    for_all("hash map, kernels", [&](Round& round) {
        constexpr Number capacity = 2000;
        hashes::Map map(device(), capacity);
        std::unordered_map<uint2, Number, Hash> model;
        for (int step = 0; step < 10 && !testing::Test::HasFailure(); ++step) {
            const std::vector<uint2> some = keys(round, 600);
            std::vector<Number> values;
            const Number seed = round.below(1u << 30);
            for (uint2 key : some) values.push_back(hash_of(key) + seed);
            const auto given = on_device<hashes::Keys>(device(), some);
            if (round.chance(3)) {
                hashes::erase(device(), given, map);
                for (uint2 key : some) model.erase(key);
            } else {
                if (map.entries(device()) + some.size() > capacity) map.tidy(device());
                hashes::insert(device(), given, on_device<hashes::Values>(device(), values), map);
                for (std::size_t i = 0; i < some.size(); ++i) model[some[i]] = values[i];
            }
            const std::vector<uint2> asked = keys(round, 900);
            const hashes::Values found(device(), static_cast<Number>(asked.size()));
            hashes::find(device(), on_device<hashes::Keys>(device(), asked), map, found);
            std::vector<Number> expected;
            for (uint2 key : asked) expected.push_back(model.contains(key) ? model[key] : nothing);
            ASSERT_TRUE(property::equal(round, expected, found.read(), "find"));
            ASSERT_EQ(map.size(device()).await(device()), model.size());
        }
    });
}

TEST_P(Hashes, Sets) {
    for_all("hash set", [&](Round& round) {
        const Number capacity = 1 + round.below(300), kinds = 1 + round.below(500);
        hashes::Set set(device(), capacity);
        Model<Number> model(capacity);
        for (int step = 0; step < 15 && !testing::Test::HasFailure(); ++step) {
            std::vector<Number> some = numbers(round, 1 + round.below(200));
            for (Number& key : some) key = hash(key % kinds);
            const auto given = on_device<hashes::Numbers>(device(), some);
            const Number kind = round.below(4);
            if (kind == 0) set.erase_all(device(), given);
            else if (kind == 1) set.tidy(device());
            else set.insert_all(device(), given);
            for (Number key : some) kind == 0 ? model.erase(key) : kind == 1 ? void() : model.insert(key, 1);
            if (kind == 1) model.tidy();
            std::vector<Number> expected;
            for (std::size_t i = 0; i < model.keys().size(); ++i)
                if (model.alive()[i]) expected.push_back(model.keys()[i]);
            const hashes::Numbers listed(device(), capacity);
            const Number n = set.list(device(), listed).await(device());
            ASSERT_TRUE(property::equal(round, expected, first(listed.read(), n), "keys"));
            ASSERT_EQ(set.refused(device()), model.refused());
        }
    });
}

TEST_P(Hashes, BitSets) {
    for_all("bit set", [&](Round& round) {
        const Number bound = round.below(3000);
        hashes::Bits set(device(), bound);
        std::set<Number> model;
        for (int step = 0; step < 15 && !testing::Test::HasFailure(); ++step) {
            std::vector<Number> some = numbers(round, 1 + round.below(300));
            for (Number& x : some) x = x % (bound + 40);
            const auto given = on_device<hashes::Numbers>(device(), some);
            const bool erases = round.chance(3);
            if (erases) hashes::erase_bits(device(), given, set);
            else hashes::insert_bits(device(), given, set);
            for (Number x : some) {
                if (erases) model.erase(x);
                else if (x < bound) model.insert(x);
            }
            const hashes::Numbers listed(device(), bound + 1);
            const Number n = set.numbers(device(), listed).await(device());
            const std::vector<Number> expected(model.begin(), model.end());
            ASSERT_TRUE(property::equal(round, expected, first(listed.read(), n), "numbers"));
        }
    });
}

}  // namespace
