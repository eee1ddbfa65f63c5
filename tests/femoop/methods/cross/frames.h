#pragma once

#include <optional>
#include <string>
#include <vector>

#include "femoop/model/model.h"

/// Frames that are built in a line: E I = 20000 kN m2 in kN and m.
class FrameMaker {
public:
    FrameMaker()
    {
        model.add(femoop::Material{.id = "m", .E = 2e8});
        model.add(femoop::Section{.id = "s", .A = 0.01, .Iz = 1e-4, .Asy = 0.004});
        model.add(femoop::LoadCase{.id = "P"});
    }
    FrameMaker& node(const std::string& id, double x, double y, std::optional<femoop::SupportKind> kind = {})
    {
        femoop::Node one{.id = id};
        one.at = {x, y, 0.0};
        if (kind) one.support = femoop::Support{.kind = *kind};
        model.add(std::move(one));
        return *this;
    }
    FrameMaker& member(const std::string& a, const std::string& b)
    {
        model.add(femoop::Member{.id = a + b,
                                 .nodes = {*model.find_node(a), *model.find_node(b)},
                                 .material = femoop::MaterialId(0),
                                 .section = femoop::SectionId(0)});
        return *this;
    }
    FrameMaker& uniform(const std::string& id, double q)
    {
        femoop::DistributedLoad load;
        load.values.push_back({.dof = femoop::Dof::uy, .start = q});
        model.load_cases[0].members.push_back({.member = *model.find_member(id), .load = load});
        return *this;
    }
    FrameMaker& point(const std::string& id, double at, double fy)
    {
        model.load_cases[0].members.push_back(
            {.member = *model.find_member(id),
             .load = femoop::PointLoad{.at = femoop::Quantity(at), .components = {{femoop::Dof::uy, fy}}}});
        return *this;
    }
    FrameMaker& force(const std::string& id, femoop::Dof dof, double value)
    {
        model.load_cases[0].nodes.push_back({.node = *model.find_node(id), .components = {{dof, value}}});
        return *this;
    }

    femoop::Model model;
};

inline constexpr auto fixed = femoop::SupportKind::Fixed, pin = femoop::SupportKind::Pin,
                      roller = femoop::SupportKind::Roller;
