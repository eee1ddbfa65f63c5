#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "femoop/model/model.h"

/// Plane frames that are built in a line: one material, one section and one load case "P".
///
///     FrameMaker made;
///     made.node("A", 0, 0, Fixed).node("B", 4, 0, Roller).member("A", "B").uniform("AB", -12);
class FrameMaker {
public:
    /// Without a section E I = 20000 kN m2, in kN and m.
    FrameMaker() : FrameMaker({.id = "s", .A = 0.01, .Iz = 1e-4, .Asy = 0.004}, {.id = "m", .E = 2e8}) {}
    explicit FrameMaker(femoop::Section section, femoop::Material material = {.id = "steel", .E = 210e6})
    {
        model.add(std::move(material));
        model.add(std::move(section));
        model.add(femoop::LoadCase{.id = "P"});
    }

    FrameMaker& node(const std::string& id, double x, double y, std::optional<femoop::SupportKind> kind = {})
    {
        femoop::Node one{.id = id, .at = {x, y, 0.0}};
        if (kind) one.support = femoop::Support{.kind = *kind};
        model.add(std::move(one));
        return *this;
    }
    /// \param between  what stands between the names of its ends in its own
    FrameMaker& member(const std::string& a, const std::string& b, const std::string& between = "")
    {
        model.add(femoop::Member{.id = a + between + b,
                                 .nodes = {*model.find_node(a), *model.find_node(b)},
                                 .material = femoop::MaterialId(0),
                                 .section = femoop::SectionId(0)});
        return *this;
    }
    FrameMaker& load(const std::string& id, const decltype(femoop::MemberLoad::load)& load)
    {
        model.load_cases[0].members.push_back({.member = *model.find_member(id), .load = load});
        return *this;
    }
    FrameMaker& uniform(const std::string& id, double q)
    {
        return load(id, femoop::DistributedLoad{.values = {{.dof = femoop::Dof::uy, .start = q}}});
    }
    FrameMaker& point(const std::string& id, double at, double fy)
    {
        return load(id, femoop::PointLoad{.at = femoop::Quantity(at), .components = {{femoop::Dof::uy, fy}}});
    }
    FrameMaker& force(const std::string& id, femoop::Dof dof, double value)
    {
        model.load_cases[0].nodes.push_back({.node = *model.find_node(id), .components = {{dof, value}}});
        return *this;
    }

    femoop::Model model;
};

/// A plane frame of bays of 6 m and storeys of 3.5 m, fixed at its feet; its nodes are numbered storey by storey,
/// its members named by them: "0-3". No load case.
inline femoop::Model storey_frame(std::size_t bays, std::size_t storeys)
{
    FrameMaker made({.id = "s", .A = 0.013, .Iz = 1.3e-4});
    made.model.load_cases.clear();
    const auto name = [&](std::size_t x, std::size_t y) { return std::to_string(y * (bays + 1) + x); };
    for (std::size_t y = 0; y <= storeys; ++y)
        for (std::size_t x = 0; x <= bays; ++x) {
            const auto kind = y == 0 ? std::optional(femoop::SupportKind::Fixed) : std::nullopt;
            made.node(name(x, y), 6.0 * static_cast<double>(x), 3.5 * static_cast<double>(y), kind);
            if (y > 0) made.member(name(x, y - 1), name(x, y), "-");
            if (y > 0 && x > 0) made.member(name(x - 1, y), name(x, y), "-");
        }
    return made.model;
}
