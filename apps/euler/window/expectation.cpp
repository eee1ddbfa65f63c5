#include "apps/euler/window/expectation.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "topology/halfedge/check/validate.h"
#include "ui/app/expectation.h"

namespace euler {

namespace {

std::string counts(const Session& session)
{
    topology::EulerCounts sum;
    for (const Snapshot& in : session.present()) {
        const topology::EulerCounts n = topology::euler_counts(*in.solid);
        sum = {
            .V = sum.V + n.V, .E = sum.E + n.E, .F = sum.F + n.F, .L = sum.L + n.L, .S = sum.S + n.S, .G = sum.G + n.G};
    }
    std::string text;
    for (const std::size_t n : {sum.V, sum.E, sum.F, sum.L, sum.S, sum.G})
        text += (text.empty() ? "" : " ") + std::to_string(n);
    return text;
}

std::string place(const Session& session)
{
    return std::to_string(session.place()) + " of " + std::to_string(session.n_steps());
}

std::string differences(const Session& session)
{
    if (session.report() == nullptr) return "nothing";
    const std::string text = deltas(*session.report());
    return text.substr(std::min(text.find(": ") + 2, text.size()));
}

bool is_sound(const Snapshot& in) { return !topology::why_not_valid(*in.solid); }

std::string selected(const Session& session)
{
    if (!session.selection) return "nothing";
    const Snapshot& in = session.after()[session.selection->subject];
    const topology::Entity entity = session.selection->entity;
    constexpr std::array kinds{"face ", "loop ", "edge ", "half-edge ", "vertex "};
    return kinds[static_cast<std::size_t>(entity.kind)] + in.names->of(entity, *in.solid);
}

std::string asked(const Session& session)
{
    const bool asks = session.draft() && !session.draft()->is_complete();
    return asks ? std::string(session.draft()->next().prompt) : "nothing";
}

std::string verdict(const Session& session)
{
    return session.game() && session.game()->verdict() ? ui::Catalogue()(*session.game()->verdict()) : "nothing";
}

std::string hint(const Session& session)
{
    const bool has_one = session.game() && !session.game()->hints().empty();
    return has_one ? ui::Catalogue()(session.game()->hints().back()) : "nothing";
}

// "half-edges"
std::string table_seen(const Workspace& workspace)
{
    if (workspace.structure == Structure::WingedEdges) return "winged edges";
    const auto entry = std::ranges::find(tables(), workspace.table, &TableEntry::value);
    std::string name(entry->label);
    name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    return name;
}

const ui::Facts<Session>& facts()
{
    static const ui::Facts<Session> all(
        {
            {"counts", counts},
            {"place", place},
            {"step", [](const Session& s) { return s.report() == nullptr ? "nothing" : s.report()->name; }},
            {"deltas", differences},
            {"valid", [](const Session& s) { return ui::yes_or_no(std::ranges::all_of(s.present(), is_sound)); }},
            {"selection", selected},
            {"asked", asked},
            {"verdict", verdict},
            {"hint", hint},
            {"fault", [](const Session& s) { return s.script_fault ? ui::Catalogue()(*s.script_fault) : "nothing"; }},
            {"points", [](const Session& s) { return std::to_string(s.points()); }},
        },
        ", table");
    return all;
}

} // namespace

std::optional<std::string> why_not(std::string_view expectation, Application& application)
{
    if (constexpr std::string_view table = "table"; ui::first_word(expectation).first == table)
        return ui::compared(table, table_seen(application.workspace()),
                            std::string(ui::first_word(expectation).second));
    return facts().mismatch(expectation, application.session());
}

} // namespace euler
