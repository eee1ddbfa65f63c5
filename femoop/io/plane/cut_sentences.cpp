#include "femoop/io/plane/cut_sentences.h"

#include "femoop/io/plane/plane_output.h"
#include "femoop/io/plane/printed_sizes.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/plane/result/cut_balance.h"

namespace femoop::plane {

std::vector<std::string> cut_sentences(const PlaneResults& results, const PlaneCase& result,
                                       const std::vector<Cut>& cuts, const ResultUnits& units, const Translator& tr)
{
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const auto warning = cut_warning(results, result, cuts[i]);
        if (!warning) continue;
        const CutForces by = without_rounding_of(warning->balanced, cuts[i]);
        const auto number = [&tr](double v) { return localized(number_text(to_six_digits(v)), tr); };
        const auto value = [&number](double v, const PrintedUnit& unit) { return number(v * unit.factor); };
        sentences.push_back(
            fill(tr("cut {0}: the stresses of the elements miss equilibrium by {1} % (digits that hold: {2}); "
                    "what lies beyond the cut gives N = {3}, V = {4}, M = {5}"),
                 {std::to_string(i + 1), number(100.0 * warning->missed), std::to_string(warning->digits),
                  value(by.N, units.force), value(by.V, units.force), value(by.M, units.moment)}));
    }
    return sentences;
}

} // namespace femoop::plane
