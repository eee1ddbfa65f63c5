#include "apps/euler/document/stepper.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "apps/euler/document/comment.h"
#include "apps/euler/document/meaning.h"
#include "topology/script/inverse.h"
#include "topology/text/line_error.h"
#include "topology/text/words.h"

namespace euler {

namespace {

using topology::Change;
using topology::EulerCounts;
using topology::LineKind;
using topology::OperatorKind;

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

bool is_sweep(std::string_view line) { return topology::words(line).front() == "sweep"; }

std::string operator_name(std::string_view line, OperatorKind kind)
{
    return is_sweep(line) ? "SWEEP" : std::string(name(kind)); // "split" is a MEV
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
EulerCounts counts_after(const topology::Solid& solid, const EulerCounts& before, OperatorKind kind)
{
    if (kind == OperatorKind::KFMRH || kind == OperatorKind::MFKRH) return topology::euler_counts(solid);
    const topology::Counts n = solid.counts();
    EulerCounts after{.V = n.vertices, .E = n.edges, .F = n.faces, .L = n.loops, .S = before.S, .G = before.G};
    if (kind == OperatorKind::MVFS) ++after.S;
    if (kind == OperatorKind::KVFS) --after.S;
    return after;
}

} // namespace

ui::Phrase reason(const topology::LineError& error)
{
    ui::Phrase phrase(error.pattern());
    for (std::size_t i = 0; i < error.words().size(); ++i)
        phrase.arguments.emplace_back(std::to_string(i), error.words()[i]);
    return phrase;
}

Stepper::Stepper(std::string_view script)
{
    for (topology::Lines lines(script); lines.next();) {
        try {
            if (run(lines.line()) == LineKind::Empty) above_ += std::string(lines.line()) + "\n";
        } catch (const topology::LineError& fault) {
            throw fault.at(lines.number(), lines.line());
        }
    }
    heading_ = std::string_view(first_comment(script));
}

/// A step takes the place of those that were undone.
LineKind Stepper::run(std::string_view line)
{
    Recorder recorder;
    const LineKind kind = runner_.run_line(line, &recorder);
    if (kind != LineKind::Operator) return kind;
    steps_.resize(place() - 1);
    StepReport report = described(line, std::move(recorder.changes));
    report.explanation = std::string_view(comment(above_, line));
    steps_.push_back(std::make_shared<const TextStep>(TextStep{std::exchange(above_, ""), std::move(report)}));
    return kind;
}

StepReport Stepper::described(std::string_view line, std::vector<Change> changes) const
{
    const topology::ScriptRunner::Done& done = runner_[place() - 1];
    const topology::NamedSolid& in = runner_.solids()[done.solid];
    StepReport report{.line = std::string(line), .solid = done.solid};
    report.name = operator_name(line, changes.front().kind);
    report.before = counts_before(done.solid);
    report.after = counts_after(in.solid, report.before, changes.front().kind);
    report.meaning = meaning(line, report.before, report.after);
    report.inverse = inverse_lines(in, done.n_operators);
    report.inverse_name = names_of(report.inverse);
    report.changes = std::move(changes);
    return report;
}

EulerCounts Stepper::counts_before(std::size_t solid) const
{
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step)
        if ((*step)->report.solid == solid) return (*step)->report.after;
    return {};
}

void Stepper::go_to(std::size_t place)
{
    const std::size_t now = this->place();
    if (place < now) runner_.run_line("undo " + std::to_string(now - place));
    if (place > now) runner_.run_line("redo " + std::to_string(place - now));
}

std::optional<ui::Phrase> Stepper::apply(std::string_view line)
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

std::string Stepper::script() const
{
    std::string text;
    for (const auto& step : steps_) text += step->above + step->report.line + "\n";
    return text + above_;
}

} // namespace euler
