#include "apps/euler/session/challenge/challenge_commands.h"

#include <array>
#include <utility>

namespace euler {

using ui::Phrase;
using ui::translatable;

namespace {

constexpr std::string_view menu = translatable("Challenge");

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

std::optional<Phrase> needs_challenge(const Desk& desk)
{
    if (!desk.session.game()) return translatable("no challenge is on");
    if (desk.session.game()->is_over()) return translatable("the challenge is over");
    return std::nullopt;
}

void begin(Desk& desk, const Entry& entry)
{
    desk.session.play(entry.make(desk.next_challenge++));
    desk.topic = Topic::Challenges;
    desk.structure = Structure::HalfEdges;
}

// The way to a solid takes the place of what was tried.
void give_up(Desk& desk)
{
    if (std::holds_alternative<ReachChallenge>(desk.session.game()->task()))
        desk.leave_document([](Desk& left) { left.session.give_up_challenge(); });
    else desk.session.give_up_challenge();
}

} // namespace

std::span<const std::string_view> challenge_command_ids() { return ids; }

void add_challenge_commands(CommandTable& table)
{
    for (const Entry& entry : entries)
        table.add({.id = entry.id, .menu = menu, .label = entry.label, .run = [&entry](Desk& desk) {
                       desk.leave_document([&entry](Desk& left) { begin(left, entry); });
                   }});
    table.add({.id = "challenge.hint",
               .menu = menu,
               .label = translatable("Give a hint"),
               .run = [](Desk& desk) { desk.session.give_hint(); },
               .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                   if (auto reason = needs_challenge(desk)) return reason;
                   return desk.session.game()->why_no_hint();
               }});
    table.add({.id = "challenge.give_up",
               .menu = menu,
               .label = translatable("Give up the challenge"),
               .run = give_up,
               .why_not = needs_challenge});
}

} // namespace euler
