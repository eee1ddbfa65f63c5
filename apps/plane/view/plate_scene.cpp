#include "apps/plane/view/plate_scene.h"

#include <algorithm>
#include <cmath>

#include "apps/plane/view/load_marks.h"

namespace plane {

namespace {

std::string state_name(femoop::StressState state, const ui::Catalogue& tr)
{
    switch (state) {
    case femoop::StressState::PlaneStress: return tr("plane stress");
    case femoop::StressState::PlaneStrain: return tr("plane strain");
    case femoop::StressState::Axisymmetric: return tr("axisymmetric");
    case femoop::StressState::Solid: break;
    }
    return {};
}

std::string case_text(const femoop::plane::PlaneModel& model, const PlateOptions& options)
{
    if (options.load_case.index >= model.n_cases()) return {};
    const std::string& name = model.case_name(options.load_case);
    const bool is_load_case = options.load_case.index < model.load_cases.size();
    return is_load_case ? options.tr("load case {case}", {{"case", name}})
                        : options.tr("combination {case}", {{"case", name}});
}

} // namespace

void PlateScene::shade_faces() const
{
    for (const OutlinedFace& face : outline.faces)
        if (!face.loops.empty()) sketch.shade(on_sheet(face.loops.front()));
}

std::vector<ui::Point> PlateScene::on_sheet(const PlaceLine& line) const
{
    std::vector<ui::Point> points;
    points.reserve(line.size());
    for (const Eigen::Vector2d& at : line) points.push_back(place(at));
    return points;
}

bool PlateScene::is_colored() const
{
    if (result == nullptr) return false;
    return shows(PlateShow::Error) ||
           std::ranges::find(options.show.fields, FieldStyle::Bands, &FieldShow::style) != options.show.fields.end();
}

std::string PlateScene::text(double value, ui::Measure measure) const
{
    return ui::with_minus_signs(units.text(value, measure));
}

std::string PlateScene::number(double value) const
{
    return ui::with_minus_signs(ui::number_text(value, options.numbers));
}

const femoop::plane::PlaneModel* mesh_of(const PlateInput& input)
{
    if (input.results != nullptr) return &input.results->model();
    if (input.mesh != nullptr) return input.mesh;
    return input.model.is_drawn ? nullptr : &input.model;
}

ui::DisplayUnits display_units(const femoop::plane::PlaneModel& model, const PlateOptions& options)
{
    const femoop::Units& units = model.units;
    const ui::BaseUnits base{.length = std::string(femoop::name(units.length)),
                             .metres = femoop::metres(units.length),
                             .force = std::string(femoop::name(units.force)),
                             .newtons = femoop::newtons(units.force)};
    return {options.units.value_or(ui::UnitSystem::File), base, options.numbers, options.unit_choices};
}

std::string state_and_case(const femoop::plane::PlaneModel& model, const PlateOptions& options)
{
    std::string line = state_name(model.analysis, options.tr);
    for (const std::string& part : {case_text(model, options), self_weight_text(model, options),
                                    options.tr("units {units}", {{"units", display_units(model, options).summary()}})})
        if (!part.empty()) line += "  ·  " + part;
    return line;
}

const femoop::plane::NaturalMode* shown_mode(const PlateInput& input, const PlateOptions& options)
{
    if (input.modes == nullptr || options.mode >= input.modes->modes.size()) return nullptr;
    return &input.modes->modes[options.mode];
}

ModeTexts mode_texts(const femoop::plane::NaturalModes& modes, std::size_t i, const ui::NumberFormat& numbers)
{
    const femoop::plane::NaturalMode& mode = modes.modes[i];
    const auto share = [&](double mass) {
        constexpr double tenths = 10.0;
        return ui::number_text(std::round(100.0 * tenths * mass / modes.total_mass) / tenths, numbers) + " %";
    };
    return {.frequency = ui::number_text(mode.frequency(), numbers) + " Hz",
            .period = mode.omega > 0.0 ? ui::number_text(1.0 / mode.frequency(), numbers) + " s" : "∞",
            .shares = {share(mode.effective_mass.x()), share(mode.effective_mass.y())}};
}

std::string state_and_mode(const PlateInput& input, const PlateOptions& options)
{
    const ModeTexts texts = mode_texts(*input.modes, options.mode, options.numbers);
    const std::string mode = options.tr("mode {n}: {frequency}, period {period}, {x} of the mass along x, {y} along y",
                                        {{"n", std::to_string(options.mode + 1)},
                                         {"frequency", texts.frequency},
                                         {"period", texts.period},
                                         {"x", texts.shares[0]},
                                         {"y", texts.shares[1]}});
    return state_name(input.model.analysis, options.tr) + "  ·  " + mode + "  ·  " +
           options.tr("units {units}", {{"units", display_units(input.model, options).summary()}});
}

PlateOutline outline_of(const PlateInput& input, double tolerance)
{
    if (input.drawing != nullptr) return outline_of(*input.drawing, tolerance);
    return outline_of(input.model, tolerance);
}

} // namespace plane
