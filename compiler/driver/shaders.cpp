#include "driver/shaders.h"

#include "base/parallel.h"
#include "emit/glsl/emit.h"
#include "emit/spirv/emit.h"

#include <stdexcept>

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

void run(Job& job, const Compilation& c, spirv::Optimise optimise) {
    const bool is_fast = c.program.kernels[job.pass->kernel].fast_math;
    const auto rounding = is_fast ? glsl::Rounding::device : glsl::Rounding::correct;
    const auto contraction = is_fast ? spirv::Contraction::on : spirv::Contraction::off;
    std::string text = glsl::glsl_of(c.program, c.sources, *job.pass,
                                     {.lines = glsl::LineMarks::directives, .rounding = rounding, .part = job.part});
    spirv::Spirv made = spirv::spirv_of(text, optimise, stage_of(job.part), contraction);
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

}  // namespace gliftc
