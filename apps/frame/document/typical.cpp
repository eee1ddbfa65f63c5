#include "apps/frame/document/typical.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "apps/frame/document/drawing.h"
#include "apps/frame/document/loading.h"
#include "femoop/edit/insert.h"
#include "femoop/edit/member_line.h"
#include "femoop/model/quantity/in_units.h"
#include "femoop/typical/typical.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::Measure;
using ui::translatable;
using Numbers = std::span<const double>;

namespace {

constexpr TypicalNumber count(std::string_view id, std::string_view label, double start, double least, double most,
                              double step = 1.0)
{
    return {.id = id, .label = label, .start = start, .least = least, .most = most, .step = step};
}
constexpr TypicalNumber length(std::string_view id, std::string_view label, double start, double most)
{
    return {
        .id = id, .label = label, .measure = Measure::Length, .start = start, .least = 0.5, .most = most, .step = 0.5};
}
constexpr TypicalNumber line_load(std::string_view id, std::string_view label, double start)
{
    return {.id = id, .label = label, .measure = Measure::ForcePerLength, .start = start, .most = 100.0};
}
constexpr TypicalNumber force(std::string_view id, std::string_view label, double start)
{
    return {.id = id, .label = label, .measure = Measure::Force, .start = start, .most = 200.0};
}
constexpr TypicalNumber choice(std::string_view id, std::string_view label, double start,
                               std::span<const std::string_view> options)
{
    return {.id = id,
            .label = label,
            .start = start,
            .most = static_cast<double>(options.size()) - 1.0,
            .options = options};
}

constexpr std::array<std::string_view, 2> bases{translatable("Fixed"), translatable("Pinned")};
constexpr std::array<std::string_view, 3> arch_hinges{translatable("None"), translatable("Two"), translatable("Three")};

constexpr auto panels_of_truss = count("panels", translatable("Panels"), 6, 4, 40, 2);
constexpr auto span_of_girder = length("span", translatable("Span"), 18, 60);
constexpr auto height_of_girder = length("height", translatable("Height"), 3, 10);
constexpr auto load_of_girder = force("load", translatable("Load on each node"), 30);
constexpr auto load_on_beams = line_load("load", translatable("Load on the beams"), 20);

constexpr std::array beam_numbers{count("spans", translatable("Spans"), 3, 1, 20),
                                  length("span", translatable("Span"), 6, 20),
                                  line_load("load", translatable("Uniform load"), 20)};
constexpr std::array portal_numbers{length("bay", translatable("Bay"), 6, 20),
                                    length("storey", translatable("Height of a storey"), 4, 10), load_on_beams,
                                    force("wind", translatable("Wind on each floor"), 10),
                                    choice("base", translatable("Feet"), 0, bases)};
constexpr std::array storey_numbers{count("bays", translatable("Bays"), 2, 1, 20),
                                    count("storeys", translatable("Storeys"), 3, 1, 40),
                                    length("bay", translatable("Bay"), 6, 20),
                                    length("storey", translatable("Height of a storey"), 3, 10),
                                    load_on_beams,
                                    force("wind", translatable("Wind on each floor"), 10),
                                    choice("base", translatable("Feet"), 0, bases)};
constexpr std::array gable_numbers{
    length("span", translatable("Span"), 12, 40), length("column", translatable("Height of the columns"), 5, 15),
    length("rise", translatable("Rise"), 2, 10), line_load("snow", translatable("Snow"), 6),
    choice("base", translatable("Feet"), 1, bases)};
constexpr std::array vierendeel_numbers{count("panels", translatable("Panels"), 6, 2, 40), span_of_girder,
                                        height_of_girder, load_of_girder};
constexpr std::array truss_numbers{panels_of_truss, span_of_girder, height_of_girder, load_of_girder};
constexpr std::array warren_numbers{count("panels", translatable("Panels"), 6, 2, 40), span_of_girder, height_of_girder,
                                    load_of_girder};
constexpr std::array arch_numbers{
    count("chords", translatable("Chords"), 12, 2, 200, 2), length("span", translatable("Span"), 20, 100),
    length("rise", translatable("Rise"), 5, 40), line_load("load", translatable("Load per horizontal length"), 10),
    choice("hinges", translatable("Hinges"), 1, arch_hinges)};
constexpr std::array grillage_numbers{count("panels_x", translatable("Panels along x"), 4, 2, 40),
                                      count("panels_y", translatable("Panels along y"), 3, 2, 40),
                                      length("panel_x", translatable("Panel along x"), 2, 10),
                                      length("panel_y", translatable("Panel along y"), 2.5, 10),
                                      force("load", translatable("Load on each node"), 20)};
constexpr std::array space_numbers{
    count("panels_x", translatable("Panels along x"), 4, 1, 30),
    count("panels_y", translatable("Panels along y"), 3, 1, 30), length("panel", translatable("Panel"), 3, 10),
    length("height", translatable("Height"), 2, 10), force("load", translatable("Load on each node"), 10)};

constexpr std::array space_frame_numbers{count("bays_x", translatable("Bays along x"), 2, 1, 10),
                                         count("bays_y", translatable("Bays along y"), 1, 1, 10),
                                         count("storeys", translatable("Storeys"), 2, 1, 20),
                                         length("bay_x", translatable("Bay along x"), 6, 20),
                                         length("bay_y", translatable("Bay along y"), 5, 20),
                                         length("storey", translatable("Height of a storey"), 3, 10),
                                         line_load("load", translatable("Load on the beams"), 15),
                                         force("wind", translatable("Wind on each joint"), 8),
                                         choice("base", translatable("Feet"), 0, bases)};
constexpr std::array tower_numbers{
    count("levels", translatable("Levels"), 4, 1, 30),         length("height", translatable("Height"), 20, 100),
    length("foot", translatable("Side on the ground"), 6, 30), length("top", translatable("Side of the top"), 2, 30),
    force("wind", translatable("Wind on each joint"), 10),     force("load", translatable("Load on each node"), 20)};

int whole(double number) { return static_cast<int>(std::lround(number)); }

Base base_of(double number) { return static_cast<Base>(whole(number)); }

template <TrussPattern pattern> Model truss(Numbers v)
{
    return PlaneTruss{.pattern = pattern, .panels = whole(v[0]), .span = v[1], .height = v[2], .load = v[3]}.model();
}

Model continuous_beam(Numbers v) { return ContinuousBeam{.spans = whole(v[0]), .span = v[1], .load = v[2]}.model(); }
Model portal(Numbers v)
{
    return StoreyFrame{
        .bays = 1, .storeys = 1, .bay = v[0], .storey = v[1], .load = v[2], .wind = v[3], .base = base_of(v[4])}
        .model();
}
Model storey_frame(Numbers v)
{
    return StoreyFrame{.bays = whole(v[0]),
                       .storeys = whole(v[1]),
                       .bay = v[2],
                       .storey = v[3],
                       .load = v[4],
                       .wind = v[5],
                       .base = base_of(v[6])}
        .model();
}
Model gable(Numbers v)
{
    return GableFrame{.span = v[0], .column = v[1], .rise = v[2], .snow = v[3], .base = base_of(v[4])}.model();
}
Model vierendeel(Numbers v)
{
    return VierendeelGirder{.panels = whole(v[0]), .span = v[1], .height = v[2], .load = v[3]}.model();
}
Model arch(Numbers v)
{
    const auto hinges = static_cast<ArchHinges>(whole(v[4]));
    Model model = Arch{.chords = whole(v[0]), .span = v[1], .rise = v[2], .load = v[3], .hinges = hinges}.model();
    model.title = translatable("Parabolic arch"); // the others are called what their tile is
    return model;
}
Model grillage(Numbers v)
{
    return GrillageFloor{
        .panels_x = whole(v[0]), .panels_y = whole(v[1]), .panel_x = v[2], .panel_y = v[3], .load = v[4]}
        .model();
}
Model space_truss(Numbers v)
{
    return SpaceTruss{.panels_x = whole(v[0]), .panels_y = whole(v[1]), .panel = v[2], .height = v[3], .load = v[4]}
        .model();
}

Model space_frame(Numbers v)
{
    return SpaceFrame{.bays_x = whole(v[0]),
                      .bays_y = whole(v[1]),
                      .storeys = whole(v[2]),
                      .bay_x = v[3],
                      .bay_y = v[4],
                      .storey = v[5],
                      .load = v[6],
                      .wind = v[7],
                      .base = base_of(v[8])}
        .model();
}
Model tower(Numbers v)
{
    return Tower{.levels = whole(v[0]), .height = v[1], .foot = v[2], .top = v[3], .wind = v[4], .load = v[5]}.model();
}

constexpr std::array structures{
    TypicalStructure{"beam", translatable("Continuous beam"), beam_numbers, continuous_beam},
    TypicalStructure{"portal", translatable("Portal frame"), portal_numbers, portal},
    TypicalStructure{"storeys", translatable("Multi-storey frame"), storey_numbers, storey_frame},
    TypicalStructure{"gable", translatable("Gable frame"), gable_numbers, gable},
    TypicalStructure{"vierendeel", translatable("Vierendeel girder"), vierendeel_numbers, vierendeel},
    TypicalStructure{"pratt", translatable("Pratt truss"), truss_numbers, truss<TrussPattern::Pratt>},
    TypicalStructure{"howe", translatable("Howe truss"), truss_numbers, truss<TrussPattern::Howe>},
    TypicalStructure{"warren", translatable("Warren truss"), warren_numbers, truss<TrussPattern::Warren>},
    TypicalStructure{"k", translatable("K-truss"), truss_numbers, truss<TrussPattern::K>},
    TypicalStructure{"arch", translatable("Arch"), arch_numbers, arch},
    TypicalStructure{"grillage", translatable("Grillage"), grillage_numbers, grillage},
    TypicalStructure{"space_truss", translatable("Space truss"), space_numbers, space_truss},
    TypicalStructure{"space_frame", translatable("Space frame"), space_frame_numbers, space_frame},
    TypicalStructure{"tower", translatable("Tower"), tower_numbers, tower},
};

std::string text_of(double whole_number) { return std::to_string(whole(whole_number)); }

/// The least corner of the box around a structure, and its right side.
struct Extent {
    double left = std::numeric_limits<double>::infinity(), bottom = left, right = -left;

