#include "apps/frame/session/predict_commands.h"

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

constexpr ShowSet results{Show::Reactions, Show::N,  Show::V, Show::Vy,       Show::Vz,    Show::M,
                          Show::My,        Show::Mz, Show::T, Show::Deformed, Show::Thrust};

} // namespace

bool is_hideable(Show item) { return results.contains(item); }

namespace {

void hide(Session& session)
{
    session.hidden = session.view.show & results;
    session.view.show = session.view.show - results;
}

void reveal(Workspace& workspace)
{
    Session& session = workspace.session;
    session.view.show = session.view.show | *session.hidden;
    session.hidden.reset();
    if (!session.prediction.is_empty() && !session.prediction.is_of_line()) session.view.show.insert(Show::M);
    if (workspace.tool_controller.kind() == ToolKind::Predict) workspace.tool_controller.select(ToolKind::Select);
}

} // namespace

void hide_or_reveal(Workspace& workspace)
{
    if (workspace.session.hidden) reveal(workspace);
    else hide(workspace.session);
}

Reason why_not_predict(const Workspace& workspace)
{
    const Session& session = workspace.session;
    if (session.shown_line() != nullptr) return std::nullopt;
    if (session.model().analysis != femoop::AnalysisKind::Frame2d)
        return translatable("moments are guessed on plane frames only");
    if (!session.solution().results) return translatable("the model has no results");
    if (session.view.is_envelope) return translatable("an envelope is no diagram of one case; choose a case");
    return std::nullopt;
}

void begin_to_predict(Workspace& workspace)
{
    if (!workspace.session.hidden) hide(workspace.session);
    workspace.tool_controller.select(ToolKind::Predict);
}

bool is_predicting(const Workspace& workspace)
{
    return workspace.tool_controller.kind() == ToolKind::Predict && !workspace.session.prediction.is_empty();
}

namespace {

Reason why_not_clear(const Workspace& workspace)
{
    if (!workspace.session.prediction.is_empty()) return std::nullopt;
    return translatable("nothing was guessed yet");
}

} // namespace

void add_predict_commands(CommandTable& table)
{
    Menu menu(table, methods_menu);
    menu.step({"view.hide_results", translatable("Hide the results, or reveal them"), {{Key::H, {}}}}, hide_or_reveal)
        .is_on = [](const Workspace& workspace) { return workspace.session.hidden.has_value(); };
    menu.step(
        {"view.clear_guess", translatable("Wipe out what was guessed")},
        [](Workspace& workspace) { workspace.session.prediction.clear(); }, why_not_clear);
}

} // namespace frame
