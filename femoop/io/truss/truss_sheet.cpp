#include "femoop/io/truss/truss_sheet.h"

#include <algorithm>
#include <cmath>

#include "femoop/geometry/plane_vectors.h"
#include "femoop/io/truss/truss_equation.h"
#include "femoop/io/truss/truss_sentence.h"
#include "femoop/io/truss/truss_step.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/units.h"

namespace femoop::truss {

namespace {

/// Writes the sheets of one truss under one load case.
class SheetWriter {
public:
    SheetWriter(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr)
        : model_(model), truss_(truss), load_case_(load_case), tr_(tr)
    {}

    void begin(const std::string& pattern)
    {
        add(ParagraphKind::Title,
            femoop::fill(pattern, {model_.title.empty() ? tr_("Truss") : model_.title, model_.case_name(load_case_)}));
        sentence(femoop::fill(tr_("Forces in {0}, lengths in {1}. N is positive in tension."),
                              {std::string(name(model_.units.force)), std::string(name(model_.units.length))}));
        if (truss_.has_loaded_bars)
            sentence(
                tr_("Loads on bars are carried to their joints, as by simple beams; along a bar half to each, and N "
                    "is the mean of both ends."));
    }

    void outside_forces()
    {
        heading(tr_("Forces from outside"));
        sentence(
            tr_("The reactions follow from the equilibrium of the whole: the three sums are 0. Moments are about the "
                "origin."));
        tabular::Table table({tr_("Joint"), tr_("Force"), in_force("Fx"), in_force("Fy"), in_moment("M")});
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const ExternalForce& force : truss_.forces) {
            const double moment = cross_product(truss_.joints[force.joint.index], force.force);
            table.add_row({model_[force.joint].id, force.cause == ForceCause::Load ? tr_("load") : tr_("reaction"),
                           number(force.force.x()), number(force.force.y()), number(moment)});
            sum += Eigen::Vector3d(force.force.x(), force.force.y(), moment);
        }
        table.add_row({tr_("sum"), "", number(sum.x()), number(sum.y()), number(sum.z())});
        table.n_sums = 1;
        this->table(std::move(table));
    }

    void zero_forces()
    {
        const auto steps = zero_force_steps(truss_);
        if (steps.empty()) return;
        heading(tr_("Bars that carry nothing"));
        for (const auto& step : steps)
            for (const ZeroForceBar& bar : step) sentence(truss::sentence(bar, model_, tr_));
    }

    void zero_forces_alone()
    {
        zero_forces();
        sentence(zero_force_summary(truss_, model_, tr_));
    }

    void joints(const JointMethod& method)
    {
        heading(tr_("Joint by joint"));
        for (std::size_t i = 0; i < method.steps.size(); ++i) step(i + 1, method.steps[i]);
    }

    void bars(const JointMethod& method)
    {
        heading(tr_("Forces of the bars"));
        tabular::Table table({tr_("Bar"), in_force("N"), ""});
        for (std::size_t i = 0; i < truss_.bars.size(); ++i)
            table.add_row({model_.members[i].id, number(method.forces[i]), sense_name(method.forces[i], tr_)});
        this->table(std::move(table));
    }

    void cut(const RitterCut& cut)
    {
        sentence(cut_sentence(cut, model_, tr_));
        for (const MemberId bar : cut.bars) {
            const auto equation = std::ranges::find(cut.equations, bar, &CutEquation::bar);
            if (equation != cut.equations.end()) cut_bar(*equation);
            else
                sentence(femoop::fill(
                    tr_("{0}: the other bars neither meet in one point nor run parallel; this cut does not give "
                        "it."),
                    {model_[bar].id}));
        }
    }

    void spaces(const Reciprocal& diagram)
    {
        heading(tr_("Spaces, by Bow's notation"));
        for (std::size_t i = 0; i < diagram.forces.size(); ++i)
            sentence(force_sentence(truss_, diagram, i, model_, tr_));
        std::vector<std::string> inside;
        for (const Space& space : diagram.spaces)
            if (space.is_inside) inside.push_back(space.name);
        if (!inside.empty())
            sentence(
                femoop::fill(tr_("Inside the truss lie the spaces {0}."), {listed(inside)}, tr_(translatable("and"))));
    }

    void stages(const Reciprocal& diagram)
    {
        heading(tr_("The diagram, stage by stage"));
        for (std::size_t i = 0; i < diagram.steps.size(); ++i)
            sentence(std::to_string(i + 1) + ". " + truss::sentence(diagram.steps[i], truss_, diagram, model_, tr_));
        sentence(tr_("It is closed: each bar is one side, and about every joint the sides form its force polygon."));
    }

    void sides(const Reciprocal& diagram)
    {
        heading(tr_("Sides of the diagram"));
        tabular::Table table({tr_("Bar"), tr_("Side"), in_force(tr_("Length")), in_force("N"), ""});
        for (std::size_t i = 0; i < truss_.bars.size(); ++i) {
            const MemberId bar(i);
            const auto& [left, right] = diagram.bar_spaces[i];
            const double force = diagram.joints.forces[i];
            table.add_row({model_[bar].id, diagram.side_name(bar),
                           number((diagram[right].point - diagram[left].point).norm()), number(force),
                           sense_name(force, tr_)});
        }
        this->table(std::move(table));
        for (std::size_t i = 0; i < truss_.bars.size(); ++i)
            sentence(reading_sentence(truss_, diagram, MemberId(i), model_, tr_));
    }