    explicit Extent(const Model& model)
    {
        for (std::size_t i = 0; i < model.nodes.size(); ++i) {
            const Eigen::Vector3d place = position_of(model, NodeId(i));
            left = std::min(left, place.x());
            right = std::max(right, place.x());
            bottom = std::min(bottom, is_3d(model.analysis) ? place.z() : place.y());
        }
    }
};

} // namespace

std::span<const TypicalStructure> typical_structures() { return structures; }

std::vector<double> first_numbers(const TypicalStructure& structure)
{
    std::vector<double> numbers;
    for (const TypicalNumber& number : structure.numbers) numbers.push_back(number.start);
    return numbers;
}

std::optional<ui::Message> why_not(const TypicalNumber& number, double value)
{
    constexpr double most_length = 1e4, most_load = 1e6; // m, kN: nobody means more
    const ui::Message::Argument least{"least", text_of(number.least)}, most{"most", text_of(number.most)};
    const bool is_on_step = std::fmod(std::round(value) - number.least, number.step) == 0.0;
    const bool is_count = value == std::round(value) && value >= number.least && value <= number.most;
    if (number.is_count() && number.step == 2.0 && !(is_count && is_on_step))
        return ui::Message(translatable("wanted an even number from {least} to {most}"), {least, most});
    if (number.is_count() && !is_count)
        return ui::Message(translatable("wanted a whole number from {least} to {most}"), {least, most});
    if (number.measure == Measure::Length && !(value > 0.0 && value <= most_length))
        return ui::Message(translatable("wanted a positive length up to 10 km"));
    if (!(std::abs(value) <= most_load)) return ui::Message(translatable("wanted a load of a sensible size"));
    return std::nullopt;
}

void insert_beside(Document& document, const Model& structure, const Neighbour& neighbour)
{
    Document next = document;
    Model added = in_units(structure, document.model.units);
    const LoadCasePlace place = load_case_for(next, neighbour.load_case);
    const LoadCase& load_case = next.model.load_cases[place.load_case];
    added.load_cases.at(0).id = load_case.id;
    added.load_cases[0].self_weight = load_case.self_weight;
    const Extent there(document.model), here(added);
    Eigen::Vector3d shift(there.right + neighbour.distance - here.left, 0.0, 0.0);
    shift[is_3d(added.analysis) ? 2 : 1] = there.bottom - here.bottom;
    insert(next.model, added, moved_by(shift));
    join(next, document.model);
    document = std::move(next);
}

void put_in_place(Document& document, const Model& structure)
{
    Model next = in_units(structure, document.model.units);
    next.notes = document.model.notes;
    document.model = std::move(next);
    document.companion.dimensions.clear();
    document.companion.views.clear();
}

} // namespace frame
