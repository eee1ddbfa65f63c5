#include "apps/frame/session/train_commands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "apps/frame/document/naming.h"
#include "apps/frame/document/selected_members.h"
#include "apps/frame/session/influence_commands.h"
#include "apps/frame/session/shown_method.h"
#include "apps/frame/tools/snap.h"
#include "femoop/edit/moving_load_change.h"
#include "femoop/methods/influence/load_path.h"
#include "femoop/methods/influence/usual_path.h"

namespace frame {

using femoop::ExtremeKind;
using femoop::Train;
using femoop::influence::LibraryTrain;
using femoop::influence::Stretch;
using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

const std::vector<Train>& trains_of(const Session& session) { return session.model().moving_loads.trains; }

/// Of the model and the line as they are now; null where there is none.
const drawing::StandingTrain* shown_train(const Session& session)
{
    const bool has_line = session.influence.picture(session.model(), session.generation(), session.view) != nullptr;
    return has_line ? session.influence.standing() : nullptr;
}

Reason needs_drawn_line(const Workspace& workspace)
{
    if (Reason reason = needs_influence_line(workspace)) return reason;
    const Session& session = workspace.session;
    if (session.influence.picture(session.model(), session.generation(), session.view) != nullptr) return std::nullopt;
    return translatable("the model has no results");
}

Reason needs_own_trains(const Workspace& workspace)
{
    if (!trains_of(workspace.session).empty()) return std::nullopt;
    return translatable("the model has no trains; take one from the menu Trains");
}

/// On the influence line, or in the envelope of trains.
Reason needs_trains(const Workspace& workspace)
{
    const Session& session = workspace.session;
    const bool is_enveloped = session.shows_train_envelope() && !session.influence.is_on(session.model());
    if (is_enveloped) return std::nullopt;
    if (Reason reason = needs_influence_line(workspace)) return reason;
    return needs_own_trains(workspace);
}

Reason why_no_train_path(const Workspace& workspace)
{
    if (!workspace.session.model().members.empty()) return std::nullopt;
    return translatable("the model has no member that a train could run along");
}

Reason why_no_path(const Workspace& workspace)
{
    const std::vector<femoop::MemberId> members = selected_members(workspace.session.selection);
    if (members.empty()) return translatable("no member is selected; select those that a load moves along");
    if (femoop::influence::row_of(workspace.session.model(), members)) return std::nullopt;
    return translatable("the selected members are no row, each beginning where another ends; select such ones");
}

/// Lines and trains that name no path take the first one that passes them.
void add_path(Workspace& workspace)
{
    Session& session = workspace.session;
    const auto row = femoop::influence::row_of(session.model(), selected_members(session.selection));
    femoop::LoadPath path{fresh_name(session.model().moving_loads.paths, &femoop::LoadPath::id, "path"), row.value()};
    session.change({{translatable("Add path: {name}"), {{"name", path.id}}},
                    [&path](Document& document) { lead_with(document.model.moving_loads, std::move(path)); }});
}

Reason why_no_train_envelope(const Workspace& workspace)
{
    if (Reason reason = needs_own_trains(workspace)) return reason;
    return why_no_influence_line(workspace);
}

Reason needs_train_envelope(const Workspace& workspace)
{
    if (workspace.session.shows_train_envelope()) return std::nullopt;
    return translatable("no envelope of trains is shown; press Shift+E");
}

void show_train_envelope(Workspace& workspace, bool is_on)
{
    Session& session = workspace.session;
    close_other_methods(workspace, ShownMethod::TrainEnvelope);
    session.view.is_envelope = is_on;
    session.train_envelope.turn(is_on);
}

Reason needs_train(const Workspace& workspace)
{
    if (Reason reason = needs_influence_line(workspace)) return reason;
    if (shown_train(workspace.session) != nullptr) return std::nullopt;
    return translatable("no train stands on the influence line; press R or take one from the menu Trains");
}

Reason needs_axles(const Workspace& workspace)
{
    if (Reason reason = needs_train(workspace)) return reason;
    if (!shown_train(workspace.session)->train.axles.empty()) return std::nullopt;
    return translatable("the train has no axles that could be moved");
}

Reason needs_candidates(const Workspace& workspace)
{
    if (Reason reason = needs_axles(workspace)) return reason;
    if (!workspace.session.influence.candidates().empty()) return std::nullopt;
    return translatable("the train does nothing to this effect, wherever it stands");
}

Reason needs_both_directions(const Workspace& workspace)
{
    if (Reason reason = needs_axles(workspace)) return reason;
    if (shown_train(workspace.session)->train.both_directions) return std::nullopt;
    return translatable("the train runs in one direction alone");
}

// From one to the next, and after the last one the line alone.
void choose_next_train(Workspace& workspace)
{
    Session& session = workspace.session;
    if (!session.influence.is_on(session.model())) return session.train_envelope.choose_next(session.model());
    const std::vector<Train>& all = trains_of(session);
    const auto now = std::ranges::find(all, session.influence.train().name, &Train::id);
    const auto next = now == all.end() ? all.begin() : now + 1;
    session.influence.choose_train(next == all.end() ? std::string() : next->id);
}

void seek_other(Workspace& workspace)
{
    const bool is_max = shown_train(workspace.session)->kind == ExtremeKind::Max;
    workspace.session.influence.seek(is_max ? ExtremeKind::Min : ExtremeKind::Max);
}

// Where the axles are away it comes from where it would come onto the path.
AskedTrain::Place place_of_train(const Session& session)
{
    const femoop::influence::Placing& placing = shown_train(session)->placing;
    const Stretch along = session.influence.positions(placing.reversed);
    return {placing.position.value_or(placing.reversed ? along.to : along.from), placing.reversed};
}

// To the next round place.
void move_train(Workspace& workspace, double direction)
{
    constexpr double n_steps = 200.0;
    Session& session = workspace.session;
    AskedTrain::Place place = place_of_train(session);
    const Stretch along = session.influence.positions(place.reversed);
    const double size = round_grid((along.to - along.from) / n_steps), steps = direction * place.position / size;
    constexpr double here = 1e-6; // of a step
    place.position = direction * size * (std::floor(steps + here) + 1.0);
    session.influence.put_train(place);
}

// Forwards in the order of the places, then reversed; after the last one the first.
void put_at_candidate(Workspace& workspace, bool is_next)
{
    Session& session = workspace.session;
    const AskedTrain::Place now = place_of_train(session);
    const std::vector<CandidatePosition>& all = session.influence.candidates();
    const auto is_beyond = [&](const CandidatePosition& one) {
        const AskedTrain::Place place{one.position, one.reversed};
        if (session.influence.stands_at(place)) return false;
        const bool is_greater = std::tuple(place.reversed, place.position) > std::tuple(now.reversed, now.position);
        return is_greater == is_next;
    };
    const CandidatePosition* found = is_next ? &all.front() : &all.back();
    if (is_next) {
        const auto next = std::ranges::find_if(all, is_beyond);
        if (next != all.end()) found = &*next;
    } else {
        const auto previous = std::find_if(all.rbegin(), all.rend(), is_beyond);
        if (previous != all.rend()) found = &*previous;
    }
    session.influence.put_train({found->position, found->reversed});
}

// The axles stand where they stood, in the other order.
void turn_train(Workspace& workspace)
{
    Session& session = workspace.session;
    AskedTrain::Place place = place_of_train(session);
    double length = 0.0;
    for (const double spacing : shown_train(session)->placing.spacings) length += spacing;
    place.position += place.reversed ? length : -length;
    place.reversed = !place.reversed;
    session.influence.put_train(place);
}

femoop::LoadPathReference path_of_line(const Session& session)
{
    std::vector<femoop::MemberId> members;
    const auto* const line = session.influence.picture(session.model(), session.generation(), session.view);
    for (const femoop::influence::PathMember& on : line->path.members) members.push_back(on.member);
    const std::vector<femoop::LoadPath>& paths = session.model().moving_loads.paths;
    const auto named = std::ranges::find(paths, members, &femoop::LoadPath::members);
    if (named == paths.end()) return members;
    return femoop::PathId(static_cast<std::size_t>(named - paths.begin()));
}

/// A train of the library by its name there.
using TrainEntry = ui::Choice<std::string_view>;
constexpr std::array library_entries{
    TrainEntry{"HS20-44 truck", "train.hs20-truck", translatable("HS20-44 truck")},
    TrainEntry{"HS20-44 lane", "train.hs20-lane", translatable("HS20-44 lane")},
    TrainEntry{"HL-93 truck + lane", "train.hl93-truck", translatable("HL-93 truck + lane")},
    TrainEntry{"HL-93 tandem + lane", "train.hl93-tandem", translatable("HL-93 tandem + lane")},
    TrainEntry{"Cooper E80 engines", "train.e80", translatable("Cooper E80 engines")},
    TrainEntry{"LM1 lane 1", "train.lm1-lane-1", translatable("LM1 lane 1")},
    TrainEntry{"LM1 lane 2", "train.lm1-lane-2", translatable("LM1 lane 2")},
    TrainEntry{"LM1 lane 3", "train.lm1-lane-3", translatable("LM1 lane 3")},
    TrainEntry{"LM71", "train.lm71", translatable("LM71")},
    TrainEntry{"TB-450", "train.tb450", translatable("TB-450")},
};

} // namespace

