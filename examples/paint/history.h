// The history of strokes, which can be undone and redone. A step is kept for each stroke: the texels of the pages that
// the stroke changed, as they were before and after it. Texels are kept on the device; where they take too much of its
// memory, those of the oldest steps move to the host.
#pragma once

#include "journal.glift.hpp"

#include <cstdint>
#include <deque>
#include <vector>

/// Bytes that the texels of all steps may take. Beyond `device` the oldest steps move to the host; beyond `host` the
/// oldest steps are dropped, and can no longer be undone.
struct HistoryBudget {
    std::uint64_t device = 256u << 20, host = 1u << 30;
};

/// Chooses the pages whose texels journal::store and journal::restore copy: marks the pages of `list`, then has the
/// octree list the marked ones (Octree::marked_frames), which takes the marks away.
void mark(const glift::Device& device, journal::Octree& octree, const journal::PageList& list);

class History {
public:
    explicit History(HistoryBudget budget = {}) : budget_(budget) {}

    /// Adds a step for a stroke that has ended, from the journal of what it changed. Steps that had been undone are
    /// dropped. A stroke that changed no page has a step, too, an empty one: so there is one step for each stroke.
    void add(const glift::Device& device, journal::Octree& octree, journal::Journal& journal);

    /// undo() restores the pages of the last step that is not undone to what they were before its stroke; redo(), those
    /// of the first step that is undone to what they were after its stroke. False if there is no such step.
    bool undo(const glift::Device& device, journal::Octree& octree);
    bool redo(const glift::Device& device, journal::Octree& octree);

    std::size_t undoable() const { return done_; }
    std::size_t redoable() const { return steps_.size() - done_; }
    std::uint64_t device_bytes() const;
    std::uint64_t host_bytes() const;
    void clear();

private:
    using Pages = std::vector<glift::uint>;

    /// The texels of pages: in `on_device` if `is_on_device`, else in `on_host`.
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
        Pages born;            ///< pages that became resident in the stroke, which undoing it releases
        Texels before, after;  ///< of the changed pages; `before` without those that were born
        std::uint64_t bytes() const { return before.bytes() + after.bytes(); }
    };

    static Texels room_for(const glift::Device& device, Pages pages);
    void fit();

    HistoryBudget budget_;
    std::deque<Step> steps_;
    std::size_t done_ = 0;  ///< the steps from this index on were undone
};
