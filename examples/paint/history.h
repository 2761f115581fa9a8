// Strokes that can be undone and done again: pages before and after, on the device, then on the host.
#pragma once

#include "journal.glift.hpp"

#include <cstdint>
#include <deque>
#include <vector>

/// Bytes that steps may take. What the device has no room for moves to the host, the oldest first; what the host has no
/// room for is forgotten.
struct HistoryBudget {
    std::uint64_t device = 256u << 20, host = 1u << 30;
};

/// Marks listed pages, for journal::store and journal::restore.
void mark(const glift::Device& device, journal::Octree& octree, const journal::PageList& list);

class History {
public:
    explicit History(HistoryBudget budget = {}) : budget_(budget) {}

    /// A stroke that has ended. What had been undone is forgotten.
    void add(const glift::Device& device, journal::Octree& octree, journal::Journal& journal);

    /// Give back what was; false where there is nothing to undo, or to do again.
    bool undo(const glift::Device& device, journal::Octree& octree);
    bool redo(const glift::Device& device, journal::Octree& octree);

    std::size_t undoable() const { return done_; }
    std::size_t redoable() const { return steps_.size() - done_; }
    std::uint64_t device_bytes() const;
    std::uint64_t host_bytes() const;
    void clear();

private:
    using Pages = std::vector<glift::uint>;

    /// The texels of pages; on the host where `on_device` is empty.
    struct Texels {
        Pages pages;
        journal::Texels on_device;
        std::vector<glift::uint> on_host;
        bool is_on_device = false;

        std::uint64_t bytes() const;
        void move_to_host();
        void restore(const glift::Device& device, journal::Octree& octree) const;
    };
    struct Step {
        Pages born;
        Texels before, after;
        std::uint64_t bytes() const { return before.bytes() + after.bytes(); }
    };

    void fit();

    HistoryBudget budget_;
    std::deque<Step> steps_;
    std::size_t done_ = 0;  ///< steps from here on were undone
};
