// Updates of buffers, by `scatter` parameters with an operation: a thread combines what it writes to one element before
// it updates memory, where other threads update the same elements.
#pragma once

#include <glift/host/atomics.h>
#include <glift/host/parallel.h>
#include <glift/vector.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

namespace glift::host {

// The operations. combine: of two values of one thread. update: atomically, of an element. identity: combined with it,
// any value but NaN is itself.

namespace detail {
template <class T> constexpr T largest() {
    if constexpr (static_cast<T>(-1) < 0) return 0x7fffffff;
    else return 0xffffffff;
}
template <class T> constexpr T smallest() { return static_cast<T>(~largest<T>()); }
template <> constexpr float largest<float>() { return __builtin_nanf(""); }
template <> constexpr float smallest<float>() { return __builtin_nanf(""); }
}  // namespace detail

struct Add {
    template <class T> static constexpr T identity() { return -T(); }  // -0 for floats
    template <class T> static void combine(T& kept, T value) { kept += value; }
    template <class T> static void update(T& element, T value) { atomic_add(element, value); }
};
struct BitAnd {
    template <class T> static constexpr T identity() { return ~T(); }
    template <class T> static void combine(T& kept, T value) { kept &= value; }
    template <class T> static void update(T& element, T value) { atomic_bit_and(element, value); }
};
struct BitOr {
    template <class T> static constexpr T identity() { return 0; }
    template <class T> static void combine(T& kept, T value) { kept |= value; }
    template <class T> static void update(T& element, T value) { atomic_bit_or(element, value); }
};
struct BitXor {
    template <class T> static constexpr T identity() { return 0; }
    template <class T> static void combine(T& kept, T value) { kept ^= value; }
    template <class T> static void update(T& element, T value) { atomic_bit_xor(element, value); }
};

namespace detail {
/// As atomic_extremum: NaN only where there is no number.
template <class Before> void keep_extremum(float& kept, float value, const Before& before) {
    const bool is_better = kept != kept || before(ordered_bits(value), ordered_bits(kept));
    kept = value == value && is_better ? value : kept;
}
}  // namespace detail

struct Min {
    template <class T> static constexpr T identity() { return detail::largest<T>(); }
    template <class T> static void combine(T& kept, T value) { kept = value < kept ? value : kept; }
    static void combine(float& kept, float value) { detail::keep_extremum(kept, value, std::less<>()); }
    template <class T> static void update(T& element, T value) { atomic_min(element, value); }
};
struct Max {
    template <class T> static constexpr T identity() { return detail::smallest<T>(); }
    template <class T> static void combine(T& kept, T value) { kept = kept < value ? value : kept; }
    static void combine(float& kept, float value) { detail::keep_extremum(kept, value, std::greater<>()); }
    template <class T> static void update(T& element, T value) { atomic_max(element, value); }
};

/// What RowUpdate combines in place of values: of floats by min and max, ints in their order, which vectors compare
/// faster. NaN has the identity as its key.
template <class T, class Operation> struct KeyOf {
    using Key = T;
    static T key(T value) { return value; }
    static T value(T key) { return key; }
};
template <class Operation> struct OrderedKey {
    using Key = int;
    static int key(float value) { return value == value ? ordered_bits(value) : Operation::template identity<int>(); }
    static float value(int key) { return std::bit_cast<float>(key ^ (key >> 31 & 0x7fffffff)); }
};
template <> struct KeyOf<float, Min> : OrderedKey<Min> {};
template <> struct KeyOf<float, Max> : OrderedKey<Max> {};

/// The updates of one element by the elements of a row: lane i combines those of the elements i, i + row_lanes, …, so
/// that the C++ compiler can make a loop over the lanes vectors. In the end each lane i below row_branches combines the
/// lanes i, i + row_branches, …, and the first one combines those.
inline constexpr std::size_t row_lanes = 256, row_branches = 16;

/// The number of lanes that the elements [first, count) of a row take.
inline std::size_t lanes_from(std::size_t first, std::size_t count) {
    return count - first < row_lanes ? count - first : row_lanes;
}

/// `Index`: the type of indices of memory, whose largest value is that of no element.
template <class T, class Operation, class Index = uint> class RowUpdate {
public:
    /// `count`: the number of elements in the row.
    explicit RowUpdate(std::size_t count) : lanes_(lanes_from(0, count)) {
        for (std::size_t i = 0; i < lanes_; ++i) keys_[i] = Operation::template identity<Key>();
    }

    void add(Index index, std::size_t lane, T value) {
        index_ = index;
        Operation::combine(keys_[lane], KeyOf<T, Operation>::key(value));
    }

    /// Makes the update, unless no element has.
    template <class Updates> void finish(Updates& updates) {
        if (index_ != no_element) updates.add(index_, value());
    }

    /// What all elements combine to. Once only.
    T value() {
        for (std::size_t first = row_branches; first < lanes_; first += row_branches)
            for (std::size_t i = 0; i < row_branches && first + i < lanes_; ++i)
                Operation::combine(keys_[i], keys_[first + i]);
        for (std::size_t i = 1; i < row_branches && i < lanes_; ++i) Operation::combine(keys_[0], keys_[i]);
        return KeyOf<T, Operation>::value(keys_[0]);
    }

private:
    using Key = typename KeyOf<T, Operation>::Key;

    static constexpr Index no_element = static_cast<Index>(~Index{0});

    Index index_ = no_element;
    std::size_t lanes_;
    Key keys_[row_lanes];
};

/// A thread's copy of those pages of a buffer that it updates often enough.
template <class T, class Operation> class UpdateCopy {
public:
    static constexpr std::size_t page_elements = 256;

    /// The table of pages, null where there is no copy; null if none are worth it. `most`: of the pages that are
    /// copied.
    T** pages(std::size_t page_count, std::size_t most) {
        if (gave_up_) return nullptr;
        most_ = most;
        if (!pages_) pages_.reset(static_cast<T**>(std::calloc(page_count, sizeof(T*))));
        if (!pages_) throw std::bad_alloc();
        return pages_.get();
    }
    /// A page of the copy; null if it has none.
    const T* page(std::size_t number) const { return pages_ ? pages_[number] : nullptr; }

    /// Notes an update of a page that has no copy. Returns a copy of the page if it is time to make one, else null: a
    /// copy costs as much as some updates of memory, and many of them do not stay in a core's caches.
    T* miss(std::size_t page) {
        constexpr std::size_t updates_a_page = 8;
        ++misses_;
        if (is_full() || misses_ <= updates_a_page * copied_.size()) return nullptr;
        copied_.emplace_back(new T[page_elements]);
        T* copy = copied_.back().get();
        for (std::size_t i = 0; i < page_elements; ++i) copy[i] = Operation::template identity<T>();
        return pages_[page] = copy;
    }
    /// Makes no more use of copies if a task with so many updates of other pages shows that they do not help.
    bool give_up(std::size_t misses_of_task) {
        return gave_up_ = is_full() && misses_of_task > detail::task_elements / 2;
    }

private:
    bool is_full() const { return copied_.size() == most_; }

    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };
    std::unique_ptr<T*[], Free> pages_;
    std::vector<std::unique_ptr<T[]>> copied_;
    std::size_t misses_ = 0, most_ = 0;
    bool gave_up_ = false;
};

