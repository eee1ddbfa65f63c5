#include "apps/frame/session/view_commands.h"

#include <algorithm>
#include <utility>

#include "apps/drawing/results/envelope_cases.h"
#include "apps/frame/document/naming.h"
#include "apps/frame/view/kept_view.h"
#include "ui/workspace/standard_commands.h"

namespace frame {

using ui::Key;
using ui::Message;
using ui::translatable;
using ui::standard::view_menu;

namespace {

const std::vector<NamedView>& views(const Session& session) { return session.document().companion.views; }

void change(Session& session, std::string_view what, const std::string& name, auto&& command)
{
    session.change({{what, {{"name", name}}}, [&](Document& document) { command(document.companion.views); }});
}

// The walk goes on from the view that was shown last, and begins again at its end.
void walk_views(Session& session, Direction way)
{
    const std::size_t n = views(session).size();
    const std::size_t last = session.shown_view.value_or(way == Direction::Later ? n - 1 : 0) % n;
    show_view(session, (last + (way == Direction::Later ? 1 : n - 1)) % n);
}

void walk_cases(Session& session, Direction way)
{
    const std::size_t n = session.model().n_cases();
    session.view.is_envelope = false;
    session.view.load_case = femoop::CaseId((session.view.load_case.index + (way == Direction::Later ? 1 : n - 1)) % n);
}

void walk(Session& session, Direction way)
{
    if (session.truss.is_on())
        return session.truss.step(way == Direction::Later ? AskedTruss::Way::On : AskedTruss::Way::Back);
    if (views(session).empty()) walk_cases(session, way);
    else walk_views(session, way);
}

// The cases of the envelope; none where it is of all.
std::vector<std::string> chosen_cases(const Session& session)
{
    const femoop::Model& model = session.model();
    std::vector<std::string> names;
    for (const femoop::CaseId id : envelope_cases(model, session.view)) names.push_back(model.case_name(id));
    return names.size() == model.n_cases() ? std::vector<std::string>{} : names;
}

ui::Reason why_not_walk(const Workspace& workspace)
{
    if (workspace.session.truss.is_on() || !views(workspace.session).empty() || workspace.session.model().n_cases() > 1)
        return std::nullopt;
    return translatable("the model has no other load case");
}

ui::Reason why_not_keep_view(const Workspace& workspace)
{
    if (!workspace.session.shows_train_envelope()) return std::nullopt;
    return translatable("an envelope of trains is no kept view; choose a load case or another envelope");
}

} // namespace

void add_view_commands(CommandTable& table)
{
    Menu menu(table, view_menu);
    menu.step(
        {"view.next", translatable("Next view, load case or stage"), {{Key::PageDown, {}}}},
        [](Workspace& workspace) { walk(workspace.session, Direction::Later); }, why_not_walk);
    menu.step(
        {"view.previous", translatable("Previous view, load case or stage"), {{Key::PageUp, {}}}},
        [](Workspace& workspace) { walk(workspace.session, Direction::Earlier); }, why_not_walk);
    menu.step(
        {"view.keep", translatable("Keep this view"), {{Key::B, ui::ctrl}}},
        [](Workspace& workspace) { workspace.requests.push_back(Request::KeepView); }, why_not_keep_view);
    menu.step({"view.list", translatable("Kept views…"), {{Key::B, ui::ctrl_shift}}},
              [](Workspace& workspace) { workspace.requests.push_back(Request::ViewList); });
}

void keep_view(Session& session, const std::optional<Region>& region)
{
    const DrawOptions& now = session.view;
    NamedView view{.name = fresh_name(views(session), &NamedView::name, now.tr("View 1")),
                   .show = now.show,
                   .diagrams = now.diagram_factor,
                   .loads = now.load_factor,
                   .displacements = now.deformation_scale,
                   .region = region};
    if (now.is_envelope) view.envelope = chosen_cases(session);
    else if (now.load_case.index < session.model().n_cases()) view.load_case = session.model().case_name(now.load_case);
    const std::string name = view.name;
    change(session, translatable("Keep view: {name}"), name, [&](auto& list) { list.push_back(std::move(view)); });
    session.shown_view = views(session).size() - 1;
    session.notify({translatable("Kept as {name}; PageDown and PageUp walk through the views"), {{"name", name}}});
}

namespace {

void notify_lost_case(Session& session, const NamedView& view)
{
    const auto is_lost = [&](const std::string& id) { return !session.model().find_case(id); };
    const auto notify = [&](std::string_view sentence, const std::string& id) {
        session.notify({sentence, {{"name", view.name}, {"case", id}}});
    };
    const auto lost = std::ranges::find_if(view.envelope, is_lost);
    if (lost != view.envelope.end())
        notify(translatable(
                   "{name}: the model has no load case or combination {case} any more; the envelope is without it"),
               *lost);
    if (view.load_case && is_lost(*view.load_case))
        notify(translatable("{name}: the model has no load case or combination {case} any more; another is shown"),
               *view.load_case);
}

} // namespace

void show_view(Session& session, std::size_t place)
{
    const NamedView& view = views(session).at(place);
    look_as(session.view, view, session.model());
    session.hidden.reset();
    session.draw_state.camera.reset();
    session.look_at = view.region;
    session.shown_view = place;
    notify_lost_case(session, view);
}

std::optional<Message> rename_view(Session& session, std::size_t place, const std::string& name)
{
    const std::string before = views(session).at(place).name;
    if (before == name) return std::nullopt;
    if (auto reason = objection(views(session), &NamedView::name, place, name)) return reason;
    change(session, translatable("Rename: {name}"), before, [&](auto& list) { list[place].name = name; });
    return std::nullopt;
}

void move_view(Session& session, std::size_t place, Direction way)
{
    const std::size_t other = way == Direction::Later ? place + 1 : place - 1;
    change(session, translatable("Move view: {name}"), views(session).at(place).name,
           [&](auto& list) { std::swap(list.at(place), list.at(other)); });
}

void erase_view(Session& session, std::size_t place)
{
    change(session, translatable("Delete view: {name}"), views(session).at(place).name,
           [&](auto& list) { list.erase(list.begin() + static_cast<std::ptrdiff_t>(place)); });
}

} // namespace frame
