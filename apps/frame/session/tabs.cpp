#include "apps/frame/session/tabs.h"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

#include "apps/frame/document/companion/companion_file.h"
#include "apps/frame/session/edit_commands.h"

namespace frame {

namespace {

// The shelf has the other tabs in their order, so those behind the present one stand one place earlier there.
std::size_t on_shelf(const Desk& desk, std::size_t place) { return place < desk.tab ? place : place - 1; }

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b)
{
    std::error_code error;
    return std::filesystem::equivalent(a, b, error);
}

// What belongs to the person, not to the document.
void take_look(Session& session, const Session& from)
{
    session.view.tr = from.view.tr;
    session.view.numbers = from.view.numbers;
    session.view.theme = from.view.theme;
    session.view.units = from.view.units;
    session.view.layout = from.view.layout;
    const bool is_truss = femoop::is_truss(session.model().analysis);
    const bool was_truss = femoop::is_truss(from.model().analysis);
    session.view.show = is_truss == was_truss ? from.view.show : suited(from.view.show, is_truss);
    session.hidden = from.hidden;
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

std::size_t n_tabs(const Desk& desk) { return desk.shelf.size() + 1; }

const Session& tab(const Desk& desk, std::size_t place)
{
    return place == desk.tab ? desk.session : desk.shelf.at(on_shelf(desk, place));
}

void show_tab(Desk& desk, std::size_t place)
{
    if (place == desk.tab) return;
    cancel_transform(desk);
    const std::size_t source = on_shelf(desk, place);
    Session next = std::move(desk.shelf.at(source));
    take_look(next, desk.session);
    desk.session.settle();
    desk.shelf.erase(desk.shelf.begin() + static_cast<std::ptrdiff_t>(source));
    const std::size_t home = place > desk.tab ? desk.tab : desk.tab - 1; // the shelf lost one before it
    desk.shelf.insert(desk.shelf.begin() + static_cast<std::ptrdiff_t>(home),
                      std::exchange(desk.session, std::move(next)));
    desk.tab = place;
    desk.hand.take(ToolKind::Select);
}

void add_tab(Desk& desk, Session session)
{
    cancel_transform(desk);
    take_look(session, desk.session);
    desk.hand.take(ToolKind::Select);
    if (desk.session.is_untouched()) {
        desk.session = std::move(session);
        return;
    }
    desk.session.settle();
    desk.shelf.insert(desk.shelf.begin() + static_cast<std::ptrdiff_t>(desk.tab),
                      std::exchange(desk.session, std::move(session)));
    ++desk.tab;
}

void close_tab(Desk& desk)
{
    cancel_transform(desk);
    desk.hand.take(ToolKind::Select);
    if (desk.shelf.empty()) {
        Session empty{Document{}};
        take_look(empty, desk.session);
        desk.session = std::move(empty);
        return;
    }
    const std::size_t next = std::min(desk.tab, desk.shelf.size() - 1);
    Session session = std::move(desk.shelf[next]);
    take_look(session, desk.session);
    desk.shelf.erase(desk.shelf.begin() + static_cast<std::ptrdiff_t>(next));
    desk.session = std::move(session);
    desk.tab = next;
}

void new_document(Desk& desk, femoop::AnalysisKind kind)
{
    Document document;
    document.model.analysis = kind;
    add_tab(desk, Session(std::move(document)));
}

namespace {

// Who points at a view file means the model that it stands beside, which brings it along.
std::filesystem::path model_meant(const std::filesystem::path& path)
{
    std::error_code unknown;
    const auto model = model_of_companion(path);
    return model && std::filesystem::exists(*model, unknown) ? *model : path;
}

std::optional<std::size_t> tab_of(const Desk& desk, const std::filesystem::path& file)
{
    for (std::size_t i = 0; i < n_tabs(desk); ++i) {
        const auto& open = tab(desk, i).path();
        if (open && is_same_file(*open, file)) return i;
    }
    return std::nullopt;
}

} // namespace

bool open_file(Desk& desk, const std::filesystem::path& chosen, Session::Purpose purpose)
{
    const std::filesystem::path path = model_meant(chosen);
    if (const auto place = tab_of(desk, path)) {
        show_tab(desk, *place);
        return true;
    }
    Session session{Document{}};
    if (!session.open(path, purpose)) {
        desk.session.refuse(path, *session.notice);
        return false;
    }
    add_tab(desk, std::move(session));
    return true;
}

bool save_as(Desk& desk, const std::filesystem::path& path)
{
    const auto place = tab_of(desk, path);
    if (!place || *place == desk.tab) return desk.session.save(path);
    desk.session.notice = Notice{{ui::translatable("{file} is open in another tab; close it or choose another name"),
                                  {{"file", path.filename().string()}}},
                                 {}};
    return false;
}

} // namespace frame
