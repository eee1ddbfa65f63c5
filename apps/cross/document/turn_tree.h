#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "femoop/methods/cross/turns.h"

namespace cross {

/// How far one sheet is worked, and every other way in which it was worked before: a tree of turns. Nothing is lost by
/// going back and taking another joint.
///
///     start -- B -- C -- B      place: after "B C B"
///               \-- D           a branch that was left
class TurnTree {
public:
    using Turn = femoop::cross::Turn;

    std::vector<Turn> turns() const; ///< from the start to the present place
    std::size_t length() const;      ///< how many those are
    /// How many turns follow the present place on the way that was taken last.
    std::size_t n_ahead() const;

    void advance(const Turn& turn); ///< goes on by it, on a branch that is there or on a new one
    bool back();                    ///< false at the start
    bool forward();                 ///< by the turn that was taken last here; false where none was
    void restart() { place_ = 0; }
    /// To the place after so many turns of the present way, those ahead included; to the last where there are fewer.
    void jump(std::size_t n_turns);

    /// The ends of all ways, in the order in which they came to be.
    std::vector<std::size_t> branches() const;
    std::vector<Turn> turns_to(std::size_t place) const;
    void go_to(std::size_t place); ///< \pre one of `branches`
    std::size_t place() const { return place_; }

    friend bool operator==(const TurnTree&, const TurnTree&) = default;

private:
    struct Move {
        std::size_t before = 0;
        Turn turn{};
        std::size_t last_after = 0; ///< the move that was made last from here; 0: none
        friend bool operator==(const Move&, const Move&) = default;
    };
    std::vector<Move> moves_{Move{}}; ///< the first is the start
    std::size_t place_ = 0;
};

} // namespace cross
