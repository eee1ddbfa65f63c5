#include "apps/euler/session/challenge/challenge_commands.h"

#include <array>
#include <utility>
#include <variant>

#include "topology/tables/entity_tables.h"

namespace euler {

using ui::Reason;
using ui::translatable;

namespace {

Game easy(std::uint32_t seed) { return Game(reach_challenge(seed, Level::Easy)); }
Game middle(std::uint32_t seed) { return Game(reach_challenge(seed, Level::Middle)); }
Game hard(std::uint32_t seed) { return Game(reach_challenge(seed, Level::Hard)); }
Game which(std::uint32_t seed) { return Game(which_operator(seed)); }
Game pointer(std::uint32_t seed) { return Game(broken_pointer(seed)); }

struct Entry {
    std::string_view id, label;
    Game (*make)(std::uint32_t seed);
};
constexpr std::array entries{
    Entry{"challenge.reach_easy", translatable("Reach a solid: easy"), easy},
    Entry{"challenge.reach_middle", translatable("Reach a solid: middle"), middle},
    Entry{"challenge.reach_hard", translatable("Reach a solid: hard"), hard},
    Entry{"challenge.which", translatable("Which operator was applied?"), which},
    Entry{"challenge.pointer", translatable("Fix the broken pointer"), pointer},
};

constexpr std::array<std::string_view, entries.size()> ids = [] {
    std::array<std::string_view, entries.size()> names;
    for (std::size_t i = 0; i < entries.size(); ++i) names[i] = entries[i].id;
    return names;
}();

Reason needs_challenge(const Workspace& workspace)
{
    if (!workspace.session.game()) return translatable("no challenge is on");
    if (workspace.session.game()->is_over()) return translatable("the challenge is over");
    return std::nullopt;
}

void begin(Workspace& workspace, const Entry& entry)
{
    workspace.session.play(entry.make(workspace.next_challenge++));
    workspace.topic = Topic::Challenges;
    workspace.structure = Structure::HalfEdges;
}

// The table in which the wrong pointer stands, with its row.
void bring_forward(Workspace& workspace, const CorruptedPointer& broken)
{
    workspace.structure = Structure::HalfEdges;
    workspace.table = broken.table;
    const topology::EntityTables tables = topology::entity_tables(broken.sound);
    for (const topology::TableRow& row : tables[broken.table])
        if (row.entity && row.entity->index == broken.bent.row) workspace.session.selection = Part{0, *row.entity};
}

// The way to a solid takes the place of what was tried.
void give_up(Workspace& workspace)
{
    Session& session = workspace.session;
    if (std::holds_alternative<ReachChallenge>(session.game()->task()))
        return workspace.leave_document([](Workspace& left) { left.session.give_up_challenge(); });
    session.give_up_challenge();
    if (const auto* const broken = std::get_if<CorruptedPointer>(&session.game()->task()))
        bring_forward(workspace, *broken);
}

Reason why_no_hint(const Workspace& workspace)
{
    if (auto reason = needs_challenge(workspace)) return reason;
    return workspace.session.game()->why_no_hint();
}

} // namespace

std::span<const std::string_view> challenge_command_ids() { return ids; }

void add_challenge_commands(CommandTable& table)
{
    ui::MenuBuilder<Workspace> menu(table, translatable("Challenge"));
    for (const Entry& entry : entries)
        menu.step({entry.id, entry.label}, [&entry](Workspace& workspace) {
            workspace.leave_document([&entry](Workspace& left) { begin(left, entry); });
        });
    menu.step(
        {"challenge.hint", translatable("Give a hint")}, [](Workspace& workspace) { workspace.session.give_hint(); },
        why_no_hint);
    menu.step({"challenge.give_up", translatable("Give up the challenge")}, give_up, needs_challenge);
    table.with_argument("challenge.answer", [](Workspace& workspace, const ui::Argument& argument) {
        return workspace.session.answer(argument.text);
    });
}

} // namespace euler
