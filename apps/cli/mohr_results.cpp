#include "apps/cli/mohr_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "femoop/io/json/json_writer.h"
#include "femoop/methods/mohr/point_results.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/tabular/plain_text.h"

namespace cli {

namespace {

using namespace femoop::mohr;
using femoop::translatable;
using List = std::vector<double>;
using MohrResults = std::vector<MohrResult>;

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

MohrResult::Value degrees_or_null(const std::optional<double>& radians)
{
    if (!radians) return std::monostate{};
    return degrees(*radians);
}

List list(const Eigen::Vector3d& v) { return {v[0] + 0.0, v[1] + 0.0, v[2] + 0.0}; }

/// The components as they are given outside: gamma of a strain, Ixy of second moments.
List given(Kind kind, const PlaneState& state) { return {state.x, state.y, given_shear(kind, state.xy)}; }

void add_plane(MohrResults& results, const MohrProblem& problem, const PointResults& point)
{
    const Kind kind = problem.state.kind;
    if (problem.rosette) results.push_back({"strain", given(kind, point.plane)});
    results.push_back({"center", point.circle.centre});
    results.push_back({"radius", point.circle.radius});
    results.push_back({"principal", List{point.principal.first, point.principal.second}});
    results.push_back({"theta_p_deg", degrees_or_null(point.principal.angle)});
    results.push_back({"theta_p2_deg", degrees_or_null(point.second_angle)});
    results.push_back({"theta_s_deg", degrees_or_null(point.shear_angle)});
    results.push_back({"tau_max", point.circle.radius});
    if (is_strain(kind)) results.push_back({"gamma_max", 2.0 * point.circle.radius});
    results.push_back({"pole", List{point.pole_of_planes.normal, point.pole_of_planes.shear}});
    if (problem.angle) results.push_back({"rotated", given(kind, point.turned)});
}

void add_directions(MohrResults& results, const PointResults& point)
{
    const SpacePrincipal& p = point.space_principal;
    results.push_back({"principal", List(p.values.begin(), p.values.end())});
    results.push_back({"tau_max", point.absolute_shear});
    std::vector<List> rows;
    for (const Circle& c : circles(p)) rows.push_back({c.centre, c.radius});
    results.push_back({"circles", rows});
    constexpr std::array<std::string_view, 3> keys{"direction_1", "direction_2", "direction_3"};
    constexpr std::array<std::string_view, 3> sizes{"direction_1_abs", "direction_2_abs", "direction_3_abs"};
    for (int k = 0; k < 3; ++k) results.push_back({keys[k], list(p.directions.col(k))});
    for (int k = 0; k < 3; ++k) results.push_back({sizes[k], list(p.directions.col(k).cwiseAbs())});
}

void add_space(MohrResults& results, Kind kind, const PointResults& point)
{
    const Invariants& i = point.invariants;
    const Deviator& d = point.deviator;
    if (!is_plane(kind)) add_directions(results, point);
    results.push_back({"tau_max_absolute", point.absolute_shear});
    results.push_back({"invariants", List{i.I1 + 0.0, i.I2 + 0.0, i.I3 + 0.0}});
    results.push_back({"deviatoric", List{d.values[0] + 0.0, d.values[1] + 0.0, d.values[2] + 0.0}});
    results.push_back({"octahedral_normal", d.mean + 0.0});
    results.push_back({"octahedral_shear", d.octahedral_shear});
    results.push_back({"lode_deg", degrees_or_null(d.lode)});
    if (is_stress(kind)) results.push_back({"von_mises", d.equivalent});
}

void add_stress(MohrResults& results, Kind kind, const PointResults& point)
{
    if (!point.stress) return;
    const SpaceState& s = *point.stress;
    results.push_back({"stress", is_plane(kind) ? List{s.x, s.y, s.xy} : List{s.x, s.y, s.z, s.xy, s.yz, s.zx}});
    const auto& values = point.principal_stress->values;
    results.push_back({"principal_stress", List(values.begin(), values.end())});
}

void add_plane_through(MohrResults& results, const OnPlane& on)
{
    results.push_back({"normal", list(on.normal)});
    results.push_back({"traction", list(on.traction)});
    results.push_back({"sigma_n", on.normal_component + 0.0});
    results.push_back({"tau_n", on.shear});
}

/// How far the stress is from failure, in proportion, and the normals of the planes that fail.
void add_safety(MohrResults& results, const Safety& found)
{
    results.push_back({"safety_factor", found.factor ? MohrResult::Value(*found.factor) : std::monostate{}});
    std::vector<List> normals;
    for (const Eigen::Vector3d& normal : found.planes) normals.push_back(list(normal));
    results.push_back({"failing_planes", normals});
}

/// How a result is called in a table, and its parts.
struct Label {
    std::string_view key, text;
    std::string_view parts{};
};

constexpr std::array labels{
    Label{"strain", translatable("strain from the gauges"), "ex ey gxy"},
    Label{"center", translatable("centre of the circle")},
    Label{"radius", translatable("radius of the circle")},
    Label{"principal", translatable("principal value"), "1 2 3"},
    Label{"theta_p_deg", translatable("from x to the first principal direction [deg]")},
    Label{"theta_p2_deg", translatable("from x to the second principal direction [deg]")},
    Label{"theta_s_deg", translatable("from x to the direction of largest shear [deg]")},
    Label{"tau_max", translatable("largest shear")},
    Label{"gamma_max", translatable("largest shear strain gamma")},
    Label{"tau_max_absolute", translatable("largest shear in space")},
    Label{"pole", translatable("pole"), "n s"},
    Label{"rotated", translatable("in the turned axes"), "x' y' x'y'"},
    Label{"direction_1", translatable("first principal direction"), "x y z"},
    Label{"direction_2", translatable("second principal direction"), "x y z"},
    Label{"direction_3", translatable("third principal direction"), "x y z"},
    Label{"invariants", translatable("invariant"), "I1 I2 I3"},
    Label{"deviatoric", translatable("principal deviator"), "1 2 3"},
    Label{"octahedral_normal", translatable("octahedral normal component")},
    Label{"octahedral_shear", translatable("octahedral shear")},
    Label{"lode_deg", translatable("Lode angle t [deg], cos 3t = 2.598 J3/J2^1.5")},
    Label{"von_mises", translatable("von Mises stress")},
    Label{"stress", translatable("stress"), "x y xy"},
    Label{"principal_stress", translatable("principal stress"), "1 2 3"},
    Label{"normal", translatable("unit normal of the plane"), "x y z"},
    Label{"traction", translatable("traction on the plane"), "x y z"},
    Label{"sigma_n", translatable("normal component on the plane")},
    Label{"tau_n", translatable("shear on the plane")},
    Label{"safety_factor", translatable("safety factor")},
    Label{"failing_planes", translatable("normal of a failing plane"), "x y z"},
};

std::vector<std::string> parts_of(const Label& label, std::size_t n)
{
    std::vector<std::string> parts;
    const std::string_view names = label.key == "stress" && n == 6 ? "x y z xy yz zx" : label.parts;
    for (std::size_t begin = 0; begin < names.size();) {
        const std::size_t end = std::min(names.find(' ', begin), names.size());
        parts.emplace_back(names.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// Of a strain the tensor's shear is half of gamma, and second moments of area have a product instead.
std::string name_of(const Label& label, Kind kind, const ui::Catalogue& tr)
{
    constexpr std::array<std::string_view, 4> shears{"tau_max", "tau_max_absolute", "octahedral_shear", "tau_n"};
    if (std::ranges::find(shears, label.key) == shears.end()) return tr(label.text);
    if (kind == Kind::Inertia) return tr("largest product of inertia");
    return tr(label.text) + (is_strain(kind) ? ", gamma/2" : "");
}

/// A line for each number; a number keeps six digits of its own, because a table of them mixes every dimension.
void add_lines(tabular::Table& table, const MohrResult& result, Kind kind, const ui::Catalogue& tr)
{
    const auto label = std::find_if(labels.begin(), labels.end(), [&](const Label& l) { return l.key == result.key; });
    if (label == labels.end()) return;
    const std::string text = name_of(*label, kind, tr);
    const auto number = [&](double value) {
        std::array<char, 32> buffer{};
        static_cast<void>(std::snprintf(buffer.data(), buffer.size(), "%.6g", value));
        return femoop::localized(buffer.data(), tr);
    };
    if (std::holds_alternative<std::monostate>(result.value))
        table.add_row(
            {text, result.key == "safety_factor" ? tr("never fails this way") : tr("none: every direction is")});
    else if (const auto* value = std::get_if<double>(&result.value)) table.add_row({text, number(*value)});
    const auto add_list = [&](const List& values) {
        const auto parts = parts_of(*label, values.size());
        for (std::size_t i = 0; i < values.size(); ++i) table.add_row({text + " " + parts[i], number(values[i])});
    };
    if (const auto* values = std::get_if<List>(&result.value)) add_list(*values);
    if (const auto* rows = std::get_if<std::vector<List>>(&result.value)) std::ranges::for_each(*rows, add_list);
}

std::string unit_lines(const MohrProblem& problem, const ui::Catalogue& tr)
{
    std::string text;
    if (!problem.unit.empty()) text += tr("in {unit}", {{"unit", problem.unit}}) + "\n";
    if (!problem.stress_unit.empty()) text += tr("stresses in {unit}", {{"unit", problem.stress_unit}}) + "\n";
    return text;
}

void write(femoop::JsonWriter& json, const List& values)
{
    json.begin_array();
    for (const double value : values) json.value(value);
    json.end();
}

} // namespace

std::vector<MohrResult> mohr_results(const MohrProblem& problem)
{
    const Kind kind = problem.state.kind;
    const PointResults point = point_results({.state = problem.state,
                                              .rule = usual_rule(kind),
                                              .angle = problem.angle.value_or(0.0) * std::numbers::pi / 180.0,
                                              .normal = problem.normal.value_or(Eigen::Vector3d::Ones()),
                                              .criterion = problem.criterion,
                                              .strength = problem.strength,
                                              .strain_unit = problem.reading_unit});
    MohrResults results;
    if (is_plane(kind)) add_plane(results, problem, point);
    // How a rosette's surface strains across itself is known with Poisson's ratio only.
    const bool has_third = point.space && (!problem.rosette || problem.state.nu);
    if (has_third) add_space(results, kind, point);
    if (problem.normal && point.space) add_plane_through(results, point.on_plane);
    add_stress(results, kind, point);
    if (point.safety) add_safety(results, *point.safety);
    return results;
}

const MohrResult* find_result(const std::vector<MohrResult>& results, std::string_view key)
{
    const auto found = std::find_if(results.begin(), results.end(), [&](const MohrResult& r) { return r.key == key; });
    return found == results.end() ? nullptr : &*found;
}

std::string mohr_json(const std::vector<MohrResult>& results, const MohrProblem& problem)
{
    femoop::JsonWriter json;
    json.begin_object(femoop::JsonWriter::Layout::Block);
    if (!problem.unit.empty()) json.member("unit", problem.unit);
    if (!problem.stress_unit.empty()) json.member("stress_unit", problem.stress_unit);
    if (!is_possible(problem.state)) json.member("possible", false);
    for (const MohrResult& result : results) {
        json.key(result.key);
        if (const auto* number = std::get_if<double>(&result.value)) json.value(*number);
        else if (const auto* values = std::get_if<List>(&result.value)) write(json, *values);
        else if (const auto* rows = std::get_if<std::vector<List>>(&result.value)) {
            json.begin_array();
            for (const List& row : *rows) write(json, row);
            json.end();
        } else json.null();
    }
    json.end();
    return json.take();
}

std::string mohr_table(const std::vector<MohrResult>& results, const MohrProblem& problem, const ui::Catalogue& tr)
{
    tabular::Table table({tr("result"), tr("value")});
    for (const MohrResult& result : results) add_lines(table, result, problem.state.kind, tr);
    std::string text = unit_lines(problem, tr) + tabular::plain_text(table);
    if (!is_possible(problem.state))
        text += tr("no section has these second moments: a principal one is negative") + "\n";
    return text;
}

} // namespace cli
