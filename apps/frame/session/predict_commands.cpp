#include "apps/frame/session/predict_commands.h"

namespace frame {

using ui::Key;
using ui::translatable;

namespace {

using Reason = std::optional<ui::Phrase>;

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

void add_predict_commands(CommandTable& table)
{
    constexpr std::string_view menu = translatable("View");
    table.add({.id = "view.hide_results",
               .menu = menu,
               .label = translatable("Hide the results, or reveal them"),
               .shortcuts = {{Key::H, {}}},
               .run = hide_or_reveal,
               .is_on = [](const Desk& desk) { return desk.session.hidden.has_value(); }});
    table.add({.id = "view.clear_guess",
               .menu = menu,
               .label = translatable("Wipe out what was guessed"),
               .run = [](Desk& desk) { desk.session.prediction.clear(); },
               .why_not = [](const Desk& desk) -> Reason {
                   if (!desk.session.prediction.is_empty()) return std::nullopt;
                   return translatable("nothing was guessed yet");
               }});
}

} // namespace frame
