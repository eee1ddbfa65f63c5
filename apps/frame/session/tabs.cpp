#include "apps/frame/session/tabs.h"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

#include "apps/frame/session/edit_commands.h"
#include "ui/files/view_file.h"

namespace frame {

namespace {

// The shelf has the other tabs in their order, so those behind the present one stand one place earlier there.
std::size_t in_other_tabs(const Workspace& workspace, std::size_t place)
{
    return place < workspace.tab ? place : place - 1;
}

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b)
{
    std::error_code error;
    return std::filesystem::equivalent(a, b, error);
}

// What belongs to the person, not to the document.
void adopt_look(Session& session, const Session& from)
{
    session.view.tr = from.view.tr;
    session.view.numbers = from.view.numbers;
    session.view.theme = from.view.theme;
    session.view.units = from.view.units;
    session.view.unit_choices = from.view.unit_choices;
    session.view.layout = from.view.layout;
    const bool is_truss = femoop::is_truss(session.model().analysis);
    const bool was_truss = femoop::is_truss(from.model().analysis);
    session.view.show = is_truss == was_truss ? from.view.show : suited(from.view.show, is_truss);
    session.hidden = from.hidden;
    session.is_still = from.is_still;
    if (session.hidden && is_truss != was_truss) session.hidden = suited(*session.hidden, is_truss);
    session.view.moment_side = from.view.moment_side;
}

} // namespace

ShowSet suited(ShowSet show, bool is_truss)
{
    const auto [telling, silent] = is_truss ? std::pair{Show::N, Show::M} : std::pair{Show::M, Show::N};
    if (show.contains(silent) && !show.contains(telling)) {
        show.erase(silent);
        show.insert(telling);
    }
    return show;
}

std::size_t n_tabs(const Workspace& workspace) { return workspace.other_tabs.size() + 1; }

const Session& tab(const Workspace& workspace, std::size_t place)
{
    return place == workspace.tab ? workspace.session : workspace.other_tabs.at(in_other_tabs(workspace, place));
}

std::string tab_name(const Workspace& workspace, std::size_t place)
{
    const Session& session = tab(workspace, place);
    const std::string name = session.name();
    std::size_t number = 0, n_alike = 0;
    for (std::size_t i = 0; i < n_tabs(workspace); ++i) {
        if (tab(workspace, i).name() != name) continue;
        if (i <= place) ++number;
        ++n_alike;
    }
    if (n_alike < 2) return name;
    const auto path = session.path();
    return path ? (path->parent_path().filename() / name).string() : name + " (" + std::to_string(number) + ")";
}

void show_tab(Workspace& workspace, std::size_t place)
{
    if (place == workspace.tab) return;
    cancel_transform(workspace);
    const std::size_t source = in_other_tabs(workspace, place);
    Session next = std::move(workspace.other_tabs.at(source));
    adopt_look(next, workspace.session);
    workspace.session.settle();
    workspace.other_tabs.erase(workspace.other_tabs.begin() + static_cast<std::ptrdiff_t>(source));
    const std::size_t home = place > workspace.tab ? workspace.tab : workspace.tab - 1; // the shelf lost one before it
    workspace.other_tabs.insert(workspace.other_tabs.begin() + static_cast<std::ptrdiff_t>(home),
                                std::exchange(workspace.session, std::move(next)));
    workspace.tab = place;
    workspace.tool_controller.select(ToolKind::Select);
}

void add_tab(Workspace& workspace, Session session)
{
    cancel_transform(workspace);
    adopt_look(session, workspace.session);
    workspace.tool_controller.select(ToolKind::Select);
    if (workspace.session.is_untouched()) {
        workspace.session = std::move(session);
        return;
    }
    workspace.session.settle();
    workspace.other_tabs.insert(workspace.other_tabs.begin() + static_cast<std::ptrdiff_t>(workspace.tab),
                                std::exchange(workspace.session, std::move(session)));
    ++workspace.tab;
}

