// A Vulkan device: what its streams, memories and recordings share.
#pragma once

#include "command_batch.h"
#include "exit_wait.h"
#include "immediate_stream.h"
#include "internal_pass.h"
#include "link.h"
#include "pass_times.h"
#include "queries.h"
#include "timeline.h"
#include "vulkan/memory/vulkan_memory.h"

#include <mutex>

namespace glift::detail {

std::shared_ptr<DeviceObject> open_vulkan_device(std::string_view which, const Context::Wanted& extensions = {});

struct VulkanCounters {
    std::uint64_t submissions = 0, passes = 0, barriers = 0;
};

class VulkanDevice final : public DeviceObject {
public:
    explicit VulkanDevice(std::unique_ptr<Context> context);
    ~VulkanDevice() override;

    const DeviceProperties& properties() const override { return context_->properties; }
    DrawLimits draw_limits() const override { return context_->draw_limits(); }
    std::shared_ptr<MemoryObject> allocate(const MemoryDescription& description) override;
    StorageNeeds storage_needs(const MemoryDescription& description) override;
    Stream& stream() override { return *stream_; }
    VisibleMemory allocate_visible(const MemoryDescription& description) override;
    LinkObject* link() override;
    std::shared_ptr<PointObject> point() override;
    /// Not with the validation layer of Debian 12 (1.3.239): where one thread opens a gate while another one asks how
    /// far the device is, it waits for ten seconds and reports a defect of its own
    /// (UNASSIGNED-VkSemaphore-state-timeout).
    bool has_gates() const override { return !context_->instance->is_validated(); }
    std::shared_ptr<GateObject> gate() override;
    std::shared_ptr<Stream> begin_recording() override;
    std::shared_ptr<RecordingObject> end_recording(Stream& stream) override;
    Statistics statistics() override;
    std::vector<std::string> validation_messages() override { return context_->instance->take_messages(); }
    void start_profile() override;
    std::optional<Nanoseconds> now() override { return queries_->now(); }
    void finish_profile() override;

    /// The device's lock, held around everything that records, submits or allocates.
    std::mutex& mutex() { return mutex_; }

    Context& context() { return *context_; }
    Timeline& timeline() { return *timeline_; }
    ImmediateStream& stream_of_device() { return *stream_; }
    VulkanCounters& counters() { return counters_; }

    /// The caller holds the lock in these.
    std::shared_ptr<VulkanMemory> new_object(const MemoryDescription& description);  ///< without storage
    std::shared_ptr<VulkanMemory> new_memory(const MemoryDescription& description);
    std::shared_ptr<VulkanMemory> new_linked_memory(const MemoryDescription& description);
    /// A memory over an image of the user's.
    std::shared_ptr<VulkanMemory> adopted_image(const MemoryDescription& description, VkImage image,
                                                VkImageUsageFlags usage, VkImageCreateFlags flags);
    ChunkPool& chunks() { return *chunks_; }
    Pipelines& pipelines() { return *pipelines_; }
    Queries& queries() { return *queries_; }
    PassTimes& pass_times() { return *pass_times_; }
    VkBuffer status_buffer() const { return status_->buffer; }
    /// Runs prepare_indirect.comp. The push constant is the address of the list of passes that it prepares.
    InternalPass& prepare_pass() { return prepare_; }
    /// Runs fill_words.comp. The push constants are FillArguments; one invocation per word, 256 per workgroup.
    InternalPass& fill_pass() { return fill_; }
    /// Runs begin_messages.comp. The push constants are MessagesArguments; one invocation.
    InternalPass& messages_pass() { return begin_messages_; }
    /// The buffer of messages, made when a kernel that prints first runs.
    const Chunk& message_chunk();
    std::uint32_t printing_kernel(const Pipeline& pipeline);  ///< its number in PrintingKernels
    /// A submission with this value on the timeline prints.
    void note_printing(std::uint64_t value) { printing_value_ = value; }
    /// The commands begin when the gate is open; 0: at once.
    std::uint64_t submit(VkCommandBuffer commands, std::uint64_t gate = 0);
    /// Lets the user's program use the queue: what Glift submits from now on is ordered after what the program
    /// submitted.
    void share_queue();
    void collect();  ///< destroys or recycles what the device is done with
    /// Allocates storage for a memory. Where none is left it waits until what was freed can be used; throws
    /// out_of_memory.
    void allocate_parts(const VkMemoryRequirements& needs, bool linear, const MemoryDescription& description,
                        Allocation& result);
    /// Allocates storage for a buffer as several allocations, to which the buffer is bound in order. Throws as
    /// allocate_parts.
    std::vector<Allocation> allocate_pieces(const VkMemoryRequirements& needs, const MemoryDescription& description);
    std::uint64_t max_piece_bytes() const { return context_->max_piece_bytes; }
    /// What is retired from now on is destroyed when the timeline reaches this value.
    void set_retire_value(std::uint64_t value) { retire_value_ = value; }
    [[noreturn]] void throw_too_large(const MemoryDescription& description) const;