/// The copies of a buffer in one call: one for each thread. Memory gets them in the end.
template <class T, class Operation> class UpdateCopies {
public:
    using Copy = UpdateCopy<T, Operation>;

    /// `memory`: the number of the call's memory that is updated.
    UpdateCopies(const HostCall& call, std::size_t memory)
        : elements_(reinterpret_cast<T*>(call.memories[memory].data)), count_(call.memories[memory].bytes / sizeof(T)),
          updates_(std::size_t{call.size[0]} * call.size[1] * call.size[2] * call.size[3]),
          slots_(updates_ >= page_count() / 8 ? detail::thread_count() : 0) {}

    T* elements() const { return elements_; }
    std::size_t page_count() const { return (count_ + Copy::page_elements - 1) / Copy::page_elements; }
    /// How many pages a thread copies at most: a copy costs as much as some updates of each of its elements would save.
    std::size_t most_copies() const {
        const std::size_t updates_of_thread = updates_ / detail::most<std::size_t>(1, slots_.size());
        return detail::least<std::size_t>(4096, updates_of_thread / Copy::page_elements + 1);
    }

    /// A copy that no other task has; null where there are more tasks than threads.
    Copy* take() {
        for (Slot& slot : slots_)
            if (!__atomic_exchange_n(&slot.is_used, true, __ATOMIC_ACQUIRE)) return &slot.copy;
        return nullptr;
    }
    void give_back(const Copy* copy) {
        for (Slot& slot : slots_)
            if (&slot.copy == copy) return __atomic_store_n(&slot.is_used, false, __ATOMIC_RELEASE);
    }

    /// Combines memory with all copies, when all tasks have ended.
    void finish() const {
        detail::spread(page_count(), detail::task_elements / Copy::page_elements,
                       [this](std::size_t begin, std::size_t end) {
                           for (const Slot& slot : slots_)
                               for (std::size_t page = begin; page < end; ++page)
                                   if (const T* copy = slot.copy.page(page)) combine(page, copy);
                       });
    }

private:
    void combine(std::size_t page, const T* copy) const {
        const std::size_t first = page * Copy::page_elements;
        const std::size_t count = detail::least(Copy::page_elements, count_ - first);
        for (std::size_t i = 0; i < count; ++i) Operation::combine(elements_[first + i], copy[i]);
    }

    struct Slot {
        bool is_used = false;
        Copy copy;
    };
    T* elements_;
    std::size_t count_;
    std::size_t updates_;      ///< of the call, about
    std::vector<Slot> slots_;  ///< none: there are too few updates for tables of pages
};

/// The updates of one buffer by one task: in its thread's copy of a page, else in memory.
template <class T, class Operation> class Updates {
public:
    explicit Updates(UpdateCopies<T, Operation>& copies)
        : copies_(copies), copy_(copies.take()), elements_(copies.elements()),
          pages_(copy_ ? copy_->pages(copies.page_count(), copies.most_copies()) : nullptr) {}
    Updates(const Updates&) = delete;
    ~Updates() {
        if (copy_) copies_.give_back(copy_);
    }

    void add(uint index, T value) {
        if (!pages_) return Operation::update(elements_[index], value);
        T* page = pages_[index / page_elements];
        if (!page) page = miss(index / page_elements);
        if (!page) return Operation::update(elements_[index], value);
        Operation::combine(page[index % page_elements], value);
    }

private:
    static constexpr std::size_t page_elements = UpdateCopy<T, Operation>::page_elements;

    __attribute__((noinline, cold)) T* miss(std::size_t page) {
        if (copy_->give_up(++misses_)) pages_ = nullptr;
        return copy_->miss(page);
    }

    UpdateCopies<T, Operation>& copies_;
    UpdateCopy<T, Operation>* copy_;
    T* elements_;
    T** pages_;  ///< null: all updates are of memory
    std::size_t misses_ = 0;
};

}  // namespace glift::host
