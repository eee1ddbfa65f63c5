#pragma once

#include <cstddef>
#include <string>

namespace bench {

/// What CHOLMOD needs by itself for the system of the plane frame of `cremona bench frame`: seconds and megabytes.
struct Reference {
    std::string ordering;
    double analyse = 0.0, factor = 0.0, solve = 0.0;
    double nonzeros = 0.0; ///< of its factor
    double peak_mb = 0.0;  ///< of a process that does nothing else
    double sway = 0.0;     ///< ux of the top left node [m], to know that it is the same system
    double total() const { return analyse + factor + solve; }
};

enum class ReferenceOrdering { Amd, Metis };

/// Runs in a process of its own, so that its peak is its own.
Reference cholmod_reference(std::size_t bays, std::size_t storeys, ReferenceOrdering ordering);

} // namespace bench
