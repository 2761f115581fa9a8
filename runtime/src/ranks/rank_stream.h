// Distributes passes and copies over the ranks. All ranks put the same commands into their streams; each decides the
// same about them, so that no rank has to ask another one what it will do.
#pragma once

#include "messenger.h"
#include "pass_plan.h"

namespace glift::detail {

class RankStream final : public Stream {
public:
    RankStream(DeviceObject& device, std::shared_ptr<ranks::Transport> transport, std::shared_ptr<DeviceObject> local,
               const ranks::Options& options);

    std::shared_ptr<DeviceObject> device() override { return device_.shared_from_this(); }
    Memory allocate(const MemoryDescription& description) override { return local().allocate(description); }
    bool can_be_direct(const Kernel& kernel, std::span<const Memory> memories, const std::array<std::uint32_t, 4>& size,
                       Sharing sharing) override {
        return local().can_be_direct(kernel, memories, size, sharing);
    }
    void clear(const Memory& memory) override;
    void dispatch(const Kernel& kernel, const Call& call) override;
    void fill(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value) override;
    void fill_where(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value,
                    std::span<const Condition> conditions) override;
    void copy(const Memory& from, const Memory& to, std::span<const CopyRegion> regions) override;
    void copy_to_image(const Memory& buffer, const Memory& image, std::span<const ImageRegion> regions) override;
    void copy_from_image(const Memory& image, const Memory& buffer, std::span<const ImageRegion> regions) override;
    void copy_images(const Memory& from, const Memory& to, std::span<const ImageCopyRegion> regions) override;
    void upload(const Memory& to, std::span<const CopyRegion> regions, std::span<const std::byte> bytes) override;
    void upload_image(const Memory& image, std::span<const ImageRegion> regions,
                      std::span<const std::byte> bytes) override;
    std::shared_ptr<DownloadObject> download(const Memory& from, std::span<const CopyRegion> regions,
                                             std::uint64_t bytes) override;
    std::shared_ptr<DownloadObject> download_image(const Memory& image, std::span<const ImageRegion> regions,
                                                   std::uint64_t bytes) override;
    std::shared_ptr<TimestampObject> timestamp() override { return local().timestamp(); }
    void flush() override { local().flush(); }
    void wait() override;

    void distribute(const char* type_name, const RangeShape& shape, std::span<const Memory> memories,
                    const ranks::Distribution& how);
    void distribute(const PagedShape& shape, const ranks::Distribution& how);
    double balance(const PagedShape& shape);
    double imbalance(const PagedShape& shape);
    Messenger& messenger() { return messenger_; }
    ranks::Statistics statistics();

private:
    Stream& local() { return local_->stream(); }

    // Whole passes.
    void run_whole(const Kernel& kernel, const Call& call);
    void gather(const Memory& memory);
    void gather(const DeviceValue& value) { gather(value.memory); }
    void note_topology_write(const Memory& memory);

    Space& space_of(const PagedShape& shape);

    // Distributed passes (rank_passes.cpp).
    void run_distributed(const Kernel& kernel, const Call& call, const PassPlan& plan);
    std::uint32_t run_parts(const Kernel& kernel, const Call& call, const PassPlan& plan);
    std::uint32_t extension_of(const Kernel& kernel, const Call& call, const PassPlan& plan);
    void run_planes(const Kernel& kernel, const Call& call, const PassPlan& plan, Planes lower, Planes upper = {});
    void run_pages(const Kernel& kernel, const Call& call, const Space& space, Planes lower, Planes upper);
    std::vector<Piece> missing_ghosts(const Kernel& kernel, const Call& call, const PassPlan& plan);
    void refresh(Paging& paging, const Cuts& cuts);
    void see_planes(Paging& paging, const Cuts& cuts);
    void transfer(const std::vector<Piece>& pieces, Traffic& traffic);
    void cut_pages(const Paging& paging, const Cuts& cuts, std::uint32_t first_list);
    std::uint32_t sublist(Paging& paging, const Cuts& cuts, Planes lower, Planes upper);  ///< its number

    // What passes write to memories that every rank has (combine.cpp).
    struct Before {
        std::size_t binding;
        Memory copy;
    };
    std::vector<Before> keep_before(const Kernel& kernel, const Call& call, const PassPlan& plan);
    void combine(const Kernel& kernel, const Call& call, const std::vector<Before>& before);

    std::vector<std::byte> bytes_of(const Memory& memory);
    Memory copy_of(const Memory& memory);

    DeviceObject& device_;
    std::shared_ptr<DeviceObject> local_;
    ranks::Options options_;
    Coverages coverages_;
    SlabLayouts layouts_;
    std::vector<std::shared_ptr<Space>> paged_spaces_;
    std::map<std::uint32_t, std::shared_ptr<Space>> dense_spaces_;  ///< by planes
    ranks::Statistics statistics_;
    Traffic exchanges_, gathers_, migrations_;
    unsigned passes_since_flush_ = 0;
    Messenger messenger_;  ///< the last member: messages under way refer to the others
};

}  // namespace glift::detail
