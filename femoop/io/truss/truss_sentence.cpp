#include "femoop/io/truss/truss_sentence.h"

#include <algorithm>

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

/// From which point, parallel to which bar: of each bar that is new the side whose point was known.
std::string parallels(const DiagramStep& step, const Reciprocal& diagram, const Model& model, const Translator& tr)
{
    std::vector<std::string> lines;
    for (const MemberId bar : step.bars) {
        const auto& [left, right] = diagram.bar_spaces[bar.index];
        const bool is_left_new = std::ranges::find(step.spaces, left) != step.spaces.end();
        const Space& from = diagram[is_left_new ? right : left];
        lines.push_back(femoop::fill(tr("from {0} parallel to {1}"), {from.point_name(), model[bar].id}));
    }
    return femoop::fill("{0}", {listed(lines)}, conjunction(tr));
}

std::string points_of(const DiagramStep& step, const Reciprocal& diagram, const Translator& tr)
{
    std::vector<std::string> points;
    for (const SpaceId space : step.spaces) points.push_back(diagram[space].point_name());
    return femoop::fill("{0}", {listed(points)}, conjunction(tr));
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
    const std::string& name = model[bar.bar].id;
    const std::string joint = bar.joint ? model[*bar.joint].id : std::string();
    const std::string line = bar.in_line ? model[*bar.in_line].id : std::string();
    switch (bar.rule) {
    case ZeroForceRule::SingleBar:
        return femoop::fill(tr("{0}: the only bar at joint {1}, where no force acts from outside."), {name, joint});
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

std::string sentence(const DiagramStep& step, const Truss& truss, const Reciprocal& diagram, const Model& model,
                     const Translator& tr)
{
    if (!step.joint_step) return forces_sentence(truss, diagram, model, tr);
    const std::string origin = origin_sentence(diagram.joints.steps[*step.joint_step], model, tr);
    const std::string lines = parallels(step, diagram, model, tr);
    if (step.spaces.empty())
        return origin + femoop::fill(tr("{0}: it ends where the diagram is already, and closes it."), {lines});
    if (step.spaces.size() == 1 && step.bars.size() == 2)
        return origin + femoop::fill(tr("{0}: they meet in {1}."), {lines, points_of(step, diagram, tr)});
    return origin + femoop::fill(tr("{0}: this gives {1}."), {lines, points_of(step, diagram, tr)});
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
