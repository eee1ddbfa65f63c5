// Beams and frames that bend.
#include <vector>

#include "femoop/typical/sketch.h"
#include "femoop/typical/typical.h"

namespace femoop {

namespace {

SupportKind support_of(Base base) { return base == Base::Fixed ? SupportKind::Fixed : SupportKind::Pin; }

} // namespace

Model ContinuousBeam::model() const
{
    require_within("spans", spans, 1, 20);
    require_positive("span", span);
    Sketch sketch("Continuous beam", AnalysisKind::Frame2d);
    NodeId last = sketch.node(letter_name(0), 0, 0);
    sketch.support(last, SupportKind::Pin);
    for (int i = 1; i <= spans; ++i) {
        const NodeId next = sketch.node(letter_name(i), i * span, 0);
        sketch.support(next, SupportKind::Roller);
        sketch.load(sketch.member(last, next), -load);
        last = next;
    }
    return std::move(sketch).model();
}

Model StoreyFrame::model() const
{
    require_within("bays", bays, 1, 20);
    require_within("storeys", storeys, 1, 40);
    require_positive("bay", bay);
    require_positive("storey", storey);
    const bool is_portal = bays == 1 && storeys == 1;
    Sketch sketch(is_portal ? "Portal frame" : "Multi-storey frame", AnalysisKind::Frame2d);
    std::vector<NodeId> below;
    for (int i = 0; i <= bays; ++i) {
        below.push_back(sketch.node(letter_name(i) + "0", i * bay, 0));
        sketch.support(below.back(), support_of(base));
    }
    for (int level = 1; level <= storeys; ++level) {
        std::vector<NodeId> floor;
        for (int i = 0; i <= bays; ++i) {
            const auto column = static_cast<std::size_t>(i);
            floor.push_back(sketch.node(letter_name(i) + std::to_string(level), i * bay, level * storey));
            sketch.member(below[column], floor[column]);
            if (i > 0) sketch.load(sketch.member(floor[column - 1], floor[column]), -load);
        }
        sketch.load(floor.front(), Dof::ux, wind);
        below = std::move(floor);
    }
    return std::move(sketch).model();
}

Model GableFrame::model() const
{
    require_positive("span", span);
    require_positive("column", column);
    require_within("rise", rise, 0.0, 1e6);
    Sketch sketch("Gable frame", AnalysisKind::Frame2d);
    const NodeId a = sketch.node("A", 0, 0), b = sketch.node("B", 0, column),
                 c = sketch.node("C", 0.5 * span, column + rise), d = sketch.node("D", span, column),
                 e = sketch.node("E", span, 0);
    for (const NodeId foot : {a, e}) sketch.support(foot, support_of(base));
    sketch.member(a, b);
    sketch.load(sketch.member(b, c), -snow, true);
    sketch.load(sketch.member(c, d), -snow, true);
    sketch.member(d, e);
    return std::move(sketch).model();
}

Model VierendeelGirder::model() const
{
    require_within("panels", panels, 2, 40);
    require_positive("span", span);
    require_positive("height", height);
    Sketch sketch("Vierendeel girder", AnalysisKind::Frame2d);
    std::vector<NodeId> lower, upper;
    for (int i = 0; i <= panels; ++i) {
        const double x = span * i / panels;
        lower.push_back(sketch.node("L" + std::to_string(i), x, 0));
        upper.push_back(sketch.node("U" + std::to_string(i), x, height));
        sketch.member(lower.back(), upper.back());
        if (i > 0 && i < panels) sketch.load(lower.back(), Dof::uy, -load);
    }
    for (std::size_t i = 1; i < lower.size(); ++i) {
        sketch.member(lower[i - 1], lower[i]);
        sketch.member(upper[i - 1], upper[i]);
    }
    sketch.support(lower.front(), SupportKind::Pin);
    sketch.support(lower.back(), SupportKind::Roller);
    return std::move(sketch).model();
}

Model Arch::model() const
{
    require_within("chords", chords, 2, 200);
    if (chords % 2 != 0) throw std::invalid_argument("chords: an odd number has no crown; wanted an even one");
    require_positive("span", span);
    require_positive("rise", rise);
    Sketch sketch("Parabolic arch", AnalysisKind::Frame2d);
    std::vector<NodeId> nodes;
    for (int i = 0; i <= chords; ++i) {
        const double x = span * i / chords;
        nodes.push_back(sketch.node(std::to_string(i), x, 4.0 * rise * x * (span - x) / (span * span)));
    }
    for (std::size_t i = 1; i < nodes.size(); ++i) sketch.load(sketch.member(nodes[i - 1], nodes[i]), -load, true);
    for (const NodeId springing : {nodes.front(), nodes.back()})
        sketch.support(springing, hinges == ArchHinges::None ? SupportKind::Fixed : SupportKind::Pin);
    if (hinges == ArchHinges::Three) sketch.hinge(nodes[nodes.size() / 2]);
    return std::move(sketch).model();
}

Model GrillageFloor::model() const
{
    require_within("panels_x", panels_x, 2, 40);
    require_within("panels_y", panels_y, 2, 40);
    require_positive("panel_x", panel_x);
    require_positive("panel_y", panel_y);
    Sketch sketch("Grillage", AnalysisKind::Grillage);
    std::vector<NodeId> before;
    for (int j = 0; j <= panels_y; ++j) {
        std::vector<NodeId> row;
        for (int i = 0; i <= panels_x; ++i) {
            const auto at = static_cast<std::size_t>(i);
            row.push_back(sketch.node(letter_name(i) + std::to_string(j + 1), i * panel_x, j * panel_y));
            const bool is_edge = i == 0 || i == panels_x || j == 0 || j == panels_y;
            if (is_edge) sketch.support(row[at], SupportKind::Pin);
            else sketch.load(row[at], Dof::uz, -load);
            if (i > 0) sketch.member(row[at - 1], row[at]);
            if (j > 0) sketch.member(before[at], row[at]);
        }
        before = std::move(row);
    }
    return std::move(sketch).model();
}

} // namespace femoop
