#include "apps/frame/session/predict_commands.h"

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

constexpr ShowSet results{Show::Reactions, Show::N,  Show::V,  Show::Vy, Show::Vz,
                          Show::M,         Show::My, Show::Mz, Show::T,  Show::Deformed};

void hide(Session& session)
{
    session.hidden = session.view.show & results;
    session.view.show = session.view.show - results;
}

void reveal(Desk& desk)
{
    Session& session = desk.session;
    session.view.show = session.view.show | *session.hidden;
    session.hidden.reset();
    if (!session.prediction.is_empty()) session.view.show.insert(Show::M);
    if (desk.hand.kind() == ToolKind::Predict) desk.hand.take(ToolKind::Select);
}

} // namespace

void hide_or_reveal(Desk& desk)
{
    if (desk.session.hidden) reveal(desk);
    else hide(desk.session);
}

Reason why_not_predict(const Desk& desk)
{
    const Session& session = desk.session;
    if (session.model().analysis != femoop::AnalysisKind::Frame2d)
        return translatable("moments are guessed on plane frames only");
    if (!session.solution().results) return translatable("the model has no results");
    if (session.view.is_envelope) return translatable("an envelope is no diagram of one case; choose a case");
    return std::nullopt;
}

void begin_to_predict(Desk& desk)
{
    if (!desk.session.hidden) hide(desk.session);
    desk.hand.take(ToolKind::Predict);
}

bool is_predicting(const Desk& desk)
{
    return desk.hand.kind() == ToolKind::Predict && !desk.session.prediction.is_empty();
}

namespace {

Reason why_not_clear(const Desk& desk)
{
    if (!desk.session.prediction.is_empty()) return std::nullopt;
    return translatable("nothing was guessed yet");
}

} // namespace

void add_predict_commands(CommandTable& table)
{
    Menu menu(table, translatable("View"));
    menu.step({"view.hide_results", translatable("Hide the results, or reveal them"), {{Key::H, {}}}}, hide_or_reveal)
        .is_on = [](const Desk& desk) { return desk.session.hidden.has_value(); };
    menu.step(
        {"view.clear_guess", translatable("Wipe out what was guessed")},
        [](Desk& desk) { desk.session.prediction.clear(); }, why_not_clear);
}

} // namespace frame
