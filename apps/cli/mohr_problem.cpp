#include "apps/cli/mohr_problem.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "apps/cli/console.h"
#include "apps/cli/mohr_criterion.h"
#include "femoop/methods/mohr/typed_components.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"

namespace cli {

namespace {

using femoop::mohr::Components;
using femoop::mohr::Kind;
namespace dimension = femoop::dimension;

constexpr double degree = std::numbers::pi / 180.0;

/// An option of numbers: what they are called, and their dimension.
struct NumberOption {
    std::string_view name;
    std::vector<std::string_view> numbers;
    femoop::Dimension dimension;
};

const NumberOption plane_stress{"--stress", {"SX", "SY", "TXY"}, dimension::stress};
const NumberOption space_stress{"--stress", {"SX", "SY", "SZ", "TXY", "TYZ", "TZX"}, dimension::stress};
const NumberOption plane_strain{"--strain", {"EX", "EY", "GXY"}, dimension::none};
const NumberOption space_strain{"--strain", {"EX", "EY", "EZ", "GXY", "GYZ", "GZX"}, dimension::none};
const NumberOption inertia{"--inertia", {"IX", "IY", "IXY"}, dimension::second_moment};
const NumberOption angles{"--rosette", {"A1", "A2", "A3"}, dimension::none};
const NumberOption readings{"--rosette", {"R1", "R2", "R3"}, dimension::none};
const NumberOption normal{"--normal", {"NX", "NY", "NZ"}, dimension::none};
const NumberOption E{"--E", {""}, dimension::stress};
const NumberOption nu{"--nu", {""}, dimension::none};
const NumberOption angle{"--angle", {""}, dimension::none};

std::string joined(const std::vector<std::string_view>& names)
{
    std::string text;
    for (const std::string_view name : names) text += (text.empty() ? "" : ",") + std::string(name);
    return text;
}

class Reader {
public:
    explicit Reader(const ui::Catalogue& tr) : tr_(tr) {}

    Components read(const NumberOption& option, const std::vector<std::string>& words) const
    {
        if (words.size() != option.numbers.size()) throw wrong_count({option}, words.size());
        const auto found = femoop::mohr::parse_components(words, option.numbers, option.name, option.dimension);
        if (const auto* fault = std::get_if<femoop::Fault>(&found)) throw UsageError(femoop::message(*fault, tr_));
        return std::get<Components>(found);
    }

    /// As many numbers as the plane option or the option in space has.
    Components read(const NumberOption& in_plane, const NumberOption& in_space,
                    const std::vector<std::string>& words) const
    {
        if (words.size() == in_plane.numbers.size()) return read(in_plane, words);
        if (words.size() == in_space.numbers.size()) return read(in_space, words);
        throw wrong_count({in_plane, in_space}, words.size());
    }

    UsageError refused(std::string_view option, double found, std::string_view wanted) const
    {
        return UsageError(tr_("{option}: found {found}; wanted {wanted}",
                              {{"option", option}, {"found", femoop::number_text(found)}, {"wanted", tr_(wanted)}}));
    }

    const ui::Catalogue& tr() const { return tr_; }

private:
    UsageError wrong_count(const std::vector<NumberOption>& options, std::size_t found) const
    {
        std::string wanted;
        for (const NumberOption& option : options)
            wanted += (wanted.empty() ? "" : " " + tr_("or") + " ") + joined(option.numbers);
        return UsageError(tr_("{option}: wanted {wanted}, separated by commas, with decimal points; found {n}",
                              {{"option", options.front().name}, {"n", std::to_string(found)}, {"wanted", wanted}}));
    }

