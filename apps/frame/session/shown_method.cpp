#include "apps/frame/session/shown_method.h"

#include "apps/frame/session/free_body_commands.h"
#include "apps/frame/session/funicular_commands.h"
#include "apps/frame/session/truss_commands.h"
#include "apps/frame/session/virtual_work_commands.h"
#include "femoop/io/free_body/free_body_text.h"
#include "femoop/io/funicular/funicular_text.h"
#include "femoop/io/truss/truss_text.h"
#include "femoop/io/virtual_work/virtual_work_text.h"

namespace frame {

void close_other_methods(Workspace& workspace, ShownMethod but)
{
    Session& session = workspace.session;
    const auto close = [&](ShownMethod method, ToolKind tool, auto& asked) {
        if (method == but) return;
        asked.clear();
        if (workspace.tool_controller.kind() == tool) workspace.tool_controller.select(ToolKind::Select);
    };
    close(ShownMethod::FreeBody, ToolKind::FreeBody, session.free_body);
    close(ShownMethod::Funicular, ToolKind::Funicular, session.funicular);
    close(ShownMethod::VirtualWork, ToolKind::VirtualWork, session.virtual_work);
    if (but != ShownMethod::InfluenceLine) session.influence.clear();
    if (but != ShownMethod::Truss) session.truss.close();
}

namespace {

femoop::truss::Sheet truss_sheet(const TrussPicture& shown, const Session& session)
{
    const auto sheet_of = [&](auto* sheet) {
        return sheet(session.model(), shown.truss, session.view.load_case, session.tr());
    };
    switch (shown.method) {
    case TrussMethod::ZeroForces: return sheet_of(femoop::truss::zero_force_sheet);
    case TrussMethod::Joints: return sheet_of(femoop::truss::joint_sheet);
    case TrussMethod::Cremona: break;
    }
    return sheet_of(femoop::truss::diagram_sheet);
}

} // namespace

std::string shown_method_latex(const Session& session)
{
    const femoop::Model& model = session.model();
    const ui::Catalogue& tr = session.tr();
    std::string text;
    if (const auto* const body = lifted_body(session))
        text += femoop::free_body::free_body_latex(body->lifted, model, body->about, tr);
    if (const auto* const shown = shown_funicular(session))
        text += femoop::funicular::funicular_latex(shown->funicular, shown->chain, model, tr);
    if (const auto* const shown = shown_work(session))
        text += femoop::virtual_work::virtual_work_latex(shown->work, model, tr);
    if (const auto* const shown = shown_truss(session)) text += latex(truss_sheet(*shown, session));
    return text;
}

} // namespace frame
