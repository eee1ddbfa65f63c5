#include "apps/cross/window/cell_names.h"

#include <algorithm>
#include <array>

#include "ui/text/number_format.h"

namespace cross {

namespace fc = femoop::cross;
using fc::Asked;

namespace {

constexpr std::array<std::pair<std::string_view, Asked>, 9> kinds{{{"stiffness", Asked::Stiffness},
                                                                   {"factor", Asked::Factor},
                                                                   {"fixed-end", Asked::FixedEnd},
                                                                   {"balance", Asked::Balance},
                                                                   {"carry-over", Asked::CarryOver},
                                                                   {"sum", Asked::Sum},
                                                                   {"holding", Asked::Holding},
                                                                   {"multiplier", Asked::Multiplier},
                                                                   {"final", Asked::Final}}};

std::optional<std::size_t> whole(const std::vector<std::string>& words, std::size_t at)
{
    const auto number = at < words.size() ? ui::number_typed(words[at]) : std::nullopt;
    if (!number || *number < 0.0 || *number > 1e6) return std::nullopt;
    return static_cast<std::size_t>(*number);
}

} // namespace

std::optional<NamedCell> cell_named(const Session& session, const std::vector<std::string>& words)
{
    if (session.worksheet() == nullptr || words.size() < 2) return std::nullopt;
    const auto* const kind = std::ranges::find(kinds, words[1], &std::pair<std::string_view, Asked>::first);
    if (kind == kinds.end()) return std::nullopt;
    const fc::Form& form = session.worksheet()->form;
    const Asked asked = kind->second;
    const auto named = [](std::optional<fc::BlankId> cell, std::size_t n) {
        return cell ? std::optional(NamedCell{*cell, n}) : std::nullopt;
    };
    if (asked == Asked::Multiplier) return named(form.find(asked, 0, 0, 0), 2);
    if (asked == Asked::Holding) return named(form.find(asked, whole(words, 2).value_or(0), 0, 0), 3);
    const bool has_turn = asked == Asked::Balance || asked == Asked::CarryOver;
    const std::size_t turn = has_turn ? whole(words, 2).value_or(0) : 1, name = has_turn ? 3 : 2;
    const auto end = name < words.size() ? form.problem.find_end(words[name]) : std::nullopt;
    if (!end || turn < 1) return std::nullopt;
    const bool is_once = asked == Asked::Stiffness || asked == Asked::Factor || asked == Asked::Final;
    return named(form.find(asked, is_once ? 0 : session.worksheet_stage(), turn - 1, end->index), name + 1);
}

} // namespace cross
