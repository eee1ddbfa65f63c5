#include "apps/frame/session/truss_commands.h"

#include <string_view>

#include "apps/frame/session/shown_method.h"

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

/// What a method is called, and where it cannot be used.
struct MethodEntry {
    TrussMethod method;
    std::string_view command;
    std::string_view label;
    ui::Chord shortcut;
    std::string_view why_none; ///< with the reason
};

constexpr MethodEntry methods[] = {{TrussMethod::ZeroForces,
                                    "view.zero_forces",
                                    translatable("Zero-force bars"),
                                    {Key::Z, ui::shift},
                                    translatable("Zero-force bars are not looked for: {reason}.")},
                                   {TrussMethod::Joints,
                                    "view.joints",
                                    translatable("Truss joint by joint"),
                                    {Key::O, ui::shift},
                                    translatable("The truss does not go joint by joint: {reason}.")},
                                   {TrussMethod::Cremona,
                                    "view.cremona",
                                    translatable("Cremona diagram"),
                                    {Key::O, {}},
                                    translatable("No Cremona diagram: {reason}.")}};

const MethodEntry& entry_of(TrussMethod method) { return methods[static_cast<std::size_t>(method)]; }

void look_at(Workspace& workspace, TrussMethod method, bool is_on)
{
    Session& session = workspace.session;
    session.draw_state.camera.reset(); // it has half the sheet
    if (!is_on) return session.truss.close();
    close_other_methods(workspace, ShownMethod::Truss);
    session.truss.show(method);
}

Reason why_no_plane_truss(const Workspace& workspace)
{
    if (workspace.session.model().analysis == femoop::AnalysisKind::Truss2d) return std::nullopt;
    return translatable("zero-force bars, joints and Cremona diagrams are those of a plane truss");
}

} // namespace

const TrussPicture* shown_truss(const Session& session)
{
    if (session.influence.is_on(session.model())) return nullptr;
    return session.truss.picture(session.model(), session.shown_results(), session.generation(), session.view);
}

std::string method_name(TrussMethod method, const ui::Catalogue& tr) { return tr(entry_of(method).label); }

std::string why_no_truss_picture(const Session& session)
{
    const std::string& reason = session.truss.why_none();
    if (!session.truss.method() || reason.empty()) return {};
    return session.view.tr(entry_of(*session.truss.method()).why_none, {{"reason", reason}});
}

void add_truss_commands(CommandTable& table)
{
    Menu menu(table, methods_menu);
    for (const MethodEntry& entry : methods) {
        const TrussMethod method = entry.method;
        menu.toggle(
            {entry.command, entry.label, {entry.shortcut}},
            [method](const Workspace& workspace) { return workspace.session.truss.method() == method; },
            [method](Workspace& workspace, bool is_on) { look_at(workspace, method, is_on); }, why_no_plane_truss);
    }
}

} // namespace frame
