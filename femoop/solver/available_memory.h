#pragma once

#include <limits>
#include <stdexcept>

namespace femoop {

/// Bytes that this process can still take without swapping: what the system has free or can free, within the limits of
/// the process and of its control group. Infinite where nothing tells.
double available_memory();

/// What was asked for takes more memory than there is; nothing was taken.
class InsufficientMemory : public std::runtime_error {
public:
    InsufficientMemory(double needed_bytes, double available_bytes);

    double needed() const { return needed_; }       ///< bytes
    double available() const { return available_; } ///< bytes

private:
    double needed_;
    double available_;
};

} // namespace femoop
