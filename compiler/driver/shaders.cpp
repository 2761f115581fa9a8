#include "driver/shaders.h"

#include "base/lines.h"
#include "base/parallel.h"
#include "emit/glsl/emit.h"
#include "emit/spirv/emit.h"

#include <mutex>
#include <stdexcept>
#include <unordered_map>

namespace gliftc {

namespace {

struct Job {
    const ir::Pass* pass;
    ir::Part part;
    std::vector<std::uint32_t>* words;
    std::string error;
};

spirv::Stage stage_of(ir::Part part) {
    switch (part) {
    case ir::Part::whole: return spirv::Stage::compute;
    case ir::Part::vertex: return spirv::Stage::vertex;
    case ir::Part::fragment: return spirv::Stage::fragment;
    }
    return spirv::Stage::compute;
}

std::vector<Job> list_jobs(const Compilation& c, const std::set<ir::KernelId>& kernels, cpp::KernelCodes& shaders) {
    std::vector<Job> jobs;
    for (ir::KernelId k : kernels) {
        const auto add = [&](const ir::Pass& pass, cpp::FormCode& code) {
            jobs.push_back({&pass, pass.plain().part, &code.shader, {}});
            if (fragment_for(pass, ir::Devices::shaders))
                jobs.push_back({&pass, ir::Part::fragment, &code.fragment, {}});
        };
        const auto& forms = c.lowered.passes[k];
        add(forms.direct, shaders[k].direct);
        add(forms.general, shaders[k].general);
    }
    return jobs;
}

/// The shaders that were compiled, by options and GLSL without its `#line` directives.
class Kept {
public:
    void begin() { is_on_ = true; }
    spirv::Spirv get(const std::string& glsl, spirv::Optimise optimise, spirv::Stage stage,
                     spirv::Contraction contraction) {
        if (!is_on_) return spirv::spirv_of(glsl, optimise, stage, contraction);
        std::string key;
        for (int option : {static_cast<int>(optimise), static_cast<int>(stage), static_cast<int>(contraction)})
            key += std::to_string(option) + " ";
        key += without_lines(glsl, {"#line "});
        {
            const std::lock_guard lock(mutex_);
            if (const auto found = shaders_.find(key); found != shaders_.end()) return {found->second, {}};
        }
        spirv::Spirv made = spirv::spirv_of(glsl, optimise, stage, contraction);
        const std::lock_guard lock(mutex_);
        if (shaders_.size() >= most) shaders_.clear();
        if (made.error.empty()) shaders_[std::move(key)] = made.words;
        return made;
    }

private:
    static constexpr std::size_t most = 1 << 14;

    bool is_on_ = false;
    std::mutex mutex_;
    std::unordered_map<std::string, std::vector<std::uint32_t>> shaders_;
};

Kept& kept() {
    static Kept& only = *new Kept;
    return only;
}

void run(Job& job, const Compilation& c, spirv::Optimise optimise) {
    const bool is_fast = c.program.kernels[job.pass->kernel].fast_math;
    const auto rounding = is_fast ? glsl::Rounding::device : glsl::Rounding::correct;
    const auto contraction = is_fast ? spirv::Contraction::on : spirv::Contraction::off;
    std::string text = glsl::glsl_of(c.program, c.sources, *job.pass,
                                     {.lines = glsl::LineMarks::directives, .rounding = rounding, .part = job.part});
    spirv::Spirv made = kept().get(text, optimise, stage_of(job.part), contraction);
    *job.words = std::move(made.words);
    job.error = std::move(made.error);
}

}  // namespace

cpp::KernelCodes compile_shaders(const Compilation& c, const std::set<ir::KernelId>& kernels, bool optimize) {
    cpp::KernelCodes shaders(c.program.kernels.size());
    std::vector<Job> jobs = list_jobs(c, kernels, shaders);
    auto optimise = optimize ? spirv::Optimise::size : spirv::Optimise::no;
    for_each_parallel(jobs.size(), 1, [&](std::size_t i) { run(jobs[i], c, optimise); });
    for (const Job& job : jobs)
        if (!job.error.empty())
            throw std::runtime_error("the GLSL made for kernel '" + c.program.kernels[job.pass->kernel].display +
                                     "' is not valid:\n" + job.error);
    return shaders;
}

void keep_shaders() { kept().begin(); }

}  // namespace gliftc
