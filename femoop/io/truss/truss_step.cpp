#include "femoop/io/truss/truss_step.h"

#include <cmath>

#include "femoop/io/truss/truss_equation.h"
#include "femoop/io/truss/truss_sentence.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/units.h"

namespace femoop::truss {

namespace {

std::string force_unit(const Model& model) { return std::string(name(model.units.force)); }
std::string moment_unit(const Model& model) { return force_unit(model) + "·" + std::string(name(model.units.length)); }
std::string in_unit(const std::string& equation, const std::string& unit) { return equation + "  [" + unit + "]"; }

std::optional<NodeId> joint_at(const Eigen::Vector2d& point, const Truss& truss)
{
    for (std::size_t i = 0; i < truss.joints.size(); ++i)
        if ((truss.joints[i] - point).norm() <= 1e-9 * (1.0 + point.norm())) return NodeId(i);
    return std::nullopt;
}

StepText section_text(const Step& step, const Truss& truss, const Model& model, const Translator& tr)
{
    const CutEquation& found = step.cut->equations.front();
    const std::string unit = found.ritter_point ? moment_unit(model) : force_unit(model);
    return {
        {tr("No joint has fewer than three unknown bars: a section helps.") + " " + cut_sentence(*step.cut, model, tr),
         ritter_sentence(found, truss, model, tr), in_unit(cut_equation(found, model, tr), unit)},
        {force_result(found.bar, found.force, model, tr, Unit::Written)}};
}

StepText joint_text(const Step& step, const Model& model, const Translator& tr)
{
    StepText text{{joint_sentence(step, model, tr)}, {}};
    for (const Along along : {Along::X, Along::Y})
        text.question.push_back(in_unit(joint_equation(step, along, model, tr), force_unit(model)));
    std::string results;
    for (const JointForce& force : step.forces)
        if (force.is_found)
            results += (results.empty() ? "" : ",  ") + force_result(*force.bar, force.value, model, tr, Unit::Written);
    if (!results.empty()) text.answer.push_back(std::move(results));
    return text;
}

} // namespace

StepText step_text(const Step& step, const Truss& truss, const Model& model, const Translator& tr)
{
    if (step.kind == StepKind::Cut) return section_text(step, truss, model, tr);
    if (step.kind != StepKind::Analysis) return joint_text(step, model, tr);
    const MemberId bar = step.found.front();
    return {
        {},
        {fill(tr("Neither a joint nor a section finds a bar of this complex truss: {0} is taken from the analysis."),
              {force_result(bar, truss[bar].force, model, tr, Unit::Written)})}};
}

std::string force_result(MemberId bar, double force, const Model& model, const Translator& tr, Unit unit)
{
    if (force == 0.0) return force_symbol(bar, model) + " = 0";
    const std::string after = unit == Unit::Written ? " " + force_unit(model) : "";
    return force_symbol(bar, model) + " = " + (force < 0.0 ? "−" : "") + six_digits(std::abs(force), tr) + after +
           " (" + sense_name(force, tr) + ")";
}

std::string bars_text(const std::vector<MemberId>& bars, const Model& model, const Translator& tr)
{
    std::vector<std::string> names;
    for (const MemberId bar : bars) names.push_back(model[bar].id);
    return femoop::fill("{0}", {listed(names)}, tr(translatable("and")));
}

std::string joint_sentence(const Step& step, const Model& model, const Translator& tr)
{
    const std::string& joint = model[*step.joint].id;
    if (step.kind == StepKind::Check)
        return femoop::fill(tr("Joint {0}: every bar is known, and both sums have to be 0."), {joint});
    return femoop::fill(step.found.size() == 1 ? tr("Joint {0}: {1} is unknown.") : tr("Joint {0}: {1} are unknown."),
                        {joint, bars_text(step.found, model, tr)});
}

std::string cut_sentence(const RitterCut& cut, const Model& model, const Translator& tr)
{
    std::vector<std::string> joints;
    for (const NodeId joint : cut.part) joints.push_back(model[joint].id);
    if (!cut.known.empty())
        return femoop::fill(tr("The section cuts {0}, and {1}, known already; the part with {2} is in equilibrium."),
                            {bars_text(cut.bars, model, tr), bars_text(cut.known, model, tr), listed(joints)},
                            tr(translatable("and")));
    return femoop::fill(tr("The section cuts {0}; the part with {1} is in equilibrium."),
                        {bars_text(cut.bars, model, tr), listed(joints)}, tr(translatable("and")));
}

std::string ritter_sentence(const CutEquation& found, const Truss& truss, const Model& model, const Translator& tr)
{
    const std::string& bar = model[found.bar].id;
    if (!found.ritter_point)
        return femoop::fill(tr("{0}: the other bars are parallel, and forces across them leave it alone."), {bar});
    const std::string at = place_text({found.ritter_point->data(), 2}, tr);
    const std::string arm = six_digits(std::abs(found.factor), tr);
    if (const auto joint = joint_at(*found.ritter_point, truss))
        return femoop::fill(
            tr("{0}: moments about its Ritter point {1}, joint {2}, through which the other bars go; its lever "
               "arm is {3}."),
            {bar, at, model[*joint].id, arm});
    return femoop::fill(
        tr("{0}: moments about its Ritter point {1}, through which the other bars go; its lever arm is {2}."),
        {bar, at, arm});
}

} // namespace femoop::truss
