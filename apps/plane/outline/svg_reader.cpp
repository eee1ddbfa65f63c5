#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <utility>

#include "apps/plane/outline/gathering.h"
#include "apps/plane/outline/svg_path.h"
#include "femoop/model/fault/translator.h"
#include "topology/text/line_error.h"

namespace outline {

using femoop::translatable;
using topology::LineError;

namespace {

constexpr std::size_t deepest = 100; // of groups in groups

/// The line of a text that a place in it lies on.
std::size_t line_at(std::string_view text, std::ptrdiff_t offset)
{
    const auto end = std::min(text.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
    return static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n')) +
           1;
}

/// What stands there, as far as an error shows it.
std::string_view beginning(std::string_view text, std::ptrdiff_t offset)
{
    const auto from = std::min(text.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
    const std::string_view rest = text.substr(from, 40);
    return rest.substr(0, rest.find('\n'));
}

/// Without the prefix of its name space.
std::string_view name_of(const pugi::xml_node& node)
{
    const std::string_view name = node.name();
    return name.substr(name.find(':') + 1);
}

/// A length with its unit in mm; nothing where it has none that is one of the physical ones, or is in per cent.
std::optional<double> millimetres(std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, double>, 5> units{
        {{"mm", 1.0}, {"cm", 10.0}, {"in", 25.4}, {"pt", 25.4 / 72.0}, {"pc", 25.4 / 6.0}}};
    for (const auto& [unit, mm] : units)
        if (text.ends_with(unit)) return number(text.substr(0, text.size() - unit.size())) * mm;
    return std::nullopt;
}

/// A length in the units of the drawing; those with a unit are pixels of 1/96 inch.
double length(std::string_view text)
{
    constexpr double pixels_per_mm = 96.0 / 25.4;
    if (const auto mm = millimetres(text)) return *mm * pixels_per_mm;
    return number(text.ends_with("px") ? text.substr(0, text.size() - 2) : text);
}

double length_of(const pugi::xml_node& node, const char* name, double absent = 0.0)
{
    const std::string_view text = node.attribute(name).value();
    return text.empty() ? absent : length(text);
}

EllipticArc ellipse_about(const Place& center, double rx, double ry)
{
    return {.center = center, .u = {rx, 0.0}, .v = {0.0, ry}};
}

/// The sides and the rounded corners of a rectangle.
std::vector<Curve> rectangle(const pugi::xml_node& node)
{
    const double x = length_of(node, "x"), y = length_of(node, "y");
    const double w = length_of(node, "width"), h = length_of(node, "height");
    if (!(w > 0.0) || !(h > 0.0)) return {};
    const double either = length_of(node, "rx", length_of(node, "ry"));
    const double rx = std::clamp(length_of(node, "rx", either), 0.0, 0.5 * w);
    const double ry = std::clamp(length_of(node, "ry", either), 0.0, 0.5 * h);
    if (rx == 0.0 || ry == 0.0) return {Polyline{{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, true}};
    std::vector<Curve> curves;
    const auto side = [&](const Place& from, const Place& to) {
        if (from != to) curves.emplace_back(Polyline{{from, to}});
    };
    const auto corner = [&](double cx, double cy, double from) {
        EllipticArc arc = ellipse_about({cx, cy}, rx, ry);
        arc.from = from;
        arc.to = from + 0.5 * std::numbers::pi;
        curves.emplace_back(arc);
    };
    const double left = x + rx, right = x + w - rx, top = y + ry, bottom = y + h - ry, quarter = 0.5 * std::numbers::pi;
    side({left, y}, {right, y});
    corner(right, top, -quarter);
    side({x + w, top}, {x + w, bottom});
    corner(right, bottom, 0.0);
    side({right, y + h}, {left, y + h});
    corner(left, bottom, quarter);
    side({x, bottom}, {x, top});
    corner(left, top, 2.0 * quarter);
    return curves;
}

std::vector<Place> corners_of(const pugi::xml_node& node)
{
    const std::vector<double> numbers = svg_numbers(node.attribute("points").value());
    std::vector<Place> places;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) places.emplace_back(numbers[i], numbers[i + 1]);
    return places;
}

/// What a shape is drawn by; nothing of an element that is none.
std::optional<std::vector<Curve>> curves_of(const pugi::xml_node& node)
{
    using Curves = std::vector<Curve>;
    const std::string_view name = name_of(node);
    if (name == "path") return svg_path(node.attribute("d").value());
    if (name == "rect") return rectangle(node);
    if (name == "line")
        return Curves{
            Polyline{{{length_of(node, "x1"), length_of(node, "y1")}, {length_of(node, "x2"), length_of(node, "y2")}}}};
    if (name == "polyline") return Curves{Polyline{corners_of(node)}};
    if (name == "polygon") return Curves{Polyline{corners_of(node), true}};
    if (name != "circle" && name != "ellipse") return std::nullopt;
    const Place center(length_of(node, "cx"), length_of(node, "cy"));
    const double r = length_of(node, "r"), rx = length_of(node, "rx", r), ry = length_of(node, "ry", r);
    if (!(rx > 0.0) || !(ry > 0.0)) return Curves{};
    return Curves{ellipse_about(center, rx, ry)};
}

/// Does one of the declarations of a style say so? Blanks do not matter.
bool has_style(const pugi::xml_node& node, std::string_view property, std::string_view value)
{
    std::string style = node.attribute("style").value();
    std::erase_if(style, [](char c) { return c == ' ' || c == '\n' || c == '\t'; });
    const std::string wanted = std::string(property) + ":" + std::string(value);
    return node.attribute(std::string(property).c_str()).value() == value ||
           (";" + style + ";").find(";" + wanted + ";") != std::string::npos;
}

class SvgReader {
public:
    explicit SvgReader(std::string_view text) : text_(text)
    {
        const pugi::xml_parse_result read = document_.load_buffer(text.data(), text.size());
        if (!read)
            throw LineError(translatable("it is no XML that can be read: {0}"), {read.description()})
                .at(line_at(text, read.offset), beginning(text, read.offset));
    }

    Outline take()
    {
        const pugi::xml_node root = document_.document_element();
        if (name_of(root) != "svg")
            throw LineError(translatable("it is no SVG file; found <{0}> where <svg> is wanted"), {root.name()})
                .at(line_at(text_, root.offset_debug()), root.name());
        at_line_of(root, [&] { draw_inside(root, page(root), 0); });
        return found_.take();
    }

private:
    /// What goes wrong names the line of the innermost element.
    template <class Work> void at_line_of(const pugi::xml_node& node, const Work& work)
    {
        try {
            work();
        } catch (const LineError& fault) {
            if (fault.number() > 0) throw;
            throw fault.at(line_at(text_, node.offset_debug()), node.name());
        }
    }

    /// From the units of the page to the outline's: mm where the page says how large it is, with y upwards from its lower
    /// edge.
    Affine page(const pugi::xml_node& root)
    {
        const std::string_view width = root.attribute("width").value(), height = root.attribute("height").value();
        const std::vector<double> box = svg_numbers(root.attribute("viewBox").value());
        const bool has_box = box.size() == 4 && box[2] > 0.0 && box[3] > 0.0;
        double scale = 1.0;
        if (const auto mm = millimetres(width)) {
            found_.set_unit(femoop::LengthUnit::mm);
            scale = has_box ? *mm / box[2] : 25.4 / 96.0;
        }
        double bottom = 0.0;
        if (has_box) bottom = box[1] + box[3];
        else if (!height.empty() && !height.ends_with("%")) bottom = length(height);
        const double left = has_box ? box[0] : 0.0;
        return Affine::Identity() * Eigen::Scaling(scale, -scale) * Eigen::Translation2d(-left, -bottom);
    }

    /// For one group more.
    void require_room(std::size_t depth, std::size_t most)
    {
        if (depth >= deepest || ++n_groups_ > most)
            throw LineError(translatable("groups lie more than {0} deep in one another, or too many"),
                            {std::to_string(deepest)});
    }

    void draw_inside(const pugi::xml_node& parent, const Affine& map, std::size_t depth)
    {
        require_room(depth, most_pieces);
        for (const pugi::xml_node& node : parent.children())
            if (node.type() == pugi::node_element) at_line_of(node, [&] { draw(node, map, depth); });
    }

    void draw(const pugi::xml_node& node, const Affine& map, std::size_t depth)
    {
        if (has_style(node, "display", "none") || has_style(node, "visibility", "hidden")) return;
        const Affine own = map * svg_transform(node.attribute("transform").value());
        const std::string_view name = name_of(node);
        if (name == "g" || name == "a" || name == "switch") return draw_inside(node, own, depth + 1);
        if (name == "svg") return draw_inside(node, at_place(own, node), depth + 1);
        if (name == "use") return draw_used(node, at_place(own, node), depth);
        if (const auto curves = curves_of(node)) {
            for (const Curve& curve : *curves) found_.add(curve, own);
        } else if (name == "text" || name == "image" || name == "foreignObject") {
            found_.leave_out(std::string(name));
        }
    }

    static Affine at_place(const Affine& map, const pugi::xml_node& node)
    {
        return map * Eigen::Translation2d(length_of(node, "x"), length_of(node, "y"));
    }

    /// The element of that id, or what is inside a symbol.
    void draw_used(const pugi::xml_node& use, const Affine& map, std::size_t depth)
    {
        const char* const link = use.attribute("href") ? use.attribute("href").value()
                                                       : use.attribute("xlink:href").value();
        const std::string id = link[0] == '#' ? link + 1 : "";
        const pugi::xml_node used = document_.find_node(
            [&](const pugi::xml_node& node) { return !id.empty() && node.attribute("id").value() == id; });
        if (!used) return found_.leave_out("use");
        require_room(depth, most_used);
        if (name_of(used) == "symbol") draw_inside(used, map, depth + 1);
        else draw(used, map, depth + 1);
    }

    static constexpr std::size_t most_used = 10'000; // each is looked for in all of the file
    std::string_view text_;
    pugi::xml_document document_;
    Gathering found_;
    std::size_t n_groups_ = 0;
};

} // namespace

Outline read_svg(std::string_view text) { return SvgReader(text).take(); }

} // namespace outline
