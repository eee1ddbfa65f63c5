#include "femoop/io/force_method/force_method_text.h"

#include <cstddef>

#include "femoop/io/derivation/derivation_text.h"
#include "femoop/io/virtual_work/virtual_work_text.h"
#include "femoop/methods/force_method/force_steps.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/six_digits.h"

namespace femoop::force_method {

namespace {

/// Of one gap: release i in state j.
std::string work_of_gap(const ForceMethod& method, std::size_t i, std::size_t j, const Translator& tr)
{
    const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
    const double gap = j == 0 ? method.delta_0[row] : method.delta(row, column - 1);
    const double spring = j == i + 1 ? method.primary.releases[i].flexibility : 0.0;
    const virtual_work::WorkCaptions captions{fill(tr("state {0}, F"), {std::to_string(j)}),
                                              fill(tr("state {0}, f"), {std::to_string(i + 1)})};
    std::string text = "\nδ" + std::to_string(i + 1) + std::to_string(j) + " = " + six_digits(gap, tr) + "\n" +
                       work_text(method.work[i][j], captions, method.primary.model, tr);
    if (spring > 0.0)
        text += "\n" + fill(tr("The spring that it goes through: 1/k = {0}."), {six_digits(spring, tr)}) + "\n";
    return text;
}

} // namespace

std::string force_method_text(const ForceMethod& method, const Model& model, const Translator& tr)
{
    std::string text = derivation_text(steps(method, model), model, tr);
    for (std::size_t i = 0; i < method.n_redundants(); ++i) {
        text += work_of_gap(method, i, 0, tr);
        for (std::size_t j = i + 1; j <= method.n_redundants(); ++j) text += work_of_gap(method, i, j, tr);
    }
    return text;
}

} // namespace femoop::force_method
