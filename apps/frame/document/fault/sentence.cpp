#include "apps/frame/document/fault/sentence.h"

#include <algorithm>
#include <optional>

#include "apps/frame/document/fault/field.h"
#include "apps/frame/document/fault/place.h"
#include "femoop/model/dof.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/result/structure_words.h"
#include "ui/text/arithmetic.h"
#include "ui/text/language_manner.h"
#include "ui/text/number_format.h"

namespace frame {

using femoop::Fault;
using femoop::FaultKind;
using ui::Catalogue;
using ui::translatable;

namespace {

std::string name_in(const FaultPlace::Step& step)
{
    if (!step.name.empty() || !step.index) return step.name;
    return "#" + std::to_string(*step.index + 1);
}

std::string load_text(const FaultPlace& place, const Catalogue& tr)
{
    const std::string load_case = name_in(place.steps[0]), bearer = name_in(place.steps[1]);
    const std::initializer_list<Catalogue::Argument> names{{"case", load_case}, {"id", bearer}};
    if (place.steps[1].key == "nodes") return tr("Case {case}, load on node {id}", names);
    if (place.steps[1].key == "settlements") return tr("Case {case}, settlement of node {id}", names);
    return tr("Case {case}, load on member {id}", names);
}

std::string entry_text(const FaultPlace::Step& step, const Catalogue& tr)
{
    const std::string name = name_in(step);
    if (step.key == "materials") return tr("Material {id}", {{"id", name}});
    if (step.key == "sections") return tr("Section {id}", {{"id", name}});
    if (step.key == "nodes") return tr("Node {id}", {{"id", name}});
    if (step.key == "members") return tr("Member {id}", {{"id", name}});
    if (step.key == "load_cases") return tr("Case {case}", {{"case", name}});
    if (step.key == "combinations") return tr("Combination {id}", {{"id", name}});
    if (step.key == "expected") return tr("Expected result {number}", {{"number", name}});
    return step.index ? step.key + " " + name : step.key;
}

/// A key within an entry: "Depth h"; what the file calls it, where no field has it.
std::string key_text(const FaultPlace::Step& step, const std::string& list, const Catalogue& tr)
{
    static constexpr std::string_view axes[] = {"x", "y", "z"};
    if (list == "nodes" && step.key == "at" && step.index && *step.index < 3) return std::string(axes[*step.index]);
    const std::string label = tr(label_of({list, {}, step.key}));
    return step.index ? label + " " + std::to_string(*step.index + 1) : label;
}

std::string place_text(const FaultPlace& place, const Catalogue& tr)
{
    const bool is_load = place.is_load();
    std::string words = is_load ? load_text(place, tr) : entry_text(place.steps.front(), tr);
    const std::string list = is_load ? "loads" : place.steps.front().key;
    for (std::size_t i = is_load ? 2 : 1; i < place.steps.size(); ++i)
        words += ", " + key_text(place.steps[i], list, tr);
    return words;
}

/// "plane frame" for frame2d.
std::optional<std::string> kind_named(const std::string& text, const Catalogue& tr)
{
    using enum femoop::AnalysisKind;
    for (const femoop::AnalysisKind kind : {Truss2d, Frame2d, Grillage, Truss3d, Frame3d})
        if (text == name(kind)) return femoop::kind_text(kind, [&](std::string_view words) { return tr(words); });
    return std::nullopt;
}

bool names_an_end(FaultKind kind, std::size_t argument)
{
    switch (kind) {
    case FaultKind::OffsetSize:
    case FaultKind::TrussOffsetAcross: return argument == 1;
    case FaultKind::ReleaseDofLacking:
    case FaultKind::EndSpringDofLacking:
    case FaultKind::ReleaseAndSpring:
    case FaultKind::HingeAndSpring: return argument == 2;
    default: return false;
    }
}

bool names_a_kind(FaultKind kind, std::size_t argument)
{
    switch (kind) {
    case FaultKind::CrossNeedsPlaneFrame: return argument == 0;
    case FaultKind::RollerNotPlane:
    case FaultKind::AngleNotPlane:
    case FaultKind::UpNot3d: return argument == 1;
    case FaultKind::FixedDofLacking:
    case FaultKind::SpringDofLacking:
    case FaultKind::MassDofLacking:
    case FaultKind::MissingProperty:
    case FaultKind::ExpectedDofLacking: return argument == 2;
    case FaultKind::ReleaseDofLacking:
    case FaultKind::EndSpringDofLacking:
    case FaultKind::OffsetSize:
    case FaultKind::LoadDofLacking: return argument == 3;
    case FaultKind::TrussOffsetAcross: return argument == 5;
    default: return false;
    }
}

/// A value as the file or a field has it, which stands in the sentence without quotation marks.
bool is_value(FaultKind kind, std::size_t argument)
{
    switch (kind) {
    case FaultKind::NotFinite:
    case FaultKind::NotPositive:
    case FaultKind::Negative:
    case FaultKind::ZeroStiffness:
    case FaultKind::ZeroEndSpring: return argument == 2;
    case FaultKind::OutOfReach: return argument == 2 || argument == 3;
    case FaultKind::PoissonOutOfRange: return argument == 1;
    case FaultKind::CentroidOutside:
    case FaultKind::LoadEndsBeforeStart: return argument == 1 || argument == 2;
    case FaultKind::FoundationTooStiff: return argument >= 1 && argument <= 3;
    case FaultKind::DepthTooSmall: return argument == 1 || argument == 3;
    case FaultKind::DepthsTooDifferent: return argument == 1 || argument == 2;
    case FaultKind::PositionBeforeStart:
    case FaultKind::PositionBeyondEnd: return argument == 2 || argument == 4;
    case FaultKind::TrussOffsetAcross: return argument >= 2 && argument <= 4;
    default: return false;
    }
}

/// A hyphen before a digit is a minus.
std::string with_minus_before_digits(std::string_view text)
{
    std::string words;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_minus = text[i] == '-' && i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9';
        words += is_minus ? ui::with_minus_signs("-") : std::string(1, text[i]);
    }
    return words;
}

/// Where the decimal mark is a comma, semicolons part numbers.
std::string with_mark(std::string text, ui::DecimalMark mark)
{
    if (mark == ui::DecimalMark::Point) return text;
    std::ranges::replace(text, ',', ';');
    std::ranges::replace(text, '.', ',');
    return text;
}

/// "12.5 m" is in every file, and what is typed has the mark of the language.
bool is_example_to_type(const Fault& fault, std::size_t argument)
{
    const bool has_example = fault.kind == FaultKind::QuantityWithoutNumber ||
                             fault.kind == FaultKind::QuantityWithoutUnit;
    return has_example && argument == 2 && fault.arguments.front().empty();
}

constexpr std::size_t label_place = 8, table_place = 9; // in the patterns

Fault spoken(const Fault& fault, const Catalogue& tr)
{
    Fault told = fault;
    if (const std::optional<FaultPlace> place = place_of(fault)) told.arguments.front() = place_text(*place, tr);
    for (std::size_t i = 0; i < told.arguments.size(); ++i) {
        std::string& argument = told.arguments[i];
        if (is_computed(fault.kind, i)) argument = with_minus_before_digits(argument); // femoop sets the mark
        if (is_value(fault.kind, i) || is_example_to_type(fault, i))
            argument = femoop::with_product_dots(
                with_mark(with_minus_before_digits(argument), ui::decimal_mark(tr.language())));
        if (names_an_end(fault.kind, i)) argument = tr(argument);
        if (names_a_kind(fault.kind, i)) argument = kind_named(argument, tr).value_or(argument);
    }
    const Remedy remedy = remedy_of(fault);
    told.arguments.resize(std::max(told.arguments.size(), table_place + 1));
    told.arguments[label_place] = tr(label_of(remedy));
    told.arguments[table_place] = tr(title_of_list(remedy.list));
    return told;
}

} // namespace

namespace {

/// A calculation that has no value is read as a unit that cannot be: a file has no calculations.
std::string_view pattern_of(const Fault& fault)
{
    const bool is_unit = fault.kind == FaultKind::QuantityBadUnit && fault.arguments.size() > 1;
    if (is_unit && ui::divides_by_zero(fault.arguments[1]))
        return translatable("{0}: \"{1}\" divides by zero; write another divisor");
    return spoken_pattern(fault.kind);
}

} // namespace

std::string sentence(const Fault& fault, const Catalogue& tr)
{
    const std::string_view in_file = femoop::pattern(fault.kind), in_app = pattern_of(fault);
    return femoop::message(spoken(fault, tr),
                           [&](std::string_view text) { return tr(text == in_file ? in_app : text); });
}

} // namespace frame