std::string chosen_train(const Session& session)
{
    const std::string& name = session.influence.train().name;
    const std::vector<Train>& all = trains_of(session);
    return std::ranges::find(all, name, &Train::id) != all.end() ? name : std::string();
}

void ask_governing(Workspace& workspace, const femoop::MovingEffect& effect, std::optional<ExtremeKind> which)
{
    Session& session = workspace.session;
    session.influence.ask(session.model(), effect, session.train_envelope.governing(session.model(), effect, which));
    workspace.tool_controller.select(ToolKind::Influence);
}

std::vector<LibraryCommand> library_commands()
{
    std::vector<LibraryCommand> all;
    for (const LibraryTrain& train : femoop::influence::train_library()) {
        const auto* const entry = std::ranges::find(library_entries, train.name, &TrainEntry::value);
        all.push_back({entry->id, entry->label, &train});
    }
    return all;
}

void take_from_library(Session& session, const LibraryTrain& entry)
{
    Train train = train_from(entry, session.model().units, path_of_line(session));
    const bool is_there = std::ranges::find(trains_of(session), train) != trains_of(session).end();
    if (!is_there) {
        train.id = fresh_train_name(trains_of(session), train.id);
        const bool is_added = session.change_soundly(
            {{translatable("Add train: {name}"), {{"name", train.id}}},
             [&train](Document& document) { document.model.moving_loads.trains.push_back(train); }});
        if (!is_added) return;
    }
    session.influence.choose_train(train.id);
}