    /// Waits until the timeline reaches the value; submits first if need be; throws what kernels reported. The caller
    /// does not hold the lock.
    void finish(std::uint64_t value);  ///< UINT64_MAX: everything recorded so far

    /// Batches are reused: a command buffer that was used before is cheaper to record, since drivers keep its memory.
    std::unique_ptr<CommandBatch> take_batch();
    /// The batch is reused, or destroyed, once the device is done with it.
    void give_back(std::unique_ptr<CommandBatch> batch);

    /// From any thread, with or without the lock: when all commands recorded so far are done, the objects are
    /// destroyed, and the query may be used again.
    void retire(const MemoryParts& parts, MemoryId id);
    void retire(Query query);

private:
    std::shared_ptr<VulkanMemory> unmade_object(const MemoryDescription& description);
    struct Retired {
        std::uint64_t value;
        MemoryParts parts;
        MemoryId id;
        Query query;
        std::unique_ptr<CommandBatch> batch;
    };

    [[noreturn]] void throw_out_of_memory(std::uint64_t bytes, const MemoryDescription& description) const;
    void start_compiler();
    void prepare_exit();
    void destroy(Retired& retired);
    void destroy_retired(std::uint64_t completed);
    void check_reports();
    void keep_times();
    std::vector<Message> take_messages();
    MemoryId new_id();

    std::unique_ptr<Context> context_;
    std::mutex mutex_;
    std::unique_ptr<Timeline> timeline_;
    ExitWait exit_wait_;
    bool is_exit_prepared_ = false;
    std::unique_ptr<Allocator> allocator_;
    std::unique_ptr<ChunkPool> chunks_;
    std::unique_ptr<Pipelines> pipelines_;
    std::unique_ptr<Queries> queries_;
    std::unique_ptr<PassTimes> pass_times_;
    std::unique_ptr<VulkanLink> link_;  ///< made when it is first asked for
    std::shared_ptr<Chunk> status_;
    std::shared_ptr<Chunk> message_chunk_;  ///< null: no kernel has printed
    PrintingKernels printing_;
    std::uint64_t printing_value_ = 0;  ///< the timeline's value once all submissions that print are done
    InternalPass prepare_, fill_, begin_messages_;
    std::vector<std::unique_ptr<CommandBatch>> idle_batches_;
    std::uint64_t completed_ = 0;  ///< the timeline's value when last read
    std::unique_ptr<ImmediateStream> stream_;
    VulkanCounters counters_;
    std::vector<std::uint32_t> free_slots_;
    std::uint32_t slots_ = 0;
    std::uint64_t serial_ = 0;
    std::atomic<std::uint64_t> waits_{0}, memories_{0};

    std::mutex retire_mutex_;
    std::vector<Retired> retired_;
    std::atomic<std::uint64_t> retire_value_{0};  ///< the timeline's value once all commands recorded so far are done
};

}  // namespace glift::detail
