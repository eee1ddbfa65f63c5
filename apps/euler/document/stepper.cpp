#include "apps/euler/document/stepper.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include "apps/euler/document/comment.h"
#include "apps/euler/document/meaning.h"
#include "topology/embedding/ring_plane.h"
#include "topology/script/inverse.h"
#include "topology/script/script_writer.h"
#include "topology/text/line_error.h"
#include "topology/text/words.h"
#include "ui/text/catalogue.h"

namespace euler {

namespace {

using topology::Change;
using topology::EulerCounts;
using topology::LineKind;
using topology::OperatorKind;
using ui::translatable;

class Recorder : public topology::Observer {
public:
    void changed(const Change& change) override { changes.push_back(change); }
    std::vector<Change> changes;
};

std::string upper(std::string_view word)
{
    std::string text(word);
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

bool sweeps(std::string_view line) { return topology::words(line).front() == "sweep"; }

std::string operator_name(std::string_view line, OperatorKind kind)
{
    return sweeps(line) ? "SWEEP" : std::string(name(kind)); // "split" is a MEV
}

/// The names of the operators that the lines begin with, each once.
std::string names_of(const std::vector<std::string>& lines)
{
    std::vector<std::string> names;
    for (const std::string& line : lines) {
        const std::string word = upper(line.substr(0, line.find(' ')));
        const std::string name = word == "SPLIT" ? "MEV" : word;
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// Shells and genus are counted again only after an operator that may join or part what others leave connected.
EulerCounts counted_after(const topology::Solid& solid, const EulerCounts& before, OperatorKind kind)
{
    if (kind == OperatorKind::KFMRH || kind == OperatorKind::MFKRH) return topology::euler_counts(solid);
    const topology::Counts n = solid.counts();
    EulerCounts after{.V = n.vertices, .E = n.edges, .F = n.faces, .L = n.loops, .S = before.S, .G = before.G};
    if (kind == OperatorKind::MVFS) ++after.S;
    if (kind == OperatorKind::KVFS) --after.S;
    return after;
}

} // namespace

ui::Message reason(const topology::LineError& error)
{
    ui::Message message(error.pattern());
    for (std::size_t i = 0; i < error.words().size(); ++i)
        message.arguments.emplace_back(std::to_string(i), error.words()[i]);
    return message;
}

Stepper::Stepper(std::string_view script)
{
    if (const auto fault = run_all(script)) throw topology::LineError(*fault);
}

Stepper::Begun Stepper::as_far_as_it_goes(std::string_view script)
{
    Begun begun;
    begun.fault = begun.lesson.run_all(script);
    return begun;
}

std::optional<topology::LineError> Stepper::run_all(std::string_view script)
{
    heading_ = std::string_view(first_comment(script));
    for (topology::Lines lines(script); lines.next();) {
        try {
            if (run(lines.line()) == LineKind::Empty) above_ += std::string(lines.line()) + "\n";
        } catch (const topology::LineError& fault) {
            return fault.at(lines.number(), lines.line());
        }
    }
    return std::nullopt;
}

/// A step takes the place of those that were undone.
LineKind Stepper::run(std::string_view line)
{
    const LineKind kind = runner_.run_line(line);
    if (kind != LineKind::Operator) return kind;
    forget_undone();
    steps_.push_back(entry(line));
    steps_of_[steps_.back()->solid].push_back(steps_.size());
    return kind;
}

void Stepper::forget_undone()
{
    for (; steps_.size() >= place(); steps_.pop_back()) steps_of_[steps_.back()->solid].pop_back();
    steps_of_.resize(runner_.solids().size());
}

/// Of the line that was just run.
std::shared_ptr<const Stepper::Entry> Stepper::entry(std::string_view line)
{
    const topology::ScriptRunner::Done& done = runner_[place() - 1];
    const topology::NamedSolid& in = runner_.solids()[done.solid];
    const std::vector<std::size_t>& before = steps_of_[done.solid];
    Entry made{.line_at = above_.size(), .solid = done.solid, .previous = before.empty() ? 0 : before.back()};
    made.text = std::exchange(above_, "").append(line);
    made.text.shrink_to_fit();
    made.kind = in.journal[in.journal.n_done() - done.n_operators].kind;
    made.after = counted_after(in.solid, counts_after(made.previous), made.kind);
    return std::make_shared<const Entry>(std::move(made));
}

EulerCounts Stepper::counts_after(std::size_t step) const
{
    return step == 0 ? EulerCounts{} : steps_[step - 1]->after;
}

EulerCounts Stepper::counts(std::size_t solid) const
{
    const std::vector<std::size_t>& steps = steps_of_[solid];
    const auto beyond = std::ranges::upper_bound(steps, place());
    return beyond == steps.begin() ? EulerCounts{} : counts_after(*std::prev(beyond));
}

StepSummary Stepper::summary(std::size_t i) const
{
    const Entry& step = *steps_[i - 1];
    return {.line = std::string(step.line()),
            .name = operator_name(step.line(), step.kind),
            .solid = step.solid,
            .before = counts_after(step.previous),
            .after = step.after};
}

StepReport Stepper::report(std::size_t i) const
{
    if (i != place()) {
        Stepper there = *this;
        there.go_to(i);
        return there.report(i);
    }
    StepReport report{summary(i)};
    report.changes = changes();
    report.inverse = inverse_lines(runner_.solids()[report.solid], n_operators(i));
    report.inverse_name = names_of(report.inverse);
    report.warning = warning(report.changes, report.solid);
    report.meaning = meaning(report.line, report.before, report.after);
    report.explanation = std::string_view(comment(steps_[i - 1]->above(), report.line));
    return report;
}

// The last operator's ring is told; those of a sweep make none.
ui::Message Stepper::warning(const std::vector<Change>& changes, std::size_t solid) const
{
    const topology::NamedSolid& in = runner_.solids()[solid];
    const auto found = off_plane(in.solid, changes.back());
    if (!found) return ui::Message("");
    return {
        translatable(
            "{vertex} lies outside the plane of face {face}: the links are right, but no flat face has such a ring."),
        {{"vertex", in.names.vertices.of(found->vertex)}, {"face", in.names.faces.of(found->face)}}};
}

/// One operator is read off the tables that it left; of several each was followed by others, so they are done again.
std::vector<Change> Stepper::changes() const
{
    const topology::ScriptRunner::Done& done = runner_[place() - 1];
    const topology::NamedSolid& in = runner_.solids()[done.solid];
    if (done.n_operators == 1) return {change(in.solid.tables(), in.journal[in.journal.n_done() - 1])};
    topology::NamedSolid again{.name = in.name, .solid = in.solid, .journal = in.journal, .names = {}};
    topology::EulerOperator op(again.solid, again.journal);
    for (std::size_t n = 0; n < done.n_operators; ++n) op.undo();
    Recorder recorder;
    op.observe(recorder);
    for (std::size_t n = 0; n < done.n_operators; ++n) op.redo();
    return std::move(recorder.changes);
}

void Stepper::go_to(std::size_t place)
{
    const std::size_t now = this->place();
    if (place < now) runner_.run_line("undo " + std::to_string(now - place));
    if (place > now) runner_.run_line("redo " + std::to_string(place - now));
}

std::optional<ui::Message> Stepper::apply(std::string_view line)
{
    const std::string after = std::exchange(above_, "");
    const bool is_at_end = place() == n_steps();
    try {
        const bool is_step = run(line) == LineKind::Operator;
        if (!is_step || is_at_end) above_ = after;
    } catch (const topology::LineError& fault) {
        above_ = after;
        return reason(fault);
    }
    return std::nullopt;
}

bool Stepper::is_sweep(std::size_t i) const { return sweeps(steps_[i - 1]->line()); }

// The line stays as a comment that tells what its operators are.
void Stepper::open_sweep()
{
    const std::size_t place = this->place();
    const std::string lines = journal_script(runner_.solids()[steps_[place - 1]->solid], n_operators(place));
    std::string text;
    for (std::size_t i = 1; i <= n_steps(); ++i) {
        const Entry& step = *steps_[i - 1];
        if (i == place) text.append(step.above()).append("#     ").append(step.line()).append("\n").append(lines);
        else text.append(step.text) += '\n';
    }
    ui::Message heading = heading_;
    *this = Stepper(text + above_);
    heading_ = std::move(heading);
    go_to(place - 1);
}

std::size_t Stepper::next_line() const
{
    std::size_t next = 1;
    for (std::size_t i = 0; i < place(); ++i)
        next += 1 + static_cast<std::size_t>(std::ranges::count(steps_[i]->text, '\n'));
    return next;
}

std::string Stepper::script() const { return whole().text(); }

Stepper::Script Stepper::whole() const
{
    Script script;
    script.steps_ = steps_;
    script.after_ = above_;
    return script;
}

std::string Stepper::Script::text() const
{
    std::string text;
    for (const auto& step : steps_) text.append(step->text) += '\n';
    return text + after_;
}

bool Stepper::Script::operator==(const Script& other) const
{
    const auto is_same = [](const auto& a, const auto& b) { return a == b || a->text == b->text; };
    return after_ == other.after_ && std::ranges::equal(steps_, other.steps_, is_same);
}

} // namespace euler
