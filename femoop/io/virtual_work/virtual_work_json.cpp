#include "femoop/io/influence/influence_json.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/io/virtual_work/virtual_work_text.h"

namespace femoop::virtual_work {

namespace {

using Layout = JsonWriter::Layout;

void write_polynomial(JsonWriter& json, std::string_view key, const Polynomial& p)
{
    json.key(key).begin_array();
    for (std::size_t i = 0; i < p.n_terms(); ++i) json.value(p[i]);
    json.end();
}

void write_integrals(JsonWriter& json, const std::vector<WorkIntegral>& integrals, const Model& model)
{
    json.key("members").begin_array(Layout::Block);
    for (const WorkIntegral& one : integrals) {
        json.begin_object().member("member", model[one.member].id);
        json.member("force", one.force ? name(*one.force, model.analysis) : "p");
        json.member("from", one.from).member("to", one.to);
        write_polynomial(json, "real", one.real);
        write_polynomial(json, "unit", one.unit);
        json.member("flexibility", one.flexibility).member("strain", one.strain);
        if (one.stiffness.n_terms() > 1) write_polynomial(json, "stiffness_ratio", one.stiffness);
        if (one.depth.n_terms() > 1) write_polynomial(json, "depth_ratio", one.depth);
        json.member("work", one.value).end();
    }
    json.end();
}

void write_joints(JsonWriter& json, const std::vector<JointWork>& joints, const Model& model)
{
    json.key("joints").begin_array(Layout::Block);
    for (const JointWork& one : joints) {
        json.begin_object().member("member", model[one.member].id);
        json.member("node", model[model[one.member].nodes.at(one.end)].id);
        json.member("force", name(one.force, model.analysis)).member("real", one.real).member("unit", one.unit);
        json.member("stiffness", one.stiffness).member("work", one.value).end();
    }
    json.end();
}

void write_supports(JsonWriter& json, const std::vector<SupportWork>& supports, const Model& model)
{
    json.key("supports").begin_array(Layout::Block);
    for (const SupportWork& one : supports) {
        json.begin_object().member("node", model[one.node].id).member("direction", name(one.dof));
        json.member("displacement", one.displacement).member("reaction", one.reaction);
        json.member("work", one.value).end();
    }
    json.end();
}

} // namespace

std::string virtual_work_json(const VirtualWork& work, const Model& model)
{
    JsonWriter json;
    begin_output(json, model.units);
    json.key("virtual_work").begin_object(Layout::Block);
    influence::write_effect(json, model, work.displacement);
    json.member("case", model.case_name(work.load_case)).member("value", work.value).member("sum", work.sum);
    write_integrals(json, work.work.integrals, model);
    write_joints(json, work.work.joints, model);
    write_supports(json, work.work.supports, model);
    json.end().end();
    return json.take();
}

} // namespace femoop::virtual_work
