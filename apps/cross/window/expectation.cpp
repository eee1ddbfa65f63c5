#include "apps/cross/window/expectation.h"

#include "apps/cross/session/exercise_report.h"
#include "apps/cross/view/pupil_words.h"
#include "apps/cross/window/cell_names.h"
#include "ui/app/expectation.h"
#include "ui/scenario/words.h"
#include "ui/text/number_format.h"

namespace cross {

namespace {

std::string turns(const Session& session)
{
    if (session.turn_tree() == nullptr || session.turn_tree()->length() == 0) return "nothing";
    std::string words;
    for (const TurnTree::Turn& turn : session.turn_tree()->turns()) {
        const auto& joints = session.solution().task->problem.joints;
        words += (words.empty() ? "" : " ") +
                 (turn ? session.document().model[joints[turn->index].node].id : std::string("all"));
    }
    return words;
}

/// "BA -86.5": the moment at the end that the wanted words begin with.
std::optional<std::string> total_mismatch(const Session& session, std::string_view rest)
{
    const std::string_view label = rest.substr(0, rest.find(' '));
    const auto& task = session.solution().task;
    const auto end = task ? task->problem.find_end(label) : std::nullopt;
    if (!end) return "expect: found \"" + std::string(label) + "\", wanted a member end of the sheet";
    const double moment = present_moments(session.document(), session.solution())[end->index];
    return ui::compared("total", std::string(label) + " " + ui::number_text(moment), std::string(rest));
}

/// "factor BA right": what is said of a cell.
std::optional<std::string> cell_mismatch(const Session& session, std::string_view expectation)
{
    const auto words = ui::words_of(expectation);
    const auto named = cell_named(session, words);
    if (!named) return "expect: found \"" + std::string(expectation) + "\", wanted a cell of the sheet";
    std::string wanted;
    for (std::size_t i = named->n_words; i < words.size(); ++i) wanted += (wanted.empty() ? "" : " ") + words[i];
    const Worksheet& worksheet = *session.worksheet();
    std::string found = "not judged";
    if (worksheet.shows_judgement) found = ui::Catalogue()(verdict_text(worksheet.judgements[named->cell.index]));
    return ui::compared("cell", found.empty() ? "open" : found, wanted);
}

const ui::Facts<Session>& facts()
{
    static const ui::Facts<Session> all(
        {
            {"step",
             [](const Session& s) { return std::to_string(s.sheet() != nullptr ? s.sheet()->steps.size() : 0); }},
            {"turns", turns},
            {"branches",
             [](const Session& s) {
                 return std::to_string(s.turn_tree() != nullptr ? s.turn_tree()->branches().size() : 0);
             }},
            {"sheet", [](const Session& s) { return std::to_string(s.document().stage); }},
            {"balanced",
             [](const Session& s) { return ui::yes_or_no(s.sheet() != nullptr && s.sheet()->is_balanced); }},
            {"at", [](const Session& s) { return "rest " + ui::yes_or_no(s.phase() >= 1.0 && !s.is_playing); }},
            {"zoom", [](const Session& s) { return ui::number_text(s.look.zoom.factor, {.digits = 3}); }},
            {"theme", [](const Session& s) { return std::string(text(s.look.theme)); }},
            {"undo",
             [](const Session& s) {
                 const auto label = s.history().undo_label();
                 return label ? ui::Catalogue()(*label) : std::string("nothing");
             }},
            {"score",
             [](const Session& s) {
                 return s.worksheet() != nullptr ? std::to_string(s.points()) : std::string("nothing");
             }},
            {"exercise",
             [](const Session& s) { return s.worksheet() != nullptr ? exercise_name(s) : std::string("nothing"); }},
            {"typing",
             [](const Session& s) {
                 return s.cell() ? ui::Catalogue()(question(*s.worksheet(), s.document().model, *s.cell()))
                                 : std::string("nothing");
             }},
            {"hint",
             [](const Session& s) {
                 return s.hints().empty() ? std::string("nothing") : ui::Catalogue()(words_of(s.hints().back()));
             }},
            {"solved",
             [](const Session& s) { return ui::yes_or_no(s.worksheet() != nullptr && s.worksheet()->is_solved()); }},
        },
        ", total, cell");
    return all;
}

} // namespace

std::optional<std::string> why_not(std::string_view expectation, const Application& application)
{
    const auto [what, rest] = ui::first_word(expectation);
    if (what == "total") return total_mismatch(application.session(), rest);
    if (what == "cell") return cell_mismatch(application.session(), expectation);
    return facts().mismatch(expectation, application.session());
}

} // namespace cross
