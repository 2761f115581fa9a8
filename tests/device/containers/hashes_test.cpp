// Random insertions, erasures and searches of hash maps and sets, compared with std::unordered_map and with the order
// and the memory layout that the library promises.
#include "hash_model.h"

#include <set>

namespace {

using namespace hash_model;
using glift::uint2;
using property::Round;

GLIFT_PROPERTY_SUITE(Hashes);

std::vector<Number> numbers(Round& round, std::size_t n) {
    std::vector<Number> all(n);
    for (Number& each : all) each = round.below(1u << 31);
    return all;
}

/// A float for the number `kind`: a zero of either sign, a NaN, a subnormal, infinity or -1e30, or an ordinary number.
float some_float(Round& round, Number kind) {
    switch (kind % 8) {
    case 0: return round.chance(2) ? -0.0f : 0.0f;
    case 1: return round.chance(2) ? std::numeric_limits<float>::quiet_NaN() : std::bit_cast<float>(0xffc00001u);
    case 2: return std::bit_cast<float>(kind);  // subnormal
    case 3: return kind % 16 == 3 ? std::numeric_limits<float>::infinity() : -1e30f;
    default: return 0.37f * static_cast<float>(kind) - 50;
    }
}

/// These structs name the types of a map or set and its kernels, and make keys and values. Keys are pairs of integers
/// (Pairs), floats (OfFloats), structs (OfSpots), or integers of a set (OfNumbers).
struct Pairs {
    using Key = uint2;
    using Value = Number;
    using Map = hashes::Map;
    using Keys = hashes::Keys;
    using Values = hashes::Values;
    static constexpr auto insert = hashes::insert;
    static constexpr auto erase = hashes::erase;
    static constexpr auto find = hashes::find;
    static Key key(Round&, Number kind) { return {kind % 7, 0u - kind / 7}; }
    static Value value(Number number) { return number; }
};

struct OfFloats {
    using Key = float;
    using Value = hashes::Share;
    using Map = hashes::FloatMap;
    using Set = hashes::FloatSet;
    using Keys = hashes::Floats;
    using Values = hashes::Shares;
    static constexpr auto insert = hashes::insert_float;
    static constexpr auto erase = hashes::erase_float;
    static constexpr auto find = hashes::find_float;
    static Key key(Round& round, Number kind) { return some_float(round, kind); }
    static Value value(Number number) {
        const auto x = static_cast<float>(number % 1000);
        return {{x, -x, 0.5f * x}, number, 0.25f * x};
    }
};

struct OfSpots {
    using Key = hashes::Spot;
    using Value = float;
    using Map = hashes::SpotMap;
    using Set = hashes::SpotSet;
    using Keys = hashes::Spots;
    using Values = hashes::Floats;
    static constexpr auto insert = hashes::insert_spot;
    static constexpr auto erase = hashes::erase_spot;
    static constexpr auto find = hashes::find_spot;
    static Key key(Round& round, Number kind) {
        return {{some_float(round, kind), some_float(round, kind / 8 * 2)}, -static_cast<int>(kind % 3)};
    }
    static Value value(Number number) { return 0.5f * static_cast<float>(number % 100000); }
};

struct OfNumbers {
    using Key = Number;
    using Set = hashes::Set;
    using Keys = hashes::Numbers;
    static Key key(Round&, Number kind) { return hash(kind); }
};

/// Maps and sets with keys of one word, in no order.
struct OfWords {
    using Key = Number;
    using Value = hashes::Share;
    using Map = hashes::WordMap;
    using Keys = hashes::Numbers;
    using Values = hashes::Shares;
    static constexpr auto insert = hashes::insert_word;
    static constexpr auto erase = hashes::erase_word;
    static constexpr auto find = hashes::find_word;
    /// Some of the keys are those that a place cannot tell from a free or an erased one.
    static Key key(Round&, Number kind) { return kind < 4 ? 2654435769u ^ kind : kind % 2 == 0 ? kind : hash(kind); }
    static Value value(Number number) { return OfFloats::value(number); }
};

struct OfWordFloats : OfFloats {
    using Map = hashes::WordFloatMap;
    static constexpr auto insert = hashes::insert_word_float;
    static constexpr auto erase = hashes::erase_word_float;
    static constexpr auto find = hashes::find_word_float;
};

/// Random keys: each is the key of a random number below `kinds`, so that keys repeat where `kinds` is small.
template <class Kind> std::vector<typename Kind::Key> keys(Round& round, Number kinds) {
    std::vector<typename Kind::Key> all(1 + round.below(round.chance(3) ? 600 : 60));
    for (auto& key : all) key = Kind::key(round, round.below(kinds));
    return all;
}

template <class Kind> class Maps {
    using Key = typename Kind::Key;
    using Value = typename Kind::Value;

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
        const std::vector<Key> some = keys<Kind>(round_, kinds_);
        const auto given = on_device<typename Kind::Keys>(device_, some);
        switch (round_.below(8)) {
        case 0: map_.rehash(device_); return model_.rehash();
        case 1:
            if (!round_.chance(4)) break;
            map_.clear(device_);
            return model_.clear();
        case 2:
            map_.erase_all(device_, given);
            std::ranges::for_each(some, [&](Key key) { model_.erase(key); });
            return;
        case 3:
            Kind::erase(device_, given, map_);
            std::ranges::for_each(some, [&](Key key) { model_.erase(key); });
            return;
        default: break;
        }
        std::vector<Value> values;
        for (Number each : numbers(round_, some.size())) values.push_back(Kind::value(each));
        map_.insert_all(device_, given, on_device<typename Kind::Values>(device_, values));
        for (std::size_t i = 0; i < some.size(); ++i) model_.insert(some[i], values[i]);
    }

