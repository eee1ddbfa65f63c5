#include "femoop/io/counting/counting_text.h"

namespace femoop::counting {

namespace {

using Layout = JsonWriter::Layout;

template <class Ids> void write_names(JsonWriter& json, std::string_view key, const Ids& ids, const Model& model)
{
    json.key(key).begin_array();
    for (const auto id : ids) json.value(model[id].id);
    json.end();
}

void write_joint(JsonWriter& json, const ReleasedJoint& joint, const Model& model)
{
    json.begin_object().member("node", model[joint.node].id).key("ends").begin_array();
    for (const ReleasedJoint::End& end : joint.ends)
        json.begin_object()
            .member("member", model[end.member].id)
            .member("end", end.end == 0 ? "start" : "end")
            .member("released", end.n_released)
            .end();
    json.end().member("free_rotations", joint.n_free_rotations).member("count", joint.count()).end();
}

void write_support(JsonWriter& json, const SupportReactions& support, const Model& model)
{
    json.begin_object().member("node", model[support.node].id).member("blocked", support.n_blocked);
    json.member("springs", support.n_springs).member("count", support.count()).end();
}

void write_degree(JsonWriter& json, const Indeterminacy& degree)
{
    json.key("degree").begin_object().member("total", degree.total()).member("external", degree.external);
    json.member("internal", degree.internal).end().member("foundation", degree.has_foundation);
}

} // namespace

void write_counting(JsonWriter& json, const Counting& counting, const Model& model)
{
    json.begin_object(Layout::Block).member("analysis", name(counting.kind));
    write_degree(json, counting.degree());
    json.member("members", counting.n_members).member("joints", counting.n_joints).member("parts", counting.n_parts);
    json.member("equations_per_joint", counting.equations_per_joint());
    json.member("equations_per_part", counting.equations_per_part())
        .member("forces_per_ring", counting.forces_per_ring());
    json.key("rings").begin_array(Layout::Block);
    for (const Ring& ring : counting.rings) {
        json.begin_object();
        write_names(json, "members", ring.members, model);
        json.end();
    }
    json.end().key("releases").begin_array(Layout::Block);
    for (const ReleasedJoint& joint : counting.releases) write_joint(json, joint, model);
    json.end().key("reactions").begin_array(Layout::Block);
    for (const SupportReactions& support : counting.reactions) write_support(json, support, model);
    json.end();
    write_names(json, "loose_nodes", counting.loose_nodes, model);
    if (counting.n_motions) json.member("motions", *counting.n_motions);
    json.end();
}

} // namespace femoop::counting
