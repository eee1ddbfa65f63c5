#include "tests/apps/drawing/view_model.h"

#include "femoop/io/model_file.h"
#include "tests/frame_maker.h"
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
    using enum femoop::SupportKind;
    FrameMaker made({.id = "s", .A = 0.008, .Iz = 2.0e-4});
    made.node("A", 0, 0, Pin).node("B", length, 0, Roller).member("A", "B").uniform("AB", -q);
    made.model.load_cases[0].id = "q";
    return made.model;
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