    void points(const Reciprocal& diagram)
    {
        heading(tr_("Points of the diagram"));
        tabular::Table table({tr_("Point"), in_force("x"), in_force("y")});
        for (const Space& space : diagram.spaces)
            table.add_row({space.point_name(), number(space.point.x()), number(space.point.y())});
        this->table(std::move(table));
    }

    Sheet take() { return std::move(sheet_); }

private:
    /// Six digits; round-off is 0.
    tabular::Cell number(double value) const
    {
        const double shown = truss_.is_zero(value) ? 0.0 : value;
        return {shown, six_digits(shown, tr_)};
    }
    tabular::Column in_force(const std::string& what) const { return {what, std::string(name(model_.units.force))}; }
    tabular::Column in_moment(const std::string& what) const
    {
        return {what, std::string(name(model_.units.force)) + "·" + std::string(name(model_.units.length))};
    }

    void add(ParagraphKind kind, std::string text)
    {
        sheet_.push_back({.kind = kind, .text = std::move(text), .table = {}});
    }
    void heading(std::string text) { add(ParagraphKind::Heading, std::move(text)); }
    void sentence(std::string text) { add(ParagraphKind::Sentence, std::move(text)); }
    void equation(std::string text) { add(ParagraphKind::Equation, std::move(text)); }
    void table(tabular::Table table)
    {
        sheet_.push_back({.kind = ParagraphKind::Table, .text = {}, .table = std::move(table)});
    }

    void step(std::size_t number, const Step& step)
    {
        const std::string begin = std::to_string(number) + ". ";
        if (step.kind == StepKind::Cut) {
            sentence(begin + tr_("No joint has fewer than three unknown bars: a section helps."));
            sentence(cut_sentence(*step.cut, model_, tr_));
            return cut_bar(step.cut->equations.front());
        }
        if (step.kind == StepKind::Analysis)
            return sentence(
                begin +
                femoop::fill(tr_("Neither a joint nor a section finds a bar of this complex truss: {0} is taken "
                                 "from the analysis."),
                             {result(step.found.front(), truss_[step.found.front()].force)}));
        sentence(begin + joint_sentence(step, model_, tr_));
        equation(joint_equation(step, Along::X, model_, tr_));
        equation(joint_equation(step, Along::Y, model_, tr_));
        for (const JointForce& force : step.forces)
            if (force.is_found) equation(result(*force.bar, force.value));
        polygon(step);
    }

    std::string result(MemberId bar, double force) const { return force_result(bar, force, model_, tr_, Unit::Known); }

    /// Clockwise about the joint: side after side.
    void polygon(const Step& step)
    {
        tabular::Table table({tr_("Force polygon"), in_force(tr_("Length")), in_force("Fx"), in_force("Fy")});
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const JointForce& force : step.forces) {
            const std::string side = force.bar                                               ? model_[*force.bar].id
                                     : truss_.forces[*force.force].cause == ForceCause::Load ? tr_("load")
                                                                                             : tr_("reaction");
            table.add_row(
                {side, number(force.on_joint.norm()), number(force.on_joint.x()), number(force.on_joint.y())});
            sum += force.on_joint;
        }
        table.add_row({tr_("sum"), "", number(sum.x()), number(sum.y())});
        table.n_sums = 1;
        this->table(std::move(table));
    }

    void cut_bar(const CutEquation& found)
    {
        sentence(ritter_sentence(found, truss_, model_, tr_));
        equation(cut_equation(found, model_, tr_));
        equation(result(found.bar, found.force));
    }

    const Model& model_;
    const Truss& truss_;
    CaseId load_case_;
    const Translator& tr_;
    Sheet sheet_;
};

} // namespace

Sheet joint_sheet(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr)
{
    const JointMethod method = joint_method(truss, usual_arrangement(truss));
    SheetWriter writer(model, truss, load_case, tr);
    writer.begin(tr("{0}: joint by joint, {1}"));
    writer.outside_forces();
    writer.zero_forces();
    writer.joints(method);
    writer.bars(method);
    return writer.take();
}

Sheet zero_force_sheet(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr)
{
    SheetWriter writer(model, truss, load_case, tr);
    writer.begin(tr("{0}: zero-force bars, {1}"));
    writer.outside_forces();
    writer.zero_forces_alone();
    return writer.take();
}

Sheet cut_sheet(const Model& model, const Truss& truss, CaseId load_case, const std::vector<MemberId>& bars,
                const Translator& tr)
{
    SheetWriter writer(model, truss, load_case, tr);
    writer.begin(tr("{0}: a section by Ritter, {1}"));
    writer.outside_forces();
    writer.cut(ritter_cut(truss, bars));
    return writer.take();
}

Sheet diagram_sheet(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr)
{
    const Reciprocal diagram = reciprocal(truss);
    SheetWriter writer(model, truss, load_case, tr);
    writer.begin(tr("{0}: Cremona diagram, {1}"));
    writer.spaces(diagram);
    writer.zero_forces();
    writer.stages(diagram);
    writer.points(diagram);
    writer.sides(diagram);
    return writer.take();
}

} // namespace femoop::truss
