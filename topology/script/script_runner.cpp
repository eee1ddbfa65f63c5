#include "topology/script/script_runner.h"

#include "topology/script/script_fault.h"
#include "topology/script/script_line.h"
#include "topology/text/words.h"

namespace topology {

LineKind ScriptRunner::run_line(std::string_view line, Observer* observer)
{
    const std::vector<std::string_view> found = words(line);
    return found.empty() ? LineKind::Empty : ScriptLine(*this, found, observer).run();
}

void ScriptRunner::add(NamedSolid solid)
{
    places_[solid.name].push_back(solids_.size());
    solids_.push_back(std::move(solid));
}

std::optional<std::size_t> ScriptRunner::find(std::string_view name) const
{
    const auto bearers = places_.find(std::string(name));
    if (bearers == places_.end()) return std::nullopt;
    for (const std::size_t place : bearers->second)
        if (solids_[place].is_alive()) return place;
    return std::nullopt;
}

/// Also the solids that only undone steps had made.
void ScriptRunner::forget_undone()
{
    history_.resize(n_done_);
    while (!solids_.empty() && !solids_.back().is_alive() && solids_.back().journal.n_done() == 0) {
        places_[solids_.back().name].pop_back();
        solids_.pop_back();
    }
}

void ScriptRunner::commit(std::size_t solid, std::size_t n_operators)
{
    history_.resize(n_done_);
    history_.push_back({solid, n_operators});
    ++n_done_;
}

void ScriptRunner::undo(std::size_t n)
{
    if (n > n_done_) throw error(ScriptFault::NothingToUndo, {std::to_string(n_done_), std::to_string(n)});
    for (; n != 0; --n) {
        const Done& step = history_[--n_done_];
        NamedSolid& in = solids_[step.solid];
        EulerOperator op(in.solid, in.journal);
        for (std::size_t i = 0; i < step.n_operators; ++i) op.undo();
    }
}

void ScriptRunner::redo(std::size_t n)
{
    if (n > n_undone()) throw error(ScriptFault::NothingToRedo, {std::to_string(n_undone()), std::to_string(n)});
    for (; n != 0; --n) {
        const Done& step = history_[n_done_++];
        NamedSolid& in = solids_[step.solid];
        EulerOperator op(in.solid, in.journal);
        for (std::size_t i = 0; i < step.n_operators; ++i) op.redo();
    }
}

namespace {

/// As it stands in the text, without blanks around it and without its comment.
std::string_view bare(std::string_view line)
{
    const std::vector<std::string_view> found = words(line);
    if (found.empty()) return {};
    const char* begin = found.front().data();
    return {begin, static_cast<std::size_t>(found.back().data() + found.back().size() - begin)};
}

} // namespace

void run_script(ScriptRunner& runner, std::string_view text, const ScriptOptions& options)
{
    std::size_t n_steps = 0;
    for (Lines lines(text); n_steps < options.most_steps && lines.next();) {
        LineKind kind = LineKind::Empty;
        try {
            kind = runner.run_line(lines.line());
        } catch (const LineError& fault) {
            throw fault.at(lines.number(), bare(lines.line()));
        }
        if (kind == LineKind::Operator) ++n_steps;
        if (kind != LineKind::Empty && options.after) options.after(runner, bare(lines.line()));
    }
}

} // namespace topology
