#include "apps/cross/session/report.h"

#include "apps/cross/session/exercise_report.h"

#include <string_view>
#include <utility>

#include "apps/cross/view/numbers.h"
#include "femoop/io/cross/cross_table.h"
#include "ui/text/language_manner.h"

namespace cross {

namespace fc = femoop::cross;
using ui::translatable;

namespace {

std::string in_lines(const std::vector<femoop::Fault>& faults, const ui::Catalogue& tr)
{
    std::string words;
    for (const femoop::Fault& fault : faults) words += fault_text(fault, tr) + "\n";
    return words;
}

} // namespace

tabular::Table table_of(const Session& session, Topic topic)
{
    if (session.hides_results() || (topic == Topic::Exercises && session.worksheet() != nullptr))
        return exercise_table(session);
    return table_of(session.scene(), topic);
}

tabular::Separators separators(ui::Language language)
{
    return {ui::decimal_mark(language) == ui::DecimalMark::Comma ? ';' : ',', "\n"};
}

std::string description(const Session& session)
{
    if (session.hides_results()) return exercise_description(session);
    const auto& task = session.solution().task;
    if (!task) return in_lines(session.solution().faults, session.tr());
    if (!task->all || !task->comparison) return in_lines(task->remarks, session.tr());
    const fc::Worked worked{session.document().model, task->problem, task->procedure, *task->all, *task->comparison};
    return fc::sheet_text(worked, [&](std::string_view text) { return session.tr()(text); });
}

std::optional<ui::Refusal> why_no_words(const Session& session)
{
    constexpr int bad_input = 2, mechanism = 3;
    if (session.hides_results()) return std::nullopt;
    const auto& task = session.solution().task;
    if (!task) return ui::Refusal{description(session), bad_input};
    if (!task->all || !task->comparison) return ui::Refusal{description(session), mechanism};
    return std::nullopt;
}

std::string status_text(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    if (!session.solution().task) return tr("this structure cannot be distributed");
    if (session.worksheet() != nullptr) return exercise_name(session) + "   ·   " + score_text(session);
    const fc::Sheet* const sheet = session.sheet();
    if (session.tool == Tool::UniformLoad) return tr("a uniform load: click a member, or press Esc");
    if (session.tool == Tool::PointLoad) return tr("a force: click a member or a node, or press Esc");
    if (sheet == nullptr) return tr("All sheets together");
    const Numbers numbers(session.document(), session.solution(), session.look);
    const std::string unit = " " + numbers.moment_unit();
    const std::string largest = numbers.moment(fc::largest_unbalance(sheet->end)) + unit;
    return tr("step {n}   ·   largest unbalance {moment}   ·   tolerance {tolerance}",
              {{"n", std::to_string(sheet->steps.size())},
               {"moment", largest},
               {"tolerance", numbers.moment(sheet->tolerance) + unit}});
}

} // namespace cross
