#include <array>
#include <string_view>

#include "femoop/io/free_body/free_body_text.h"
#include "femoop/methods/free_body/ritter.h"
#include "femoop/result/components.h"

namespace femoop::free_body {

namespace {

using Layout = JsonWriter::Layout;

constexpr std::array<std::string_view, 5> kind_names{"node_load", "member_load", "reaction", "foundation",
                                                     "section_forces"};

void write_vector(JsonWriter& json, std::string_view key, const Eigen::Vector3d& v)
{
    json.key(key).begin_array().value(v.x()).value(v.y()).value(v.z()).end();
}

void write_section(JsonWriter& json, const Force& force, AnalysisKind kind)
{
    json.member("face", force.is_on_plus_face ? "+x" : "-x").key("section_forces").begin_object();
    for (const MemberComponent component : section_force_components(kind))
        json.member(name(component, kind), value({.forces = force.section, .displacement = {}}, component));
    json.end();
}

void write_force(JsonWriter& json, const Force& force, const Model& model)
{
    json.begin_object().member("kind", kind_names.at(static_cast<std::size_t>(force.kind)));
    if (force.node) json.member("node", model[*force.node].id);
    if (force.member) json.member("member", model[*force.member].id).member("x", force.x);
    write_vector(json, "at", force.at);
    write_vector(json, "force", force.force);
    write_vector(json, "moment", force.moment);
    if (force.kind == ForceKind::SectionForces) write_section(json, force, model.analysis);
    json.end();
}

void write_moment(JsonWriter& json, const MomentTerm& term, AnalysisKind kind)
{
    json.begin_object()
        .member("force", static_cast<double>(term.force))
        .member("of", term.of ? name(*term.of, kind) : force_name(term.dof))
        .member("value", term.value);
    if (term.arm) json.member("arm", *term.arm);
    json.member("moment", term.moment).end();
}

void write_equation(JsonWriter& json, const Equation& equation, AnalysisKind kind)
{
    json.begin_object().member("of", force_name(equation.dof)).key("terms").begin_array();
    for (const double term : equation.terms) json.value(term);
    json.end();
    if (is_rotation(equation.dof)) {
        json.key("moments").begin_array();
        for (const MomentTerm& one : equation.moments) write_moment(json, one, kind);
        json.end();
    }
    json.member("sum", equation.sum).end();
}

void write_ritter_point(JsonWriter& json, const RitterPoint& point, const FreeBody& body, const Model& model)
{
    json.begin_object().member("bar", model[point.bar].id);
    write_vector(json, "at", point.at);
    json.member("arm", point.arm).member("N", ritter_force(body, point).force).end();
}

} // namespace

void write_free_body(JsonWriter& json, const FreeBody& body, const Model& model, const Eigen::Vector3d& about)
{
    json.key("nodes").begin_array();
    for (const NodeId node : body.body.nodes) json.value(model[node].id);
    json.end().key("pieces").begin_array();
    for (const Piece& piece : body.body.pieces)
        json.begin_object()
            .member("member", model[piece.member].id)
            .member("from", piece.from)
            .member("to", piece.to)
            .end();
    json.end();
    write_vector(json, "about", about);
    json.key("forces").begin_array(Layout::Block);
    for (const Force& force : body.forces) write_force(json, force, model);
    json.end().key("equations").begin_array(Layout::Block);
    for (const Equation& equation : equations(body, model.analysis, about))
        write_equation(json, equation, model.analysis);
    json.end();
    if (body.ritter_points.empty()) return;
    json.key("ritter_points").begin_array(Layout::Block);
    for (const RitterPoint& point : body.ritter_points) write_ritter_point(json, point, body, model);
    json.end();
}

} // namespace femoop::free_body
