#include "apps/cli/phase_times.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "femoop/model/quantity/number_text.h"

namespace cli {

void report_time(const PhaseTimes& phases, const femoop::AnalysisStatistics& statistics, const Console& console)
{
    const ui::Catalogue& tr = console.tr();
    const auto seconds = [&](const std::string& what, double duration) {
        std::array<char, 32> number{};
        static_cast<void>(std::snprintf(number.data(), number.size(), "%12.6f s  ", duration));
        console.message(femoop::localized(number.data(), tr) + what);
    };
    const auto power = [&](const std::string& what, double value) {
        std::array<char, 32> number{};
        static_cast<void>(std::snprintf(number.data(), number.size(), "%14.1e  ", value));
        console.message(femoop::localized(number.data(), tr) + what);
    };
    const auto size = [&](const std::string& what, std::size_t n) {
        const std::string number = std::to_string(n);
        console.message(std::string(number.size() < 14 ? 14 - number.size() : 0, ' ') + number + "  " + what);
    };
    seconds(tr("read"), phases.read);
    if (phases.mesh) seconds(tr("mesh"), *phases.mesh);
    seconds(tr("assemble"), statistics.assemble);
    seconds(tr("order"), statistics.order);
    seconds(tr("factor"), statistics.factor);
    seconds(tr("solve"), statistics.solve);
    seconds(tr("recover"), phases.recover);
    seconds(tr("write"), phases.write);
    size(tr("dofs"), statistics.dofs);
    size(tr("nonzeros of K (lower triangle)"), statistics.nonzeros);
    size(tr("nonzeros of its factor"), statistics.factor_nonzeros);
    if (statistics.factor_operations > 0.0) {
        power(tr("multiplications of the factorization, predicted"), statistics.factor_operations);
        power(tr("bytes of memory of the factorization, predicted"), statistics.factor_bytes);
    }
    console.message(std::string(14 - std::min<std::size_t>(statistics.solver.size(), 14), ' ') + statistics.solver +
                    "  " + tr("solver"));
    if (!phases.has_refinement) return;
    size(tr("corrections of the displacements"), static_cast<std::size_t>(statistics.refinements));
    power(tr("backward error: the part of any number of K and F by which the displacements are off"),
          statistics.backward_error);
}

} // namespace cli
