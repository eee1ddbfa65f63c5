#pragma once

#include <functional>
#include <stdexcept>

namespace femoop {

/// Hears which share of the work is done, 0 .. 1, in the thread that asked for the work; false ends it.
using Progress = std::function<bool(double share)>;

/// Work that its Progress ended.
class Cancelled : public std::runtime_error {
public:
    Cancelled() : std::runtime_error("the factorization was cancelled") {}
};

} // namespace femoop
