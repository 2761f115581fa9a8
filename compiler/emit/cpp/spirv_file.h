// SPIR-V beside C++: the SPIR-V of all kernels in one source, in one file that the assembler includes (.incbin).
#pragma once

#include "emit/cpp/emit.h"
#include "ir/pass.h"

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace gliftc::cpp {

class SpirvFile {
public:
    /// The SPIR-V of those `kernels` that have any. `name`: of the file, which lies in the folder of the source.
    SpirvFile(std::string name, const KernelCodes& code, const std::vector<ir::KernelId>& kernels);

    bool empty() const { return words_.empty(); }
    const std::string& name() const { return name_; }
    std::string bytes() const;
    /// The `asm` statement that includes the file.
    std::string statement() const;
    /// The arguments of the glift::Spirv for a kernel's form: `glift_spirv_0f0e… + 120, 567`. Not for a general
    /// form whose words equal those of the direct form: the file has them once.
    std::string place_of(ir::KernelId kernel, ir::Form form, ir::Part part) const;

private:
    std::string name_, symbol_;
    std::vector<std::uint32_t> words_;
    struct Place {
        std::size_t first, count;
    };
    std::map<std::tuple<ir::KernelId, ir::Form, ir::Part>, Place> places_;
};

}  // namespace gliftc::cpp
