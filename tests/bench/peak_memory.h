#pragma once

#include <sys/resource.h>

namespace bench {

/// The most memory that this process ever had.
inline double peak_megabytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

} // namespace bench
