#include "femoop/edit/reverse.h"

#include <algorithm>
#include <utility>

#include "femoop/edit/member_line.h"

namespace femoop {

namespace {

/// Is this component along an axis that turns with the member? A plane member turns about z', others about y'.
bool turns(Dof dof, AnalysisKind kind)
{
    const bool is_plane = kind == AnalysisKind::Truss2d || kind == AnalysisKind::Frame2d;
    if (is_plane) return dof == Dof::ux || dof == Dof::uy;
    return dof != Dof::uy && dof != Dof::ry;
}

class LoadReverser {
public:
    LoadReverser(AnalysisKind kind, double length) : kind_(kind), length_(length) {}

    void operator()(DistributedLoad& load) const
    {
        const std::optional<Position> from = load.from;
        load.from = load.to ? std::optional(mirrored(*load.to)) : std::nullopt;
        load.to = from ? std::optional(mirrored(*from)) : std::nullopt;
        for (DistributedLoad::Value& value : load.values) {
            if (value.end) std::swap(value.start, *value.end);
            turn(value.dof, value.start, load.axes);
            if (value.end) turn(value.dof, *value.end, load.axes);
        }
    }
    void operator()(PointLoad& load) const
    {
        load.at = mirrored(load.at);
        turn(load.components, load.axes);
    }
    void operator()(EndLoads& load) const
    {
        std::swap(load.start, load.end);
        turn(load.start, load.axes);
        turn(load.end, load.axes);
    }
    void operator()(TemperatureLoad& load) const
    {
        if (turns(Dof::uy, kind_)) std::swap(load.top, load.bottom);
    }
    void operator()(Misfit&) const {}

private:
    Position mirrored(const Position& position) const
    {
        if (const auto* const percent = std::get_if<Percent>(&position)) return Percent{100.0 - percent->value};
        return Quantity(length_ - distance(position, length_));
    }
    void turn(Dof dof, Quantity& value, LoadAxes axes) const
    {
        if (axes == LoadAxes::Local && turns(dof, kind_)) value = -value.value();
    }
    void turn(std::vector<Component>& components, LoadAxes axes) const
    {
        for (Component& component : components) turn(component.dof, component.value, axes);
    }

    AnalysisKind kind_;
    double length_;
};

} // namespace

void reverse_member(Model& model, MemberId id)
{
    const LoadReverser reverser(model.analysis, line_of(model, model[id]).length);
    Member& member = model.members[id.index];
    std::swap(member.nodes[0], member.nodes[1]);
    std::swap(member.start, member.end);
    for (LoadCase& load_case : model.load_cases)
        for (MemberLoad& load : load_case.members)
            if (load.member == id) std::visit(reverser, load.load);
    std::erase_if(model.expected, [&](const Expected& check) { return check.member == id; });
}

} // namespace femoop
