#include "apps/cross/document/turn_tree.h"

#include <algorithm>

namespace cross {

std::vector<TurnTree::Turn> TurnTree::turns_to(std::size_t place) const
{
    std::vector<Turn> turns;
    for (std::size_t at = place; at != 0; at = moves_[at].before) turns.push_back(moves_[at].turn);
    std::ranges::reverse(turns);
    return turns;
}

std::vector<TurnTree::Turn> TurnTree::turns() const { return turns_to(place_); }

std::size_t TurnTree::length() const
{
    std::size_t n = 0;
    for (std::size_t at = place_; at != 0; at = moves_[at].before) ++n;
    return n;
}

std::size_t TurnTree::n_ahead() const
{
    std::size_t n = 0;
    for (std::size_t at = moves_[place_].last_after; at != 0; at = moves_[at].last_after) ++n;
    return n;
}

void TurnTree::advance(const Turn& turn)
{
    const auto is_it = [&](const Move& move) { return move.before == place_ && move.turn == turn; };
    auto found = std::find_if(moves_.begin() + 1, moves_.end(), is_it);
    if (found == moves_.end()) found = moves_.insert(moves_.end(), Move{.before = place_, .turn = turn});
    const auto next = static_cast<std::size_t>(found - moves_.begin());
    moves_[place_].last_after = next;
    place_ = next;
}

bool TurnTree::back()
{
    if (place_ == 0) return false;
    place_ = moves_[place_].before;
    return true;
}

bool TurnTree::forward()
{
    if (moves_[place_].last_after == 0) return false;
    place_ = moves_[place_].last_after;
    return true;
}

void TurnTree::jump(std::size_t n_turns)
{
    while (length() > n_turns) back();
    for (std::size_t n = length(); n < n_turns && forward(); ++n) continue;
}

std::vector<std::size_t> TurnTree::branches() const
{
    std::vector<bool> is_end(moves_.size(), true);
    for (std::size_t i = 1; i < moves_.size(); ++i) is_end[moves_[i].before] = false;
    std::vector<std::size_t> ends;
    for (std::size_t i = 1; i < moves_.size(); ++i)
        if (is_end[i]) ends.push_back(i);
    return ends;
}

void TurnTree::go_to(std::size_t place)
{
    place_ = place;
    for (std::size_t at = place; at != 0; at = moves_[at].before) moves_[moves_[at].before].last_after = at;
}

} // namespace cross
