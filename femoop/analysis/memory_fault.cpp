#include "femoop/analysis/memory_fault.h"

#include <cmath>
#include <string>

#include "femoop/model/quantity/number_text.h"

namespace femoop {

Fault insufficient_memory(const InsufficientMemory& refusal, Eigen::Index n_equations)
{
    const auto gigabytes = [](double bytes) { return number_text(std::round(1e-7 * bytes) / 100.0); };
    return {FaultKind::MemoryInsufficient,
            {std::to_string(n_equations), gigabytes(refusal.needed()), gigabytes(refusal.available())}};
}

} // namespace femoop