void close_tab(Workspace& workspace)
{
    cancel_transform(workspace);
    workspace.tool_controller.select(ToolKind::Select);
    if (workspace.other_tabs.empty()) {
        Session empty{Document{}};
        adopt_look(empty, workspace.session);
        workspace.session = std::move(empty);
        return;
    }
    const std::size_t next = std::min(workspace.tab, workspace.other_tabs.size() - 1);
    Session session = std::move(workspace.other_tabs[next]);
    adopt_look(session, workspace.session);
    workspace.other_tabs.erase(workspace.other_tabs.begin() + static_cast<std::ptrdiff_t>(next));
    workspace.session = std::move(session);
    workspace.tab = next;
}

void leave_tab(Workspace& workspace)
{
    if (workspace.session.is_dirty()) workspace.after_question = close_tab;
    else close_tab(workspace);
}

void new_document(Workspace& workspace, femoop::AnalysisKind kind)
{
    Document document;
    document.model.analysis = kind;
    add_tab(workspace, Session(std::move(document)));
}

namespace {

// Who points at a view file means the model that it stands beside, which brings it along.
std::filesystem::path model_meant(const std::filesystem::path& path)
{
    std::error_code unknown;
    const auto model = ui::model_of_view(path);
    return model && std::filesystem::exists(*model, unknown) ? *model : path;
}

std::optional<std::size_t> tab_of(const Workspace& workspace, const std::filesystem::path& file)
{
    for (std::size_t i = 0; i < n_tabs(workspace); ++i) {
        const auto& open = tab(workspace, i).path();
        if (open && is_same_file(*open, file)) return i;
    }
    return std::nullopt;
}

} // namespace

void tell_units(Session& session)
{
    const std::string chosen = session.view.unit_choices.text();
    if (chosen.empty() || session.notice) return;
    session.notify({ui::translatable("shown in the units that you chose: {units}; Shift+U changes them, the file keeps "
                                     "its own"),
                    {{"units", chosen}}});
}

bool open_file(Workspace& workspace, const std::filesystem::path& chosen, Session::Purpose purpose)
{
    const std::filesystem::path path = model_meant(chosen);
    if (const auto place = tab_of(workspace, path)) {
        show_tab(workspace, *place);
        return true;
    }
    Session session{Document{}};
    if (!session.open(path, purpose)) {
        workspace.session.refuse(path, *session.notice);
        return false;
    }
    workspace.session.notice.reset(); // such as that another file was not opened
    add_tab(workspace, std::move(session));
    tell_units(workspace.session);
    return true;
}

namespace {

// The first document that has something to lose; the present one, if it has.
std::optional<std::size_t> unsaved_tab(const Workspace& workspace)
{
    if (workspace.session.is_dirty()) return workspace.tab;
    for (std::size_t i = 0; i < n_tabs(workspace); ++i)
        if (tab(workspace, i).is_dirty()) return i;
    return std::nullopt;
}

} // namespace

std::string Workspace::name() const { return tab_name(*this, tab); }

bool Workspace::open_at_once(const std::filesystem::path& path) { return open_file(*this, path); }

void Workspace::leave_all(std::function<void(Workspace&)> then)
{
    const auto unsaved = unsaved_tab(*this);
    if (!unsaved) return then(*this);
    show_tab(*this, *unsaved);
    after_question = [then = std::move(then)](Workspace& workspace) {
        if (workspace.session.is_dirty()) close_tab(workspace);
        workspace.leave_all(then);
    };
}

bool Workspace::save_as(const std::filesystem::path& path)
{
    const auto place = tab_of(*this, path);
    if (!place || *place == tab) return session.save(path);
    session.notice = Notice{
        ui::lasting({ui::translatable("{file} is open in another tab; close it or choose another name"),
                     {{"file", path.filename().string()}}})};
    return false;
}

} // namespace frame
