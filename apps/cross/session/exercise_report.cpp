#include "apps/cross/session/exercise_report.h"

#include "apps/cross/view/numbers.h"
#include "apps/cross/view/pupil_words.h"

namespace cross {

namespace fc = femoop::cross;

namespace {

std::string text_in(const Session& session, std::size_t cell)
{
    const auto& written = session.document().pupil->written;
    return cell < written.size() ? written[cell] : "";
}

std::string question_with_unit(const Session& session, fc::BlankId id)
{
    const Worksheet& worksheet = *session.worksheet();
    const CellUnit unit = unit_of(worksheet, id, units_of(session.document().model, session.tr()));
    const std::string words = session.tr()(question(worksheet, session.document().model, id));
    return unit.name.empty() ? words : words + " [" + unit.name + "]";
}

} // namespace

tabular::Table exercise_table(const Session& session)
{
    const Worksheet& worksheet = *session.worksheet();
    const ui::Catalogue& tr = session.tr();
    tabular::Table table({tr("cell"), tr("number"), tr("judgement")});
    table.notes = {exercise_name(session), score_text(session)};
    for (std::size_t i = 0; i < worksheet.form.blanks.size(); ++i) {
        const fc::BlankId id(i);
        if (!worksheet.is_written(id) &&
            (!worksheet.shows_judgement || worksheet.judgements[i].verdict == fc::Verdict::Open))
            continue;
        const std::string verdict = worksheet.shows_judgement ? tr(verdict_text(worksheet.judgements[i])) : "";
        table.add_row({question_with_unit(session, id), tabular::written_cell(text_in(session, i)), verdict});
    }
    return table;
}

std::string exercise_description(const Session& session)
{
    const tabular::Table table = exercise_table(session);
    std::string words;
    for (const std::string& note : table.notes) words += note + "\n";
    for (const tabular::Row& row : table.rows) {
        const std::vector<std::string> texts = shown_texts(row);
        words += texts[0] + ": " + texts[1] + (texts[2].empty() ? "" : "  (" + texts[2] + ")") + "\n";
    }
    return words;
}

std::string score_text(const Session& session)
{
    const Worksheet& worksheet = *session.worksheet();
    std::size_t n_good = 0, n_written = 0;
    for (std::size_t i = 0; i < worksheet.form.blanks.size(); ++i) {
        if (worksheet.form.blanks[i].may_stay_empty) continue;
        n_good += worksheet.is_good(fc::BlankId(i)) ? 1 : 0;
        n_written += worksheet.is_written(fc::BlankId(i)) ? 1 : 0;
    }
    const std::string all = std::to_string(worksheet.n_needed());
    if (!worksheet.shows_judgement)
        return session.tr()("{n} of {all} cells filled", {{"n", std::to_string(n_written)}, {"all", all}});
    return session.tr()("{n} of {all} cells right, {points} of them the first time and without being shown",
                        {{"n", std::to_string(n_good)}, {"all", all}, {"points", std::to_string(session.points())}});
}

std::string exercise_name(const Session& session)
{
    const auto& seeded = session.document().pupil->seeded;
    if (!seeded) return session.tr()("A structure of your own as an exercise");
    return session.tr()("Exercise {level}.{seed}: {what}",
                        {{"level", std::to_string(static_cast<int>(seeded->difficulty))},
                         {"seed", std::to_string(seeded->seed)},
                         {"what", session.tr()(words_of(seeded->difficulty))}});
}

} // namespace cross
