// Needs: a valid module. Guarantees: the same module with corrected alignment operands.
#include "emit/spirv/alignment.h"

#include <glslang/SPIRV/spirv.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <unordered_map>

namespace gliftc::spirv {

namespace {

using Id = std::uint32_t;
using Instruction = std::span<std::uint32_t>;

constexpr std::size_t header_words = 5;

spv::Op op_of(Instruction instruction) { return static_cast<spv::Op>(instruction[0] & 0xffffu); }

/// The types of a module, and its pointers into memory that is accessed by device address.
class Pointers {
public:
    void note(Instruction i) {
        switch (op_of(i)) {
        case spv::OpTypeInt:
        case spv::OpTypeFloat: scalar_bytes_[i[1]] = i[2] / 8; break;
        case spv::OpTypeVector:
        case spv::OpTypeMatrix: parts_[i[1]] = {i[2]}; break;
        case spv::OpTypeArray:
        case spv::OpTypeRuntimeArray:
        case spv::OpTypeStruct:
            parts_[i[1]] = op_of(i) == spv::OpTypeStruct ? std::vector<Id>(i.begin() + 2, i.end()) : std::vector{i[2]};
            aggregates_[i[1]] = true;
            break;
        case spv::OpTypePointer:
            if (i[2] == spv::StorageClassPhysicalStorageBuffer) pointees_[i[1]] = i[3];
            break;
        case spv::OpAccessChain:
        case spv::OpInBoundsAccessChain:
            if (const auto pointee = pointees_.find(i[1]); pointee != pointees_.end())
                chains_[i[2]] = {pointee->second, is_in_aggregate(i[3]) || starts_at_aggregate(i[3])};
            break;
        case spv::OpConvertUToPtr:
        case spv::OpBitcast:
            if (const auto pointee = pointees_.find(i[1]); pointee != pointees_.end()) blocks_[i[2]] = pointee->second;
            break;
        default: break;
        }
    }

    /// Whether the pointer is to a struct or an array that is a buffer's element, or to a part of it.
    bool is_in_aggregate(Id pointer) const {
        const auto chain = chains_.find(pointer);
        return chain != chains_.end() && chain->second.in_aggregate;
    }

    std::uint32_t alignment(Id pointer) const { return alignment_of_type(chains_.at(pointer).pointee); }

private:
    struct Chain {
        Id pointee;
        bool in_aggregate;
    };

    /// Whether the pointer is to a block whose element is a struct or an array. A block has one member, the element.
    bool starts_at_aggregate(Id pointer) const {
        const auto block = blocks_.find(pointer);
        if (block == blocks_.end()) return false;
        const auto members = parts_.find(block->second);
        return members != parts_.end() && aggregates_.contains(members->second.front());
    }

    std::uint32_t alignment_of_type(Id type) const {
        if (const auto scalar = scalar_bytes_.find(type); scalar != scalar_bytes_.end()) return scalar->second;
        std::uint32_t largest = 1;
        if (const auto parts = parts_.find(type); parts != parts_.end())
            for (Id part : parts->second) largest = std::max(largest, alignment_of_type(part));
        return pointees_.contains(type) ? 8 : largest;
    }

    std::unordered_map<Id, std::uint32_t> scalar_bytes_;
    std::unordered_map<Id, std::vector<Id>> parts_;
    std::unordered_map<Id, bool> aggregates_;
    std::unordered_map<Id, Id> pointees_, blocks_;
    std::unordered_map<Id, Chain> chains_;
};

}  // namespace

void correct_alignments(std::vector<std::uint32_t>& words) {
    Pointers pointers;
    for (std::size_t at = header_words, count = 0; at < words.size(); at += count) {
        count = words[at] >> 16;
        if (count == 0) return;
        const Instruction instruction(words.data() + at, count);
        pointers.note(instruction);
        const spv::Op op = op_of(instruction);
        if (op != spv::OpLoad && op != spv::OpStore) continue;
        const std::size_t pointer = op == spv::OpLoad ? 3 : 1, operands = op == spv::OpLoad ? 4 : 3;
        if (operands + 1 < count && (instruction[operands] & spv::MemoryAccessAlignedMask) != 0 &&
            pointers.is_in_aggregate(instruction[pointer]))
            instruction[operands + 1] = pointers.alignment(instruction[pointer]);
    }
}

}  // namespace gliftc::spirv
