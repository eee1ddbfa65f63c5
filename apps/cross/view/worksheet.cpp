#include "apps/cross/view/worksheet.h"

#include <algorithm>
#include <cmath>

#include "apps/cross/view/numbers.h"

namespace cross {

namespace fc = femoop::cross;
using fc::Asked;

bool Worksheet::is_good(fc::BlankId id) const
{
    const fc::Verdict verdict = judgements[id.index].verdict;
    if (verdict == fc::Verdict::Open) return form[id].may_stay_empty;
    return verdict == fc::Verdict::Right || verdict == fc::Verdict::FollowsRight;
}

bool Worksheet::is_solved() const
{
    for (std::size_t i = 0; i < form.blanks.size(); ++i)
        if (!is_good(fc::BlankId(i))) return false;
    return shows_judgement;
}

std::size_t Worksheet::n_needed() const
{
    return static_cast<std::size_t>(
        std::ranges::count_if(form.blanks, [](const fc::Blank& blank) { return !blank.may_stay_empty; }));
}

std::size_t Worksheet::stage_of(fc::BlankId id) const
{
    const fc::Blank& blank = form[id];
    const bool is_of_all = blank.asked == Asked::Holding || blank.asked == Asked::Multiplier ||
                           blank.asked == Asked::Final;
    return is_of_all ? n_sheets() : blank.sheet;
}

std::optional<Worksheet> worksheet_of(const Document& document)
{
    if (!document.pupil) return std::nullopt;
    try {
        fc::FormOptions options;
        options.procedure = {.order = document.method.order, .tolerance = document.method.tolerance};
        for (const std::string& name : document.method.joints)
            if (const auto node = document.model.find_node(name)) {
                const fc::Problem problem = fc::problem_of(document.model, document.method.load_case,
                                                           document.method.far_ends);
                if (const auto joint = problem.joint_at(*node)) options.procedure.joints.push_back(*joint);
            }
        auto form = fc::form_of(document.model, document.method.load_case, document.method.far_ends, options);
        if (!form || form->blanks.empty()) return std::nullopt;
        Worksheet worksheet{.form = std::move(*form), .entries = {}, .judgements = {}};
        judge_again(worksheet, document);
        return worksheet;
    } catch (const femoop::ModelError&) {
        return std::nullopt;
    }
}

void judge_again(Worksheet& worksheet, const Document& document)
{
    const ui::DisplayUnits units = units_of(document.model, ui::Catalogue());
    const std::size_t n = worksheet.form.blanks.size();
    worksheet.entries.assign(n, std::nullopt);
    for (std::size_t i = 0; i < std::min(n, document.pupil->written.size()); ++i) {
        const auto entry = entry_typed(document.pupil->written[i]);
        if (!entry) continue;
        const double size = unit_of(worksheet, fc::BlankId(i), units).size;
        worksheet.entries[i] = fc::Entry{entry->value * size, entry->unit * size};
    }
    worksheet.judgements = fc::judge(worksheet.form, worksheet.entries);
    worksheet.shows_judgement = document.pupil->judges_at_once || document.pupil->is_judged;
}

CellUnit unit_of(const Worksheet& worksheet, fc::BlankId id, const ui::DisplayUnits& units)
{
    const auto of = [&](ui::Measure measure) {
        const ui::DisplayUnit unit = units.unit(measure);
        return CellUnit{unit.name, 1.0 / unit.factor};
    };
    switch (worksheet.form[id].asked) {
    case Asked::Stiffness: {
        const CellUnit length = of(ui::Measure::Length);
        return {"1/" + length.name, 1.0 / length.size};
    }
    case Asked::Factor:
    case Asked::Multiplier: return {};
    case Asked::Holding: return of(ui::Measure::Force);
    default: return of(ui::Measure::Moment);
    }
}

std::string text_for(const Worksheet& worksheet, fc::BlankId id, const ui::DisplayUnits& units)
{
    constexpr int digits = 4;
    const double value = fc::following(worksheet.form, worksheet.entries)[id.index] /
                         unit_of(worksheet, id, units).size;
    double largest = 0.0; // less than a thousandth of it is nothing
    for (const double moment : worksheet.form.loading(worksheet.form[id].sheet).fixed_end)
        largest = std::max(largest, std::abs(moment));
    const bool is_moment = worksheet.form[id].asked >= Asked::FixedEnd && worksheet.form[id].asked <= Asked::Sum;
    if (is_moment && std::abs(value * unit_of(worksheet, id, units).size) < 1e-5 * largest) return "0";
    return ui::number_text(value, {digits, units.format().mark});
}

} // namespace cross
