#include "femoop/io/truss/truss_sentence.h"

#include <algorithm>

#include "femoop/io/truss/truss_step.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/units.h"

namespace femoop::truss {

namespace {

std::string conjunction(const Translator& tr) { return tr(translatable("and")); }

template <class Ids> std::string list_of(const Ids& ids, const Model& model)
{
    std::vector<std::string> names;
    for (const auto id : ids) names.push_back(model[id].id);
    return listed(names);
}

std::string force_text(double force, const Model& model, const Translator& tr)
{
    return six_digits(force, tr) + " " + std::string(name(model.units.force));
}

std::string forces_sentence(const Truss& truss, const Reciprocal& diagram, const Model& model, const Translator& tr)
{
    std::string text = tr("The forces from outside, clockwise around the truss, one after the other: ");
    for (std::size_t i = 0; i < diagram.forces.size(); ++i)
        text += (i == 0 ? "" : "; ") + force_sentence(truss, diagram, i, model, tr);
    return text + ". " + tr("The polygon closes.");
}

std::string origin_sentence(const Step& step, const Model& model, const Translator& tr)
{
    if (step.kind == StepKind::Cut)
        return femoop::fill(tr("No joint has fewer than three unknown bars; a section through {0} finds {1}: "),
                            {list_of(step.cut->bars, model), model[step.found.front()].id}, conjunction(tr));
    if (step.kind == StepKind::Analysis)
        return femoop::fill(
            tr("Neither a joint nor a section finds a bar of this complex truss; {0} is taken from the analysis: "),
            {model[step.found.front()].id});
    return femoop::fill(tr("Joint {0}: "), {model[*step.joint].id});
}

/// "d-a, a-1 (AD), 1-d (AC)".
std::string sides_text(const Step& step, const Truss& truss, const Reciprocal& diagram, const Model& model)
{
    std::string text;
    for (const PolygonSide& side : diagram.polygon(truss, step)) {
        text += (text.empty() ? "" : ", ") + diagram[side.from].point_name() + "-" + diagram[side.to].point_name();
        if (side.bar) text += " (" + model[*side.bar].id + ")";
    }
    return text;
}

/// The polygon of the joint, which closes.
std::string closing_sentence(const Step& step, const Truss& truss, const Reciprocal& diagram, const Model& model,
                             const Translator& tr)
{
    return femoop::fill(tr("Clockwise about {0}: {1} close."),
                        {model[*step.joint].id, sides_text(step, truss, diagram, model)});
}

/// What the polygon says of the bars that the step finds; empty where it only checks.
std::string results_text(const Step& step, const Reciprocal& diagram, const Model& model, const Translator& tr)
{
    std::string text;
    for (const MemberId bar : step.found)
        text += (text.empty() ? "" : ",  ") +
                force_result(bar, diagram.joints.forces[bar.index], model, tr, Unit::Written);
    return text;
}

/// Where the line of a bar begins and ends.
std::string line_sentence(const DiagramStep& step, const Reciprocal& diagram, const Model& model, const Translator& tr)
{
    const MemberId bar = *step.bar;
    const auto& [left, right] = diagram.bar_spaces[bar.index];
    const std::string from = diagram[*step.from].point_name(), parallel_to = model[bar].id;
    const std::string to = diagram[*step.from == left && left != right ? right : left].point_name();
    if (step.is_open)
        return femoop::fill(tr("from {0} parallel to {1}; how far it goes, the next line shows."), {from, parallel_to});
    if (step.cuts)
        return femoop::fill(tr("from {0} parallel to {1}: it meets the line parallel to {2} in {3}."),
                            {from, parallel_to, model[*step.cuts].id, to});
    if (!step.spaces.empty())
        return femoop::fill(tr("from {0} parallel to {1}, as long as its force: this gives {2}."),
                            {from, parallel_to, to});
    return femoop::fill(tr("from {0} parallel to {1}: it ends in {2}, which stands already."), {from, parallel_to, to});
}

std::string rule_sentence(const ZeroForceBar& bar, const Model& model, const Translator& tr)
{
    const std::string& name = model[bar.bar].id;
    const std::string joint = bar.joint ? model[*bar.joint].id : std::string();
    const std::string line = bar.in_line ? model[*bar.in_line].id : std::string();
    switch (bar.rule) {
    case ZeroForceRule::SingleBar:
        return femoop::fill(bar.without.empty()
                                ? tr("{0}: the only bar at joint {1}, where no force acts from outside.")
                                : tr("{0}: the only bar left at joint {1}, where no force acts from outside."),
                            {name, joint});
    case ZeroForceRule::TwoBars:
        return femoop::fill(
            tr("{0}: two bars that are not in line meet at joint {1}, where no force acts from outside: "
               "neither carries anything."),
            {name, joint});
    case ZeroForceRule::ThirdBar:
        return femoop::fill(
            tr("{0}: at joint {1}, where no force acts from outside, it stands alone beside two bars in line, one of them {2}."),
            {name, joint, line});
    case ZeroForceRule::ForceAlongBar:
        return femoop::fill(
            tr("{0}: of the two bars at joint {1} the other, {2}, lies along the force there and carries it alone."),
            {name, joint, line});
    case ZeroForceRule::ForceInLine:
        return femoop::fill(
            tr("{0}: at joint {1} the force acts along two bars in line, one of them {2}; nothing is left for the "
               "third."),
            {name, joint, line});
    case ZeroForceRule::NoRule: break;
    }
    return femoop::fill(tr("{0}: no rule shows it; under these loads alone it carries nothing."), {name});
}

/// "AD counts no longer", where bars of the joint were found before.
std::string without_sentence(const ZeroForceBar& bar, const Model& model, const Translator& tr)
{
    if (bar.without.empty()) return {};
    const std::string pattern = bar.without.size() == 1 ? tr("{0}, found before, counts no longer.")
                                                        : tr("{0}, found before, count no longer.");
    return " " + femoop::fill(pattern, {bars_text(bar.without, model, tr)});
}

} // namespace

std::string sentence(const Refusal& refusal, const Model& model, const Translator& tr)
{
    const std::string bars = list_of(refusal.bars, model), joints = list_of(refusal.joints, model);
    const auto say = [&](const std::string& pattern, const std::vector<std::string>& arguments) {
        return femoop::fill(pattern, arguments, conjunction(tr));
    };
    const auto first_bar = [&] { return model[refusal.bars.front()].id; };
    switch (refusal.kind) {
    case RefusalKind::NotPlaneTruss:
        return say(tr("joints, sections and the Cremona diagram are for plane trusses, and this is a {0}; "
                      "make the model a truss2d"),
                   {std::string(name(model.analysis))});
    case RefusalKind::NoCase: return tr("the model has no load case, so no force to find; add one to load_cases");
    case RefusalKind::Indeterminate:
        return say(
            tr("the truss is statically indeterminate to degree {0}, so that equilibrium alone does not give its forces; take bars or supports away, or solve it"),
            {std::to_string(refusal.degree)});
    case RefusalKind::NoForce: return tr("nothing acts on the truss, so there is no diagram; add a load");
    case RefusalKind::BarsCross:
        return say(tr("bars {0} and {1} cross at {2} without a joint: the truss is not planar, and its spaces have no "
                      "diagram; join them there, or go joint by joint"),
                   {first_bar(), model[refusal.bars.back()].id, place_text({refusal.at->data(), 2}, tr)});
    case RefusalKind::BarPassesJoint:
        return say(tr("bar {0} runs over joint {1} without being joined there: the truss is not planar, and its spaces "
                      "have no diagram; split it at the joint, or go joint by joint"),
                   {first_bar(), joints});
    case RefusalKind::FallsApart:
        return say(tr("no bar joins {0} to the rest of the truss, so there is no one diagram; take each part alone"),
                   {joints});
    case RefusalKind::ForceInside:
        return say(tr("forces act at {0} within the outline of the truss, where no space outside lies beside them; "
                      "let them act at joints of the outline, or go joint by joint"),
                   {joints});
    case RefusalKind::CutTooSmall: return tr("a section cuts two bars at least; name more");
    case RefusalKind::CutNotThrough:
        return say(
            tr("without {0} the truss still hangs together; name all bars that a section cuts from side to side"),
            {bars});
    case RefusalKind::CutAtOneSide: return say(tr("{0} joins two joints on one side of the cut; leave it out"), {bars});
    case RefusalKind::CutConcurrent: break;
    }
    return say(tr("of {0} none can be found alone: of no bar do all the others meet in one point or run parallel; "
                  "cut other bars"),
               {bars});
}

std::string sentence(const ZeroForceBar& bar, const Model& model, const Translator& tr)
{
    return rule_sentence(bar, model, tr) + without_sentence(bar, model, tr);
}

std::string zero_force_summary(const Truss& truss, const Model& model, const Translator& tr)
{
    std::vector<MemberId> bars;
    for (const ZeroForceBar& bar : zero_force_bars(truss)) bars.push_back(bar.bar);
    if (bars.empty()) return tr("Every bar carries a force.");
    return femoop::fill(bars.size() == 1 ? tr("{0} carries nothing: {1} of {2} bars.")
                                         : tr("{0} carry nothing: {1} of {2} bars."),
                        {bars_text(bars, model, tr), std::to_string(bars.size()), std::to_string(truss.bars.size())});
}

std::string sense_name(double force, const Translator& tr)
{
    if (force == 0.0) return tr("zero");
    return force > 0.0 ? tr("tension") : tr("compression");
}

std::string force_sentence(const Truss& truss, const Reciprocal& diagram, std::size_t i, const Model& model,
                           const Translator& tr)
{
    const ExternalForce& force = truss.forces[diagram.forces[i]];
    const auto [before, after] = diagram.force_spaces(i);
    const std::string pattern = force.cause == ForceCause::Load ? tr("{0} = {1}, load at {2}")
                                                                : tr("{0} = {1}, reaction at {2}");
    return femoop::fill(pattern, {diagram[before].point_name() + "-" + diagram[after].point_name(),
                                  force_text(force.force.norm(), model, tr), model[force.joint].id});
}

std::vector<std::string> stage_lines(const DiagramStep& step, const Truss& truss, const Reciprocal& diagram,
                                     const Model& model, const Translator& tr)
{
    if (!step.joint_step) return {forces_sentence(truss, diagram, model, tr)};
    const Step& found = diagram.joints.steps[*step.joint_step];
    const std::string drawn = step.bar ? line_sentence(step, diagram, model, tr) : tr("all its sides stand already.");
    std::vector<std::string> lines{origin_sentence(found, model, tr) + drawn};
    if (!step.closes) return lines;
    lines.push_back(closing_sentence(found, truss, diagram, model, tr));
    if (!found.found.empty()) lines.push_back(results_text(found, diagram, model, tr));
    return lines;
}

std::string sentence(const DiagramStep& step, const Truss& truss, const Reciprocal& diagram, const Model& model,
                     const Translator& tr)
{
    std::string text;
    for (const std::string& line : stage_lines(step, truss, diagram, model, tr))
        text += (text.empty() ? "" : " ") + line;
    return text;
}

std::string reading_sentence(const Truss& truss, const Reciprocal& diagram, MemberId bar, const Model& model,
                             const Translator& tr)
{
    const NodeId joint = truss[bar].joints[0];
    const auto& [left, right] = diagram.bar_spaces[bar.index];
    const double force = diagram.joints.forces[bar.index];
    const std::vector<std::string> arguments{model[joint].id, model[bar].id, diagram[left].point_name(),
                                             diagram[right].point_name(), force_text(std::abs(force), model, tr)};
    if (force == 0.0) return femoop::fill(tr("{1} carries nothing: {2} and {3} are one point."), arguments);
    return femoop::fill(force > 0.0
                            ? tr("Clockwise about joint {0}, {1} is {2}-{3} = {4}, away from the joint: tension.")
                            : tr("Clockwise about joint {0}, {1} is {2}-{3} = {4}, towards the joint: compression."),
                        arguments);
}

} // namespace femoop::truss
