#include "tests/apps/drawing/view_model.h"

#include "femoop/io/model_file.h"
#include "tests/source_folder.h"
#include "ui/paint/text_measure.h"

#include <algorithm>
#include <filesystem>

namespace view_test {

namespace {

const std::filesystem::path top = source_folder();

} // namespace

femoop::Model example(std::string_view name)
{
    return femoop::read_model_file(top / "examples" / (std::string(name) + ".json"));
}

femoop::Model model(std::string_view name)
{
    return femoop::read_model_file(top / "tests/apps/drawing/models" / (std::string(name) + ".json"));
}

femoop::Model simple_beam(double length, double q)
{
    femoop::Model model;
    const auto steel = model.add(femoop::Material{.id = "steel", .E = 210e6});
    const auto section = model.add(femoop::Section{.id = "s", .A = 0.008, .Iz = 2.0e-4});
    const auto a = model.add(
        femoop::Node{.id = "A", .at = {0.0, 0.0, 0.0}, .support = femoop::Support{.kind = femoop::SupportKind::Pin}});
    const auto b = model.add(femoop::Node{
        .id = "B", .at = {length, 0.0, 0.0}, .support = femoop::Support{.kind = femoop::SupportKind::Roller}});
    const auto member = model.add(femoop::Member{.id = "AB", .nodes = {a, b}, .material = steel, .section = section});
    femoop::DistributedLoad load;
    load.values.push_back({.dof = femoop::Dof::uy, .start = -q});
    femoop::LoadCase load_case{.id = "q"};
    load_case.members.push_back({.member = member, .load = load});
    model.add(load_case);
    return model;
}

void Marks::stroke(const ui::Path& path, const ui::Stroke& stroke)
{
    lines.push_back({{path.points.begin(), path.points.end()}, stroke});
}

void Marks::fill(std::span<const ui::Point> polygon, ui::Color color)
{
    areas.push_back({{polygon.begin(), polygon.end()}, color});
}

void Marks::text(ui::Point at, std::string_view utf8, const ui::TextStyle& style)
{
    texts.push_back({std::string(utf8), ui::text_box(fonts_, at, utf8, style)});
}

bool Marks::has_text(std::string_view words) const
{
    return std::any_of(texts.begin(), texts.end(), [&](const Text& text) { return text.words == words; });
}

} // namespace view_test