void add_train_commands(CommandTable& table)
{
    Menu menu(table, translatable("Trains"));
    menu.step({"train.path", translatable("Path along the selected members")}, add_path, why_no_path);
    menu.step({"train.next", translatable("The next train on the influence line"), {{Key::R, {}}}}, choose_next_train,
              needs_trains);
    menu.step({"train.extreme", translatable("Its largest or its least value"), {{Key::R, ui::ctrl_shift}}}, seek_other,
              needs_train);
    menu.step(
        {"train.worst", translatable("Back to where it is worst"), {{Key::Down, ui::ctrl}}},
        [](Workspace& workspace) { workspace.session.influence.put_train_back(); }, needs_train);
    menu.step(
        {"train.forth", translatable("Move it forth along the path"), {{Key::Right, ui::ctrl}}},
        [](Workspace& workspace) { move_train(workspace, 1.0); }, needs_axles);
    menu.step(
        {"train.back", translatable("Move it back along the path"), {{Key::Left, ui::ctrl}}},
        [](Workspace& workspace) { move_train(workspace, -1.0); }, needs_axles);
    menu.step(
        {"train.candidate.next", translatable("To the next candidate"), {{Key::Right, ui::ctrl_shift}}},
        [](Workspace& workspace) { put_at_candidate(workspace, true); }, needs_candidates);
    menu.step(
        {"train.candidate.previous", translatable("To the previous candidate"), {{Key::Left, ui::ctrl_shift}}},
        [](Workspace& workspace) { put_at_candidate(workspace, false); }, needs_candidates);
    menu.step({"train.turn", translatable("Turn it about"), {{Key::Up, ui::ctrl}}}, turn_train, needs_both_directions);
    menu.step(
        {"train.edit", translatable("Trains…"), {{Key::Y, {}}}},
        [](Workspace& workspace) { workspace.trains.open(workspace.session); }, why_no_train_path);
    menu.toggle(
        {"train.envelope", translatable("Envelope of trains"), {{Key::E, ui::shift}}},
        [](const Workspace& workspace) {
            const Session& session = workspace.session; // behind a line that was asked for over it, it comes back
            return session.shows_train_envelope() && !session.influence.is_on(session.model());
        },
        show_train_envelope, why_no_train_envelope);
    menu.step(
        {"train.envelope.with", translatable("The next case that stays beside the trains"), {{Key::Y, ui::shift}}},
        [](Workspace& workspace) { workspace.session.train_envelope.choose_next_case(workspace.session.model()); },
        needs_train_envelope);
    for (const LibraryCommand& entry : library_commands())
        menu.step(
            {entry.id, entry.label},
            [train = entry.train](Workspace& workspace) { take_from_library(workspace.session, *train); },
            needs_drawn_line);
}

} // namespace frame