    testing::AssertionResult layout_is_right() {
        const std::size_t n = model_.keys().size();
        if (map_.entries(device_) != n) return round_.wrong("number of entries");
        if (map_.refused(device_) != model_.refused()) return round_.wrong("refused");
        if (auto same = same_bits(round_, model_.keys(), first(map_.keys().read(), n), "keys"); !same) return same;
        if (auto same = same_bits(round_, model_.values(), first(map_.values().read(), n), "values"); !same)
            return same;
        if (auto same = property::equal(round_, model_.alive(), first(map_.alive().read(), n), "alive"); !same)
            return same;
        return property::equal(round_, model_.index(), map_.index().read(), "index");
    }

    testing::AssertionResult reads_are_right() {
        const std::vector<Key> asked = keys<Kind>(round_, 2 * kinds_);
        const Value nothing = Kind::value(0x7fffffff);
        const typename Kind::Values found(device_, static_cast<Number>(asked.size()));
        Kind::find(device_, on_device<typename Kind::Keys>(device_, asked), map_, nothing, found);
        std::vector<Value> expected;
        for (Key key : asked) expected.push_back(model_.find(key).value_or(nothing));
        return same_bits(round_, expected, found.read(), "find");
    }

    glift::Device device_;
    Round& round_;
    Number capacity_, kinds_;
    Model<Key, Value> model_;
    typename Kind::Map map_;
};

TEST_P(Hashes, MapsInBatches) {
    for_all("hash map", [&](Round& round) { Maps<Pairs>(device(), round).run(); });
}

TEST_P(Hashes, MapsOfFloatsInBatches) {
    for_all("hash map of floats", [&](Round& round) { Maps<OfFloats>(device(), round).run(); });
}

TEST_P(Hashes, MapsOfStructsInBatches) {
    for_all("hash map of structs", [&](Round& round) { Maps<OfSpots>(device(), round).run(); });
}

Number entries_of(const glift::Device& device, auto& map) {
    if constexpr (requires { map.entries(device).await(device); }) return map.entries(device).await(device);
    else return map.entries(device);
}

/// The invocations of a kernel insert in no particular order, so the test gives equal keys equal values within a pass.
/// Invocations that insert one key at the same moment may each take an entry; `rehash` removes the surplus ones.
template <class Kind> void maps_from_kernels(const glift::Device& device, Round& round) {
    using Key = typename Kind::Key;
    using Value = typename Kind::Value;
    constexpr Number capacity = 2000;
    const Value nothing = Kind::value(0x7fffffff);
    typename Kind::Map map(device, capacity);
    std::unordered_map<Key, Value, Hash> model;
    Number refused = 0;
    for (int step = 0; step < 10 && !testing::Test::HasFailure(); ++step) {
        const std::vector<Key> some = keys<Kind>(round, 600);
        std::vector<Value> values;
        const Number seed = round.below(1u << 30);
        for (Key key : some) values.push_back(Kind::value(hash_of(key) + seed));
        const auto given = on_device<typename Kind::Keys>(device, some);
        if (round.chance(3)) {
            Kind::erase(device, given, map);
            for (Key key : some) model.erase(key);
        } else {
            if (entries_of(device, map) + some.size() > capacity) map.rehash(device);
            Kind::insert(device, given, on_device<typename Kind::Values>(device, values), map);
            for (std::size_t i = 0; i < some.size(); ++i) {
                if (can_be_a_key(some[i])) model[some[i]] = values[i];
                else ++refused;
            }
        }
        const std::vector<Key> asked = keys<Kind>(round, 900);
        const typename Kind::Values found(device, static_cast<Number>(asked.size()));
        Kind::find(device, on_device<typename Kind::Keys>(device, asked), map, nothing, found);
        std::vector<Value> expected;
        for (Key key : asked) expected.push_back(model.contains(key) ? model[key] : nothing);
        ASSERT_TRUE(same_bits(round, expected, found.read(), "find"));
        ASSERT_EQ(map.size(device).await(device), model.size());
        ASSERT_EQ(map.refused(device), refused);
    }
}

TEST_P(Hashes, MapsFromKernels) {
    for_all("hash map, kernels", [&](Round& round) { maps_from_kernels<Pairs>(device(), round); });
}

