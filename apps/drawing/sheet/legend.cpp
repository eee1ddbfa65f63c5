#include "apps/drawing/sheet/legend.h"

#include "apps/drawing/results/envelope_band.h"
#include "apps/drawing/results/envelope_cases.h"
#include "apps/drawing/results/line_diagram.h"
#include "apps/drawing/results/moving_words.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/load/case_terms.h"
#include "ui/paint/wrapped_lines.h"
#include "ui/text/shortened.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

using femoop::MemberComponent;

constexpr double border = 16.0;
constexpr std::size_t longest_title = 200; // letters

std::string terms_text(const femoop::Model& model, const femoop::Combination& combination,
                       const ui::NumberFormat& format)
{
    std::string text;
    for (const auto& term : combination.terms) {
        const double size = std::abs(term.factor);
        if (!text.empty()) text += term.factor < 0.0 ? " − " : " + ";
        else if (term.factor < 0.0) text += "−";
        if (size != 1.0) text += ui::number_text(size, format) + " ";
        text += model.case_name(term.of);
    }
    return text;
}

std::string case_text(const femoop::Model& model, const DrawOptions& options)
{
    if (options.is_envelope) return envelope_text(model, options);
    const std::size_t index = options.load_case.index;
    if (index >= model.n_cases()) return {};
    const std::string& name = model.case_name(options.load_case);
    if (index < model.load_cases.size()) return options.tr("load case {case}", {{"case", name}});
    const auto& combination = model.combinations[index - model.load_cases.size()];
    return options.tr("combination {case} = {terms}",
                      {{"case", name}, {"terms", terms_text(model, combination, options.numbers)}});
}

std::string self_weight_text(const femoop::Model& model, const DrawOptions& options)
{
    if (options.is_envelope) return {};
    double factor = 0.0;
    for (const auto& [load_case, share] : femoop::terms_of(model, options.load_case).terms)
        factor += share * model.load_cases[load_case].self_weight;
    if (factor == 0.0) return {};
    if (factor == 1.0) return options.tr("with self-weight");
    return options.tr("with {factor} × self-weight", {{"factor", ui::number_text(factor, options.numbers)}});
}

std::string units_text(const femoop::Model& model, const DrawOptions& options)
{
    return options.tr("units {units}", {{"units", display_units(model, options).summary()}});
}

std::string indeterminacy_text(const femoop::Results& results, const ui::Catalogue& tr)
{
    const femoop::Indeterminacy& degree = results.indeterminacy();
    if (degree.has_foundation) return tr("on an elastic foundation");
    if (degree.total() == 0) return tr("statically determinate");
    const std::string total = std::to_string(degree.total());
    if (degree.internal < 0) return tr("statically indeterminate, degree {total}", {{"total", total}});
    return tr("statically indeterminate, degree {total} (external {external}, internal {internal})",
              {{"total", total},
               {"external", std::to_string(degree.external)},
               {"internal", std::to_string(degree.internal)}});
}

void join(std::string& line, const std::string& part)
{
    if (part.empty()) return;
    line += (line.empty() ? "" : "  ·  ") + part;
}

std::string diagram_name(const Scene& scene, MemberComponent component)
{
    const ui::Catalogue& tr = scene.options.tr;
    switch (component) {
    case MemberComponent::N: return tr("axial force");
    case MemberComponent::Vy:
    case MemberComponent::Vz: return tr("shear force");
    case MemberComponent::T: return tr("torsional moment");
    default: return tr("bending moment");
    }
}

/// What the faint dashes behind the diagrams are; an envelope has none.
std::string comparison_text(const DrawInput& input, const DrawOptions& options)
{
    const ReferenceResults* const reference = input.reference;
    if (options.is_envelope || reference == nullptr || !reference->counterpart(input.model, options.load_case))
        return {};
    return options.tr("dashes: {name}",
                      {{"name", reference->name.empty() ? options.tr("the results that were kept") : reference->name}});
}

std::string sign_note(const Scene& scene, MemberComponent component)
{
    const ui::Catalogue& tr = scene.options.tr;
    if (is_moment(component))
        return scene.options.moment_side == MomentSide::Tension ? tr("drawn on the tension side")
                                                                : tr("drawn on the compression side");
    if (component == MemberComponent::Vy || component == MemberComponent::Vz)
        return scene.is_flat() ? tr("positive where it turns the piece clockwise") : std::string();
    if (component != MemberComponent::N) return {};
    return femoop::is_truss(scene.model.analysis) ? tr("(T) tension, (C) compression") : tr("tension positive");
}

