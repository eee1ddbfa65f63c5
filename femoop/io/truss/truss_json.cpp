#include "femoop/io/truss/truss_json.h"

#include <array>
#include <string_view>

#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/io/truss/truss_equation.h"
#include "femoop/io/truss/truss_sentence.h"

namespace femoop::truss {

namespace {

using Layout = JsonWriter::Layout;

constexpr std::array<std::string_view, 6> rule_names{"single_bar",      "two_bars",      "third_bar",
                                                     "force_along_bar", "force_in_line", "none"};
constexpr std::array<std::string_view, 4> step_names{"joint", "check", "section", "analysis"};

class TrussJson {
public:
    TrussJson(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr)
        : model_(model), truss_(truss), tr_(tr)
    {
        begin_output(json_, model.units);
        json_.key("truss").begin_object(Layout::Block).member("case", model.case_name(load_case));
        json_.member("loaded_bars", truss.has_loaded_bars);
    }

    void outside_forces()
    {
        json_.key("forces").begin_array(Layout::Block);
        for (const ExternalForce& force : truss_.forces) {
            json_.begin_object().member("joint", model_[force.joint].id).member("cause", cause(force));
            point("force", force.force);
            json_.end();
        }
        json_.end();
    }

    void zero_forces() { write_zero_force_bars(json_.key("zero_force_bars"), truss_, model_, tr_); }

    void joints(const JointMethod& method)
    {
        json_.key("steps").begin_array(Layout::Block);
        for (const Step& step : method.steps) write_step(step);
        json_.end();
        bars(method.forces);
    }

    void bars(const std::vector<double>& forces)
    {
        json_.key("bars").begin_array(Layout::Block);
        for (std::size_t i = 0; i < forces.size(); ++i)
            json_.begin_object().member("bar", model_.members[i].id).member("N", forces[i]).end();
        json_.end();
    }

    void cut(const RitterCut& cut)
    {
        names("cut", cut.bars);
        if (!cut.known.empty()) names("known", cut.known);
        names("part", cut.part);
        json_.key("equations").begin_array(Layout::Block);
        for (const CutEquation& equation : cut.equations) write_equation(equation);
        json_.end();
    }

    void diagram(const Reciprocal& diagram)
    {
        json_.key("spaces").begin_array(Layout::Block);
        for (const Space& space : diagram.spaces) {
            json_.begin_object().member("name", space.name).member("inside", space.is_inside);
            point("point", space.point);
            json_.end();
        }
        json_.end().key("outside").begin_array(Layout::Block);
        for (std::size_t i = 0; i < diagram.forces.size(); ++i) {
            const ExternalForce& force = truss_.forces[diagram.forces[i]];
            const auto spaces = diagram.force_spaces(i);
            json_.begin_object().member("joint", model_[force.joint].id).member("cause", cause(force));
            json_.member("before", diagram[spaces[0]].name).member("after", diagram[spaces[1]].name).end();
        }
        json_.end().key("sides").begin_array(Layout::Block);
        for (std::size_t i = 0; i < truss_.bars.size(); ++i) {
            const auto& [left, right] = diagram.bar_spaces[i];
            json_.begin_object().member("bar", model_.members[i].id).member("left", diagram[left].name);
            json_.member("right", diagram[right].name).member("N", diagram.joints.forces[i]).end();
        }
        json_.end().key("stages").begin_array(Layout::Block);
        for (const DiagramStep& step : diagram.steps) json_.value(sentence(step, truss_, diagram, model_, tr_));
        json_.end().member("closing_error", diagram.closing_error);
    }

    std::string take()
    {
        json_.end().end();
        return json_.take();
    }

private:
    static std::string_view cause(const ExternalForce& force)
    {
        return force.cause == ForceCause::Load ? "load" : "reaction";
    }

    void point(std::string_view key, const Eigen::Vector2d& at)
    {
        json_.key(key).begin_array().value(at.x()).value(at.y()).end();
    }

    template <class Ids> void names(std::string_view key, const Ids& ids)
    {
        json_.key(key).begin_array();
        for (const auto id : ids) json_.value(model_[id].id);
        json_.end();
    }

    void write_step(const Step& step)
    {
        json_.begin_object(Layout::Block).member("step", step_names.at(static_cast<std::size_t>(step.kind)));
        if (step.joint) json_.member("joint", model_[*step.joint].id);
        names("found", step.found);
        if (step.cut) cut(*step.cut);
        if (!step.forces.empty()) polygon(step);
        json_.end();
    }

    void polygon(const Step& step)
    {
        json_.key("polygon").begin_array(Layout::Block);
        for (const JointForce& side : step.forces) {
            json_.begin_object();
            if (side.bar) json_.member("bar", model_[*side.bar].id).member("N", side.value);
            else json_.member("cause", cause(truss_.forces[*side.force]));
            point("on_joint", side.on_joint);
            json_.end();
        }
        json_.end();
        json_.member("x", joint_equation(step, Along::X, model_, tr_));
        json_.member("y", joint_equation(step, Along::Y, model_, tr_));
        json_.member("closing_error", step.closing_error);
    }

    void write_equation(const CutEquation& equation)
    {
        json_.begin_object().member("bar", model_[equation.bar].id);
        if (equation.ritter_point) point("ritter_point", *equation.ritter_point);
        else point("across", equation.across);
        json_.member("factor", equation.factor).member("equation", cut_equation(equation, model_, tr_));
        json_.member("N", equation.force).end();
    }

    const Model& model_;
    const Truss& truss_;
    const Translator& tr_;
    JsonWriter json_;
};

} // namespace

std::string joint_json(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr)
{
    TrussJson json(model, truss, load_case, tr);
    json.outside_forces();
    json.zero_forces();
    json.joints(joint_method(truss, usual_arrangement(truss)));
    return json.take();
}

std::string zero_force_json(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr)
{
    TrussJson json(model, truss, load_case, tr);
    json.outside_forces();
    json.zero_forces();
    return json.take();
}

void write_zero_force_bars(JsonWriter& json, const Truss& truss, const Model& model, const Translator& tr)
{
    json.begin_array(Layout::Block);
    for (const ZeroForceBar& bar : zero_force_bars(truss)) {
        json.begin_object().member("bar", model[bar.bar].id);
        json.member("rule", rule_names.at(static_cast<std::size_t>(bar.rule)));
        if (bar.joint) json.member("joint", model[*bar.joint].id);
        if (bar.in_line) json.member("in_line", model[*bar.in_line].id);
        json.key("without").begin_array();
        for (const MemberId one : bar.without) json.value(model[one].id);
        json.end().member("sentence", sentence(bar, model, tr)).end();
    }
    json.end();
}

std::string cut_json(const Model& model, const Truss& truss, CaseId load_case, const std::vector<MemberId>& bars,
                     const Translator& tr)
{
    TrussJson json(model, truss, load_case, tr);
    json.outside_forces();
    json.cut(ritter_cut(truss, bars));
    return json.take();
}

std::string diagram_json(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr)
{
    TrussJson json(model, truss, load_case, tr);
    json.outside_forces();
    json.zero_forces();
    json.diagram(reciprocal(truss));
    return json.take();
}

} // namespace femoop::truss
