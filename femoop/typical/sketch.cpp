#include "femoop/typical/sketch.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "femoop/typical/steel.h"

namespace femoop {

namespace {

[[noreturn]] void refuse(std::string_view name, double value, const std::string& wanted)
{
    std::ostringstream sentence;
    sentence << name << ": " << value << " is not " << wanted;
    throw std::invalid_argument(sentence.str());
}

} // namespace

Sketch::Sketch(std::string title, AnalysisKind kind)
{
    model_.title = std::move(title);
    model_.analysis = kind;
    model_.add(steel(model_.units, "210 GPa"));
    model_.add(Section{.id = "s1", .A = 0.01, .Iz = 2e-4, .Iy = 5e-5, .J = 3e-6});
    model_.add(LoadCase{.id = "G"});
}

NodeId Sketch::node(std::string id, double x, double y, double z)
{
    return model_.add(Node{.id = std::move(id), .at = {x, y, z}});
}

MemberId Sketch::member(NodeId start, NodeId end)
{
    return model_.add(Member{.id = model_[start].id + model_[end].id,
                             .nodes = {start, end},
                             .material = MaterialId(0),
                             .section = SectionId(0)});
}

void Sketch::support(NodeId node, SupportKind kind) { model_.nodes[node.index].support = Support{.kind = kind}; }

void Sketch::support(NodeId node, DofSet blocked) { model_.nodes[node.index].support = Support{.fixed = blocked}; }

void Sketch::load(NodeId node, Dof dof, double value)
{
    if (value != 0.0) model_.load_cases[0].nodes.push_back({node, {{dof, value}}});
}

void Sketch::load(MemberId member, double qy, bool is_projected)
{
    if (qy != 0.0)
        model_.load_cases[0].members.push_back(
            {member, DistributedLoad{.values = {{.dof = Dof::uy, .start = qy}}, .projected = is_projected}});
}

void Sketch::load_down(MemberId member, double qz)
{
    if (qz != 0.0)
        model_.load_cases[0].members.push_back({member, DistributedLoad{.values = {{.dof = Dof::uz, .start = qz}}}});
}

std::string letter_name(int i)
{
    const std::string letter(1, static_cast<char>('A' + i % 26));
    return i < 26 ? letter : letter + std::to_string(i / 26);
}

void require_within(std::string_view name, double value, double least, double most)
{
    if (value >= least && value <= most) return;
    std::ostringstream wanted;
    wanted << "between " << least << " and " << most;
    refuse(name, value, wanted.str());
}

void require_positive(std::string_view name, double value)
{
    if (!(value > 0.0) || !std::isfinite(value)) refuse(name, value, "a positive length");
}

} // namespace femoop