struct BarScale {
    double pixels_per_unit;
    double longest = 60.0; ///< [px]
};

// A round number whose bar is not much shorter than the longest.
void add_bar(PanelHead& head, const Scene& scene, const BarScale& scale, const ui::DisplayUnit& unit)
{
    const double shown = round_below(scale.longest / scale.pixels_per_unit * unit.factor);
    head.bar = shown / unit.factor * scale.pixels_per_unit;
    head.bar_text = ui::number_text(shown, scene.options.numbers) + (unit.name.empty() ? "" : " ") + unit.name;
}

// "20 ft, 40 ft and 3 more": of several places the head has room for two.
std::string some_places(const Scene& scene, const femoop::influence::LineExtreme& extreme)
{
    constexpr std::size_t most = 2;
    const std::vector<std::string> all = places_text(scene.options, scene.units, extreme);
    std::string text = all.front();
    for (std::size_t i = 1; i < std::min(most, all.size()); ++i) text += ", " + all[i];
    if (all.size() <= most) return text;
    return text + " " + scene.options.tr("and {count} more", {{"count", std::to_string(all.size() - most)}});
}

std::string extremes_text(const Scene& scene, const femoop::influence::PiecewiseLine& line, const OrdinateUnit& unit)
{
    std::string text;
    const auto add = [&](std::string_view which, const femoop::influence::LineExtreme& extreme) {
        join(text, scene.options.tr("{which} {value} at s = {place}",
                                    {{"which", which},
                                     {"value", ordinate_text(scene.units, unit, extreme.value)},
                                     {"place", some_places(scene, extreme)}}));
    };
    const femoop::influence::LineExtreme max = line.max(), min = line.min();
    const double rounding = written_as_zero * line.largest();
    if (max.value > rounding) add(scene.options.tr("max"), max);
    if (min.value < -rounding) add(scene.options.tr("min"), min);
    return text;
}

std::string capitalized(std::string text)
{
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

/// What stands on the path of an influence line is no case of the model; its name begins as it is written.
std::string load_text(const DrawInput& input, const DrawOptions& options)
{
    if (input.influence == nullptr || options.load_case.index >= input.model.n_cases())
        return capitalized(case_text(input.model, options));
    return options.tr("{load} on the path", {{"load", input.model.case_name(options.load_case)}});
}

} // namespace

SheetHead sheet_head(const DrawInput& input, const DrawOptions& options)
{
    const femoop::Model& model = input.model;
    SheetHead head{.title = ui::shortened(model.title, longest_title), .line = {}};
    const auto add = [&](const std::string& part) { join(head.line, head.line.empty() ? capitalized(part) : part); };
    if (input.influence == nullptr || input.results != nullptr) {
        const bool is_of_trains = options.is_envelope && input.envelope != nullptr;
        join(head.line, is_of_trains ? input.envelope->title : load_text(input, options));
        add(self_weight_text(model, options));
    }
    if (input.results && !model.members.empty()) add(indeterminacy_text(*input.results, options.tr));
    if (input.results) add(comparison_text(input, options));
    add(units_text(model, options));
    return head;
}

namespace {

ui::TextStyle title_style(const ui::Theme& theme)
{
    ui::TextStyle style = theme.text(ui::Role::Label, ui::Anchor::TopLeft);
    style.weight = ui::Weight::Bold;
    style.size = theme.type().large;
    return style;
}

ui::TextStyle line_style(const ui::Theme& theme)
{
    ui::TextStyle style = theme.text(ui::Role::FaintLabel, ui::Anchor::TopLeft);
    style.size = theme.type().small;
    return style;
}

constexpr double title_spacing = 1.45, line_spacing = 1.5; // of the type's size

} // namespace

double head_height(const SheetHead& head, const ui::Theme& theme, const ui::Fonts& fonts, double width)
{
    const auto height = [&](const std::string& text, const ui::TextStyle& style, double spacing) {
        const auto n_lines = ui::wrapped_lines(fonts, text, style, width - 2.0 * border).size();
        return spacing * style.size * static_cast<double>(n_lines);
    };
    return 12.0 + height(head.title, title_style(theme), title_spacing) +
           height(head.line, line_style(theme), line_spacing);
}

