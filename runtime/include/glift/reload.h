// Hot reload: a running program takes newer code of its kernels and pipelines, which `gliftc watch` makes whenever a
// .glift file is saved. Structures stay as they are. docs/how-to/reload.md shows how.
#pragma once

#include <glift/kernel.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <typeinfo>

namespace glift {

/// Newer code for the functions of this process that were generated with `gliftc --reload` (CMake: GLIFT_RELOAD=ON).
/// The environment variable GLIFT_RELOAD does the same without a call: it names the folder, and the runtime looks for
/// newer code whenever the program submits or waits.
///
/// A function is a kernel or a pipeline that is not a function of a structure. One whose parameters changed keeps its
/// old code. If the declaration of a type or a structure changed, nothing is loaded. Either way the log (log.h) says
/// so. Recordings keep the kernels with which they were made. Code that was loaded stays in memory until the process
/// ends.
class GLIFT_API Reload {
public:
    /// `folder` is the output folder of `gliftc watch`, which may not exist yet. Empty: `poll` does nothing.
    explicit Reload(std::string folder);
    ~Reload();
    Reload(Reload&&) noexcept;
    Reload& operator=(Reload&&) noexcept;

    /// Loads what `gliftc watch` has made since the last call. Returns whether some function has other code than
    /// before: make recordings again then. Costs a system call (microseconds). Call it between frames: calls of
    /// pipelines that other threads have begun may go on with old and new kernels.
    bool poll();

private:
    struct Folder;
    std::unique_ptr<Folder> folder_;
};

/// A function of generated code, in static memory, which the program or a library that it loads replaces.
class ReloadableFunction {
public:
    /// `declaration` is for messages. Two versions have equal digests, and kernels of equal
    /// digests, if they do the same.
    template <class F> ReloadableFunction(const char* full_name, const char* declaration, std::uint64_t code_digest,
                                          F* code, const Kernel* called = nullptr)
        : name(full_name), signature(declaration), type(typeid(F).name()), digest(code_digest), kernel(called),
          own(reinterpret_cast<void*>(code)) {
        add();
    }
    ~ReloadableFunction() { remove(); }
    ReloadableFunction(const ReloadableFunction&) = delete;
    ReloadableFunction& operator=(const ReloadableFunction&) = delete;

    /// The newest version that was loaded, else `first`. Static objects may call it before this object is made.
    template <class F> F* newest(F* first) const {
        void* const loaded = newer.load(std::memory_order_acquire);
        return loaded ? reinterpret_cast<F*>(loaded) : first;
    }

    const char *const name, *const signature;
    const char* const type;  ///< the same for two functions of one type, whatever aliases their declarations name
    const std::uint64_t digest;
    const Kernel* const kernel;  ///< null: a pipeline
    void* const own;
    mutable std::atomic<void*> newer;  ///< null: none

private:
    GLIFT_API void add() const;
    GLIFT_API void remove() const;
};

/// A type or structure of generated code. Two declarations that agree have equal digests.
class ReloadableType {
public:
    ReloadableType(const char* full_name, std::uint64_t declaration_digest)
        : name(full_name), digest(declaration_digest) {
        add();
    }
    ~ReloadableType() { remove(); }
    ReloadableType(const ReloadableType&) = delete;
    ReloadableType& operator=(const ReloadableType&) = delete;

    const char* const name;
    const std::uint64_t digest;

private:
    GLIFT_API void add() const;
    GLIFT_API void remove() const;
};

}  // namespace glift