TEST_P(Hashes, MapsOfFloatsFromKernels) {
    for_all("hash map of floats, kernels", [&](Round& round) { maps_from_kernels<OfFloats>(device(), round); });
}

TEST_P(Hashes, MapsOfStructsFromKernels) {
    for_all("hash map of structs, kernels", [&](Round& round) { maps_from_kernels<OfSpots>(device(), round); });
}

TEST_P(Hashes, MapsOfWordsFromKernels) {
    for_all("hash map of words, kernels", [&](Round& round) { maps_from_kernels<OfWords>(device(), round); });
}

TEST_P(Hashes, MapsOfFloatWordsFromKernels) {
    for_all("hash map of words of floats", [&](Round& round) { maps_from_kernels<OfWordFloats>(device(), round); });
}

/// Batches of keys against a map of the standard library, where room runs out, too.
TEST_P(Hashes, MapsOfWordsInBatches) {
    for_all("hash map of words", [&](Round& round) {
        const Number capacity = 1 + round.below(400), kinds = 1 + round.below(600);
        hashes::WordMap map(device(), capacity);
        std::unordered_map<Number, Number> model;  // the number of the value
        Number taken = 0;
        for (int step = 0; step < 20 && !testing::Test::HasFailure(); ++step) {
            const std::vector<Number> some = keys<OfWords>(round, kinds);
            const auto given = on_device<hashes::Numbers>(device(), some);
            if (round.chance(4)) {
                map.erase_all(device(), given);
                for (Number key : some) model.erase(key);
            } else if (round.chance(4)) {
                map.rehash(device());
                taken = static_cast<Number>(model.size());
            } else {
                std::set<Number> fresh(some.begin(), some.end());
                std::erase_if(fresh, [&](Number key) { return model.contains(key); });
                if (taken + fresh.size() > capacity) {  // which keys are refused is not determined
                    map.clear(device());
                    model.clear();
                    taken = 0;
                    continue;
                }
                std::vector<hashes::Share> values;
                for (Number key : some) values.push_back(OfWords::value(hash_of(key) + step));
                map.insert_all(device(), given, on_device<hashes::Shares>(device(), values));
                for (Number key : some) model[key] = hash_of(key) + step;
                taken = entries_of(device(), map);
            }
            const hashes::Numbers listed(device(), capacity);
            const hashes::Shares shares(device(), capacity);
            const Number n = map.list_keys(device(), listed).await(device());
            ASSERT_EQ(n, model.size());
            ASSERT_EQ(map.list_values(device(), shares).await(device()), n);
            ASSERT_EQ(map.size(device()).await(device()), n);
            std::vector<hashes::Share> expected;
            for (Number key : first(listed.read(), n)) expected.push_back(OfWords::value(model.at(key)));
            ASSERT_TRUE(same_bits(round, expected, first(shares.read(), n), "values"));
        }
    });
}

template <class Kind> void sets(const glift::Device& device, Round& round) {
    using Key = typename Kind::Key;
    const Number capacity = 1 + round.below(300), kinds = 1 + round.below(500);
    typename Kind::Set set(device, capacity);
    Model<Key, Number> model(capacity);
    for (int step = 0; step < 15 && !testing::Test::HasFailure(); ++step) {
        std::vector<Key> some(1 + round.below(200));
        for (Key& key : some) key = Kind::key(round, round.below(kinds));
        const auto given = on_device<typename Kind::Keys>(device, some);
        const Number kind = round.below(4);
        if (kind == 0) set.erase_all(device, given);
        else if (kind == 1) set.rehash(device);
        else set.insert_all(device, given);
        for (Key key : some) kind == 0 ? model.erase(key) : kind == 1 ? void() : model.insert(key, 1);
        if (kind == 1) model.rehash();
        std::vector<Key> expected;
        for (std::size_t i = 0; i < model.keys().size(); ++i)
            if (model.alive()[i]) expected.push_back(model.keys()[i]);
        const typename Kind::Keys listed(device, capacity);
        const Number n = set.list(device, listed).await(device);
        ASSERT_TRUE(same_bits(round, expected, first(listed.read(), n), "keys"));
        ASSERT_EQ(set.refused(device), model.refused());
    }
}

TEST_P(Hashes, Sets) {
    for_all("hash set", [&](Round& round) { sets<OfNumbers>(device(), round); });
}

TEST_P(Hashes, SetsOfFloats) {
    for_all("hash set of floats", [&](Round& round) { sets<OfFloats>(device(), round); });
}

TEST_P(Hashes, SetsOfStructs) {
    for_all("hash set of structs", [&](Round& round) { sets<OfSpots>(device(), round); });
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
            const Number n = set.list(device(), listed).await(device());
            const std::vector<Number> expected(model.begin(), model.end());
            ASSERT_TRUE(property::equal(round, expected, first(listed.read(), n), "numbers"));
        }
    });
}

}  // namespace