void draw_head(ui::Painter& painter, const SheetHead& head, const ui::Theme& theme)
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    double y = 12.0;
    const auto write = [&](const std::string& text, const ui::TextStyle& style, double spacing) {
        for (const std::string& line :
             ui::wrapped_lines(painter.fonts(), text, style, painter.size().width - 2.0 * border)) {
            painter.text({border, y}, line, style);
            y += spacing * style.size;
        }
    };
    write(head.title, title_style(theme), title_spacing);
    write(head.line, line_style(theme), line_spacing);
}

PanelHead diagram_head(const Scene& scene, const std::vector<Diagram>& diagrams)
{
    const Diagram& first = diagrams.front();
    PanelHead head{.role = role_of(first.component)};
    std::string symbols;
    for (const Diagram& diagram : diagrams)
        symbols += (symbols.empty() ? "" : ", ") + std::string(femoop::name(diagram.component, scene.model.analysis));
    const ui::DisplayUnit unit = scene.units.unit(measure_of(first.component));
    head.name = capitalized(diagram_name(scene, first.component)) + " " + symbols +
                (unit.name.empty() ? "" : " [" + unit.name + "]");
    head.note = first.largest > 0.0 ? sign_note(scene, first.component) : scene.options.tr("zero everywhere");
    const bool is_truss_force = femoop::is_truss(scene.model.analysis) && first.component == MemberComponent::N;
    if (first.is_zero() || is_truss_force) return head;
    add_bar(head, scene, {first.pixels_per_unit}, unit);
    return head;
}

PanelHead influence_head(const Scene& scene, const InfluencePicture& picture, const InfluenceScale& scale)
{
    const ui::Catalogue& tr = scene.options.tr;
    const OrdinateUnit unit = ordinate_unit(scene.units, picture);
    PanelHead head{.role = role_of(picture.line.effect)};
    head.name = tr("Influence line of {effect}",
                   {{"effect", effect_text(scene.model, scene.units, picture.line.effect)}}) +
                (unit.name.empty() ? "" : " [" + unit.name + "]");
    if (!(scale.largest > 0.0)) head.note = tr("zero everywhere");
    if (!(scale.largest > 0.0)) return head;
    if (is_concealed(picture)) return head;
    add_bar(head, scene, {scale.pixels_per_unit}, {unit.name, unit.factor});
    if (picture.traced) return head;
    head.note = extremes_text(scene, picture.line.ordinates, unit);
    join(head.note, areas_text(scene.units, picture, tr));
    return head;
}

PanelHead deformed_head(const Scene& scene, double scale)
{
    const ui::Catalogue& tr = scene.options.tr;
    return {.name = capitalized(tr("deformed shape")),
            .note = tr("displacements × {scale}", {{"scale", ui::number_text(scale, scene.options.numbers)}}),
            .role = ui::Role::Deformed};
}

PanelHead thrust_head(const Scene& scene, const std::optional<LargestEccentricity>& largest)
{
    constexpr double nothing = 1e-9; // of the structure's size: what rounding leaves
    const ui::Catalogue& tr = scene.options.tr;
    PanelHead head{.name = tr("Line of thrust"), .note = tr("no axial forces"), .role = ui::Role::Reaction};
    if (!largest) return head;
    head.note = tr("on the axis: no section is bent");
    if (largest->value > nothing * scene.shape.size)
        head.note = tr(
            "e = −M/N from the axis; at most {e} in {member}",
            {{"e", scene.text(largest->value, ui::Measure::Length)}, {"member", scene.model[largest->member].id}});
    return head;
}

PanelHead force_diagram_head(const Scene& scene, const std::string& name, double pixels_per_unit)
{
    const ui::DisplayUnit unit = scene.units.unit(ui::Measure::Force);
    PanelHead head{.name = name + " [" + unit.name + "]", .note = {}};
    if (pixels_per_unit > 0.0) add_bar(head, scene, {.pixels_per_unit = pixels_per_unit, .longest = 90.0}, unit);
    return head;
}

PanelHead structure_head(const Scene& scene)
{
    const bool loads = scene.shows(Show::Loads);
    const bool reactions = scene.shows(Show::Reactions);
    const ui::Catalogue& tr = scene.options.tr;
    if (loads && reactions) return {.name = tr("Loads and reactions"), .note = {}};
    if (reactions) return {.name = tr("Reactions"), .note = {}};
    return {.name = loads ? tr("Loads") : tr("Structure"), .note = {}};
}

} // namespace drawing
