#include "apps/plane/view/plate_show.h"

#include <algorithm>
#include <cctype>

#include "ui/text/catalogue.h"

namespace plane {

namespace {

using femoop::plane::PlaneComponent;
using ui::translatable;

constexpr std::string_view contour_word = "contour:", bands_word = "bands:";
constexpr PlateShowSet of_results{PlateShow::Deformed, PlateShow::Principal, PlateShow::Trajectories,
                                  PlateShow::Vectors,  PlateShow::Error,     PlateShow::Reactions};
constexpr PlateShowSet plate_labels{PlateShow::Values, PlateShow::Names, PlateShow::Legend};

std::string in_small_letters(std::string_view word)
{
    std::string small(word);
    std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return small;
}

std::optional<PlateShown> field_shown(std::string_view component, FieldStyle style)
{
    for (const PlaneComponent known : shown_components())
        if (femoop::plane::name(known) == component)
            return PlateShown{.set = {}, .fields = {{.component = known, .style = style}}};
    return std::nullopt;
}

} // namespace

const std::vector<PlaneComponent>& shown_components()
{
    using enum PlaneComponent;
    static const std::vector<PlaneComponent> all{sx, sy, sz, txy, s1, s2, tmax, Mises, Tresca, ex, ey, ez, gxy, ux, uy};
    return all;
}

const std::vector<PlateShowWord>& plate_show_words()
{
    static const std::vector<PlateShowWord> words{
        {"geometry", {PlateShow::Geometry}, translatable("curves, vertices and divisions")},
        {"regions", {PlateShow::Regions}, translatable("regions, filled; faces left empty are hatched")},
        {"mesh", {PlateShow::Mesh}, translatable("the elements")},
        {"loads", {PlateShow::Loads}, translatable("the loads of the case")},
        {"supports", {PlateShow::Supports}, translatable("supports on points and along curves")},
        {"deformed", {PlateShow::Deformed}, translatable("deformed shape")},
        {"principal", {PlateShow::Principal}, translatable("crosses of principal stresses")},
        {"trajectories", {PlateShow::Trajectories}, translatable("stress trajectories, evenly spaced")},
        {"vectors", {PlateShow::Vectors}, translatable("displacements as arrows, evenly spaced")},
        {"error", {PlateShow::Error}, translatable("the estimated error of each element")},
        {"reactions", {PlateShow::Reactions}, translatable("resultants of the supports, and equilibrium in numbers")},
        {"values", {PlateShow::Values}, translatable("numbers beside loads and at extremes")},
        {"names", {PlateShow::Names}, translatable("names of points, curves and regions")},
        {"legend", {PlateShow::Legend}, translatable("title, case, scales, signs")},
        {"labels", plate_labels, translatable("values, names and legend together")},
    };
    return words;
}

bool PlateShown::needs_results() const { return !fields.empty() || set.meets(of_results); }
bool PlateShown::needs_mesh() const { return needs_results() || set.contains(PlateShow::Mesh); }

PlateShown plate_shown_by_default()
{
    return {.set = PlateShowSet{PlateShow::Geometry, PlateShow::Regions, PlateShow::Loads, PlateShow::Supports} |
                   plate_labels,
            .fields = {}};
}

std::optional<PlateShown> plate_shown(std::string_view word)
{
    const std::string small = in_small_letters(word);
    for (const PlateShowWord& known : plate_show_words())
        if (known.word == small) return PlateShown{.set = known.shows, .fields = {}};
    if (small.starts_with(contour_word)) return field_shown(small.substr(contour_word.size()), FieldStyle::Contours);
    if (small.starts_with(bands_word)) return field_shown(small.substr(bands_word.size()), FieldStyle::Bands);
    return std::nullopt;
}

std::vector<std::string> all_plate_words()
{
    std::vector<std::string> words;
    for (const PlateShowWord& known : plate_show_words()) words.emplace_back(known.word);
    for (const std::string_view style : {contour_word, bands_word})
        for (const PlaneComponent component : shown_components())
            words.push_back(std::string(style) + std::string(femoop::plane::name(component)));
    return words;
}

PlateShown operator|(PlateShown a, const PlateShown& b)
{
    a.set = a.set | b.set;
    for (const FieldShow& field : b.fields) {
        const auto same = std::ranges::find(a.fields, field.style, &FieldShow::style);
        if (same == a.fields.end()) a.fields.push_back(field);
        else *same = field; // the last one asked for
    }
    return a;
}

} // namespace plane
