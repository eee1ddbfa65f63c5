#include "apps/plane/view/reaction_marks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/drawing/sketch/symbols.h"
#include "femoop/plane/result/support_resultants.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using Eigen::Vector2d;
using ui::Measure;
using ui::Point;
using ui::Role;

constexpr double reaction_arrow = 40.0, reaction_gap = 5.0, moment_radius = 17.0; // [px]
constexpr double nothing = 1e-9;                                                  // beside the largest

/// What forces and moments of a case are measured by: less than a tiny part of it is rounding.
struct ReactionSize {
    double force = 0.0, moment = 0.0;

    explicit ReactionSize(const fp::PlaneCase& result)
    {
        double reach = 0.0;
        const fp::PlaneModel& model = result.structure().model();
        for (std::size_t i = 0; i < model.points.size(); ++i) {
            force = std::max(force, result.reaction(femoop::NodeId(i)).norm());
            reach = std::max(reach, result.structure().positions()[i].norm());
        }
        // loads that balance one another leave reactions of rounding alone: what elements carry is large beside them
        constexpr std::size_t n_samples = 200;
        const std::size_t step = std::max<std::size_t>(1, model.elements.size() / n_samples);
        for (std::size_t e = 0; e < model.elements.size(); e += step)
            for (const Vector2d& of_node : result.node_forces(fp::ElementId(e)))
                force = std::max(force, of_node.norm());
        const femoop::Equilibrium sums = result.equilibrium();
        for (const femoop::NodeVector& sum : {sums.sum_loads, sums.sum_reactions})
            force = std::max({force, std::abs(sum[0]), std::abs(sum[1])});
        moment = force * reach;
    }

    static double rounded(double value, double beside) { return std::abs(value) <= nothing * beside ? 0.0 : value; }
    double of_force(double value) const { return rounded(value, force); }
    double of_moment(double value) const { return rounded(value, moment); }
};

bool turns_about_axis(const fp::PlaneCase& result)
{
    return result.structure().model().analysis == femoop::StressState::Axisymmetric;
}

/// Turns numbers of a case into the words of its table.
class ReactionWords {
public:
    ReactionWords(const fp::PlaneCase& result, const ui::DisplayUnits& units)
        : units_(units), size_(result), has_x_(!turns_about_axis(result))
    {}

    ReactionTable::Row row(std::string name, double fx, double fy, double mz) const
    {
        return {.name = std::move(name),
                .fx = has_x_ ? text(size_.of_force(fx), Measure::Force) : "",
                .fy = text(size_.of_force(fy), Measure::Force),
                .mz = has_x_ ? text(size_.of_moment(mz), Measure::Moment) : ""};
    }
    ReactionTable::Row row(std::string name, const femoop::NodeVector& sum) const
    {
        return row(std::move(name), sum[0], sum[1], sum[5]);
    }

private:
    std::string text(double value, Measure measure) const { return ui::with_minus_signs(units_.text(value, measure)); }

    const ui::DisplayUnits& units_;
    ReactionSize size_;
    bool has_x_;
};

femoop::NodeVector total(const femoop::Equilibrium& sums)
{
    femoop::NodeVector sum{};
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = sums.sum_loads[i] + sums.sum_reactions[i];
    return sum;
}

/// One component of a resultant, its head at the place that it acts on.
void draw_component(const PlateScene& scene, Point at, const Vector2d& along, double value, const char* name)
{
    const Point d = (value < 0.0 ? -1.0 : 1.0) * PlateScene::direction(along);
    const Point head = at - scene.sketch.px(reaction_gap) * d, tail = head - scene.sketch.px(reaction_arrow) * d;
    drawing::draw(scene.sketch, {.tail = tail, .head = head, .role = Role::Reaction});
    if (!scene.shows(PlateShow::Values)) return;
    scene.sketch.caption({.text = std::string(name) + " = " + scene.text(std::abs(value), Measure::Force),
                          .role = Role::Reaction,
                          .target = tail,
                          .toward = -1.0 * d,
                          .rank = drawing::Rank::Extreme,
                          .weight = ui::Weight::Bold});
}

