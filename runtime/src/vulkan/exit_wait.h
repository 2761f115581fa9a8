// Waits for devices when the program ends.
#pragma once

namespace glift::detail {

class Timeline;

/// A device whose work is waited for at exit. A device in a static variable is destroyed only after what its driver's
/// threads use: these must have no work left by then.
class ExitWait {
public:
    explicit ExitWait(Timeline& timeline);
    ~ExitWait();
    ExitWait(const ExitWait&) = delete;

    /// Handlers of exit run in the opposite order of their registration: one that is registered after the driver has
    /// made something runs before what the driver registered for it.
    void renew();

private:
    Timeline& timeline_;
};

}  // namespace glift::detail
