#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "topology/halfedge/operators/euler_operator.h"
#include "topology/script/corner.h"

namespace topology {

/// A solid that a script works on.
struct NamedSolid {
    std::string name;
    Solid solid;
    Journal journal;
    Names names;

    bool is_alive() const { return !solid.is_empty(); }
    Named named() const { return {solid, names, name}; }
};

/// What a line of a script was.
enum class LineKind { Empty, Operator, UndoOrRedo };

/// Runs Euler-operator scripts, one line after another.
///
///    mvfs s1 f1 v1  0 0 0
///    mev  s1 f1 v1  v2  1 0 0     # courseware/reference/euler-scripts.md explains every operator
///
/// A step is a line that is an operator; `undo` and `redo` take steps back, by the inverse operators, and do them
/// again.
///
/// Lesson   courseware/01-euler-operators.md; every operator: courseware/reference/euler-scripts.md
class ScriptRunner {
public:
    /// Does what the line says; `observer` is told what each of its operators did.
    /// \throws LineError without number; nothing is changed then
    LineKind run_line(std::string_view line, Observer* observer = nullptr);

    /// Takes a solid that was made elsewhere, as the first thing that cannot be undone. \pre its name is free
    void add(NamedSolid solid);

    struct Done {
        std::size_t solid = 0; ///< its place in solids()
        std::size_t n_operators = 0;
    };
    std::size_t n_steps() const { return n_done_; }                           ///< done and not undone
    std::size_t n_undone() const { return history_.size() - n_done_; }        ///< that redo can do again
    const Done& operator[](std::size_t step) const { return history_[step]; } ///< done, then undone ones
    /// In the order in which they were made, dead ones too.
    const std::deque<NamedSolid>& solids() const { return solids_; }

private:
    friend class ScriptLine;
    std::optional<std::size_t> find(std::string_view name) const; ///< the place of the living solid of this name
    void forget_undone();
    void commit(std::size_t solid, std::size_t n_operators);
    void undo(std::size_t n);
    void redo(std::size_t n);

    std::deque<NamedSolid> solids_;
    std::unordered_map<std::string, std::vector<std::size_t>> places_; ///< of all that bore the name, dead ones too
    std::vector<Done> history_;                                        ///< done steps, then undone ones
    std::size_t n_done_ = 0;
};

/// Runs a whole text. `after` is called after every line that did something, with its words as they stand there.
/// \throws LineError with the line's number
struct ScriptOptions {
    std::size_t most_steps = static_cast<std::size_t>(-1); ///< how many operators are run
    std::function<void(const ScriptRunner&, std::string_view line)> after;
};
void run_script(ScriptRunner& runner, std::string_view text, const ScriptOptions& options);

} // namespace topology