void draw_reaction_moment(const PlateScene& scene, Point at, double moment)
{
    drawing::draw(scene.sketch, drawing::CurvedArrow{.frame = {at, {1.0, 0.0}, {0.0, -1.0}},
                                                     .radius = moment_radius,
                                                     .sense = moment,
                                                     .role = Role::Reaction});
    if (!scene.shows(PlateShow::Values)) return;
    scene.sketch.caption({.text = "M = " + scene.text(std::abs(moment), Measure::Moment),
                          .role = Role::Reaction,
                          .target = at,
                          .gap = scene.sketch.px(moment_radius + 4.0),
                          .rank = drawing::Rank::Extreme,
                          .weight = ui::Weight::Bold});
}

std::string equation(const char* name, double loads, double reactions, double sum, const ui::DisplayUnits& units,
                     Measure measure)
{
    const auto number = [&](double v) { return ui::with_minus_signs(units.number(v, measure)); };
    const std::string sign = reactions < 0.0 ? " − " : " + ";
    return std::string(name) + " = " + number(loads) + sign + number(std::abs(reactions)) + " = " + number(sum) + " " +
           units.unit(measure).name;
}

} // namespace

ReactionTable reaction_table(const fp::PlaneCase& result, const ui::DisplayUnits& units, const ui::Catalogue& tr)
{
    const ReactionWords words(result, units);
    const fp::PlaneModel& model = result.structure().model();
    ReactionTable table;
    for (const fp::SupportResultant& one : fp::support_resultants(result)) {
        const std::string name = one.curve ? tr("Curve {id}", {{"id", model[*one.curve].id}})
                                           : tr("Point {id}", {{"id", model[*one.point].id}});
        table.supports.push_back(words.row(name, one.force.x(), one.force.y(), one.moment));
    }
    const femoop::Equilibrium sums = result.equilibrium();
    table.loads = words.row(tr("all loads"), sums.sum_loads);
    table.reactions = words.row(tr("all reactions"), sums.sum_reactions);
    table.sum = words.row(tr("their sum"), total(sums));
    return table;
}

std::vector<std::string> equilibrium_lines(const fp::PlaneCase& result, const ui::DisplayUnits& units)
{
    const femoop::Equilibrium sums = result.equilibrium();
    const femoop::NodeVector sum = total(sums);
    const ReactionSize size(result);
    std::vector<std::string> lines;
    const auto add = [&](const char* name, std::size_t i, Measure measure) {
        const auto rounded = [&](double v) {
            return measure == Measure::Moment ? size.of_moment(v) : size.of_force(v);
        };
        lines.push_back(equation(name, rounded(sums.sum_loads[i]), rounded(sums.sum_reactions[i]), rounded(sum[i]),
                                 units, measure));
    };
    if (!turns_about_axis(result)) add("ΣFx", 0, Measure::Force);
    add("ΣFy", 1, Measure::Force);
    if (!turns_about_axis(result)) add("ΣM", 5, Measure::Moment);
    return lines;
}

void draw_reactions(const PlateScene& scene)
{
    if (scene.result == nullptr) return;
    const ReactionSize size(*scene.result);
    for (const fp::SupportResultant& one : fp::support_resultants(*scene.result)) {
        const Point at = scene.place(one.at);
        const double fx = size.of_force(one.force.x()), fy = size.of_force(one.force.y());
        const double moment = size.of_moment(one.moment);
        if (fx != 0.0 && !turns_about_axis(*scene.result)) draw_component(scene, at, {1.0, 0.0}, fx, "Rx");
        if (fy != 0.0) draw_component(scene, at, {0.0, 1.0}, fy, "Ry");
        if (moment != 0.0 && !turns_about_axis(*scene.result)) draw_reaction_moment(scene, at, moment);
    }
}

} // namespace plane