    const ui::Catalogue& tr_;
};

void take(MohrProblem& problem, Kind plane_kind, Kind space_kind, const Components& given)
{
    const auto& v = given.values;
    problem.unit = given.unit;
    if (v.size() == 3) {
        problem.state = femoop::mohr::plane_state(plane_kind, v[0], v[1], v[2]);
        return;
    }
    const double half = femoop::mohr::is_strain(space_kind) ? 0.5 : 1.0;
    problem.state = {.kind = space_kind, .components = {v[0], v[1], v[2], half * v[3], half * v[4], half * v[5]}};
}

void take_rosette(MohrProblem& problem, const MohrWords& words, const Reader& reader)
{
    const auto t = reader.read(angles, words.rosette_angles).values;
    const auto e = reader.read(readings, words.rosette_readings).values;
    femoop::mohr::Rosette rosette{{}, {e[0], e[1], e[2]}};
    for (std::size_t i = 0; i < 3; ++i) rosette.angles[i] = t[i] * degree;
    if (const auto same = why_not(rosette))
        throw UsageError(
            reader.tr()("--rosette: gauges {first} and {second} measure along one direction ({a} and {b} degrees), "
                        "so three unknowns have two readings; turn one of them",
                        {{"first", std::to_string(same->first + 1)},
                         {"second", std::to_string(same->second + 1)},
                         {"a", femoop::number_text(t[same->first])},
                         {"b", femoop::number_text(t[same->second])}}));
    problem.state = {.kind = Kind::Strain};
    const auto strain = femoop::mohr::strain(rosette);
    problem.state.components = {.x = strain.x, .y = strain.y, .xy = strain.xy};
    problem.rosette = rosette;
}

void take_state(MohrProblem& problem, const MohrWords& words, const Reader& reader)
{
    const int n_given = static_cast<int>(!words.stress.empty()) + static_cast<int>(!words.strain.empty()) +
                        static_cast<int>(!words.inertia.empty()) + static_cast<int>(!words.rosette_angles.empty());
    if (n_given == 0)
        throw UsageError(reader.tr()("no state is given; give one of {options}, or --cases FILE",
                                     {{"options", "--stress, --strain, --rosette, --inertia"}}));
    if (n_given > 1)
        throw UsageError(reader.tr()("more than one state is given; give one of {options}",
                                     {{"options", "--stress, --strain, --rosette, --inertia"}}));
    if (!words.stress.empty())
        take(problem, words.is_plane_strain ? Kind::PlaneStrain : Kind::PlaneStress, Kind::SpaceStress,
             reader.read(plane_stress, space_stress, words.stress));
    if (!words.strain.empty())
        take(problem, Kind::Strain, Kind::SpaceStrain, reader.read(plane_strain, space_strain, words.strain));
    if (!words.inertia.empty()) take(problem, Kind::Inertia, Kind::Inertia, reader.read(inertia, words.inertia));
    if (!words.rosette_angles.empty()) take_rosette(problem, words, reader);
    if (words.is_plane_strain && problem.state.kind != Kind::PlaneStrain)
        throw UsageError(reader.tr()("--plane-strain: wanted with --stress SX,SY,TXY alone; take it away"));
}

void take_material(MohrProblem& problem, const MohrWords& words, const Reader& reader)
{
    const Kind kind = problem.state.kind;
    const bool is_useful = femoop::mohr::is_strain(kind) || kind == Kind::PlaneStrain;
    if (!is_useful && !(words.E.empty() && words.nu.empty()))
        throw UsageError(
            reader.tr()("--E and --nu: wanted with --strain, --rosette or --plane-strain alone; take them away"));
    if (!words.nu.empty()) {
        const double value = reader.read(nu, {words.nu}).values.front();
        const bool has_limit = kind == Kind::SpaceStrain && !words.E.empty();
        if (has_limit && !(value > -1.0 && value < 0.5))
            throw reader.refused("--nu", value, femoop::translatable("a number greater than -1 and less than 0.5"));
        if (!(value > -1.0 && value <= 0.5))
            throw reader.refused("--nu", value, femoop::translatable("a number greater than -1 and at most 0.5"));
        problem.state.nu = value;
    }
    if (!words.E.empty()) {
        const Components given = reader.read(E, {words.E});
        if (!(given.values.front() > 0.0))
            throw reader.refused("--E", given.values.front(), femoop::translatable("a number greater than 0"));
        problem.state.E = given.values.front();
        problem.stress_unit = given.unit;
    }
    if (kind == Kind::PlaneStrain && !problem.state.nu)
        throw UsageError(reader.tr()("--plane-strain: the stress along z needs Poisson's ratio; give --nu"));
    if (problem.state.E && !problem.state.nu)
        throw UsageError(reader.tr()("--E: stresses need Poisson's ratio too; give --nu"));
}

void take_plane(MohrProblem& problem, const MohrWords& words, const Reader& reader)
{
    const bool is_plane = femoop::mohr::is_plane(problem.state.kind);
    if (!words.angle.empty()) {
        if (!is_plane)
            throw UsageError(reader.tr()("--angle: wanted with a plane state; in space give --normal NX,NY,NZ"));
        problem.angle = reader.read(angle, {words.angle}).values.front();
    }
    if (words.normal.empty()) return;
    if (problem.state.kind == Kind::Inertia)
        throw UsageError(reader.tr()("--normal: second moments of area have no third direction; give --angle"));
    const auto n = reader.read(normal, words.normal).values;
    problem.normal = Eigen::Vector3d(n[0], n[1], n[2]);
    if (problem.normal->isZero(0.0))
        throw UsageError(
            reader.tr()("--normal: 0,0,0 has no direction; give a vector square to the plane, such as 1,1,1"));
}

} // namespace

MohrProblem mohr_problem(const MohrWords& words, const ui::Catalogue& tr)
{
    const Reader reader(tr);
    MohrProblem problem;
    take_state(problem, words, reader);
    take_material(problem, words, reader);
    take_plane(problem, words, reader);
    take_criterion(problem, words, tr);
    if (!words.reading_unit.empty()) {
        problem.reading_unit =
            reader.read({"reading_unit", {""}, dimension::none}, {words.reading_unit}).values.front();
        if (!(problem.reading_unit > 0.0))
            throw reader.refused("reading_unit", problem.reading_unit, femoop::translatable("a number greater than 0"));
    }
    return problem;
}

} // namespace cli
