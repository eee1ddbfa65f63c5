#include "femoop/model/fault/fault.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/unit_signs.h"

namespace femoop {

namespace {

constexpr char list_separator = '\x1f'; // the unit separator of ASCII: no id contains it

std::string spelled_out(const std::string& argument, std::string_view conjunction)
{
    std::string text;
    const std::size_t last = argument.rfind(list_separator);
    for (std::size_t i = 0; i < argument.size(); ++i) {
        if (argument[i] != list_separator) text += argument[i];
        else if (i == last) text.append(" ").append(conjunction).append(" ");
        else text += ", ";
    }
    return printable(text);
}

} // namespace

std::string printable(std::string_view text)
{
    static constexpr std::string_view hex = "0123456789abcdef";
    std::string shown;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code >= 0x20U && code != 0x7FU) shown += c;
        else shown += {'\\', 'u', '0', '0', hex[code / 16U], hex[code % 16U]};
    }
    return shown;
}

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : std::string(1, list_separator)) + name;
    return text;
}

std::string fill(std::string_view pattern, const std::vector<std::string>& arguments, std::string_view conjunction)
{
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool is_place = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}';
        const auto place = is_place ? static_cast<std::size_t>(pattern[i + 1] - '0') : arguments.size();
        if (place < arguments.size()) {
            text += spelled_out(arguments[place], conjunction);
            i += 2;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

bool is_word(FaultKind kind, std::size_t argument)
{
    switch (kind) {
    case FaultKind::QuantityWrongDimension: return argument == 2 || argument == 3;
    case FaultKind::QuantityUnwantedUnit: return argument == 2;
    case FaultKind::WrongType: return argument == 1 || argument == 2;
    case FaultKind::WrongTypeText: return argument == 2;
    case FaultKind::FileUnreadable:
    case FaultKind::FileUnwritable: return argument == 1;
    case FaultKind::MechanismTurn: return argument == 2;
    case FaultKind::MechanismMixed: return argument == 3;
    default: return false;
    }
}

bool is_computed(FaultKind kind, std::size_t argument)
{
    switch (kind) {
    case FaultKind::NearlySingular: return argument == 0;
    case FaultKind::CrossJointFree: return argument == 1;
    case FaultKind::CrossSteps: return argument == 1 || argument == 3;
    case FaultKind::CrossNodeWithoutImage: return argument == 1 || argument == 2;
    case FaultKind::CrossEndWithoutImage:
    case FaultKind::CrossSkewSway: return argument == 1;
    case FaultKind::CrossSkewLoads: return argument == 1 || argument == 3 || argument == 4;
    case FaultKind::MemoryInsufficient: return argument == 1 || argument == 2;
    case FaultKind::PositionOffPath: return argument == 2;
    case FaultKind::ElementDistorted:
    case FaultKind::EllipsePlaceOff:
    case FaultKind::MeshElementTurned: return argument == 1;
    case FaultKind::ArcRadiiDiffer: return argument == 1 || argument == 2;
    case FaultKind::FaceWithoutRegion:
    case FaultKind::SharpCorner: return argument <= 1;
    case FaultKind::MeshAngleMissed: return argument == 1 || argument == 3;
    case FaultKind::PlacesMerged: return argument >= 2;
    case FaultKind::SettlementConflict: return argument == 2 || argument == 3;
    case FaultKind::SettlementOffAxis: return argument == 2;
    case FaultKind::CheckOutside:
    case FaultKind::RegionMoves:
    case FaultKind::RegionTurns: return argument == 1;
    case FaultKind::MechanismMoveOblique:
    case FaultKind::MechanismTurn:
    case FaultKind::HugeDisplacement: return argument == 1;
    case FaultKind::CoincidentNodes:
    case FaultKind::MembersCross:
    case FaultKind::MembersOverlap:
    case FaultKind::MemberPassesNode:
    case FaultKind::MechanismMixed: return argument == 2;
    default: return false;
    }
}

namespace {

/// Where the decimal mark is a comma, semicolons part the coordinates of a point: (0,6; 0,8).
std::string localized_numbers(std::string numbers, const Translator& tr)
{
    const char mark = decimal_mark(tr);
    if (mark == ',') std::replace(numbers.begin(), numbers.end(), ',', ';');
    return localized(std::move(numbers), tr);
}

/// Of forces that are named by their places, "M(BC, 2.5 m)", with ids that stay: a number follows the comma.
std::string localized_places(std::string names, const Translator& tr)
{
    constexpr std::string_view digits = "0123456789";
    for (std::size_t at = names.find(", "); at != std::string::npos; at = names.find(", ", at + 2)) {
        const std::size_t end = std::min(names.find_first_not_of(digits, at + 2), names.size());
        if (end > at + 2 && end < names.size() && names[end] == '.') names[end] = decimal_mark(tr);
    }
    return names;
}

bool names_forces(FaultKind kind, std::size_t argument)
{
    switch (kind) {
    case FaultKind::RedundantNoForce:
    case FaultKind::RedundantReleased:
    case FaultKind::RedundantInsideBar:
    case FaultKind::RedundantTwice: return argument == 1;
    case FaultKind::RedundantsUnstrained:
    case FaultKind::PrimaryMoves: return argument == 0;
    default: return false;
    }
}

bool is_unit(FaultKind kind, std::size_t argument)
{
    return kind == FaultKind::QuantityWrongDimension && argument == 4;
}

/// A dimension without a name of its own is put together of single words: force^2*length.
std::string word_by_word(std::string_view text, const Translator& tr)
{
    const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
    std::string translated;
    while (!text.empty()) {
        const auto end = std::find_if_not(text.begin(), text.end(), is_letter) - text.begin();
        const std::size_t length = std::max<std::size_t>(static_cast<std::size_t>(end), 1);
        translated += end == 0 ? std::string(1, text.front()) : tr(text.substr(0, length));
        text.remove_prefix(length);
    }
    return translated;
}

std::string translated_word(std::string_view text, const Translator& tr)
{
    std::string translated = tr(text);
    const bool is_put_together = text.find(' ') == std::string_view::npos && translated == text;
    return is_put_together ? word_by_word(text, tr) : translated;
}

} // namespace

std::string message(const Fault& fault, const Translator& tr)
{
    const std::string_view plain = pattern(fault.kind);
    const std::string sentence = tr(plain);
    std::vector<std::string> arguments = fault.arguments;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (is_word(fault.kind, i)) arguments[i] = translated_word(arguments[i], tr);
        if (is_computed(fault.kind, i)) arguments[i] = with_product_dots(localized_numbers(arguments[i], tr));
        if (names_forces(fault.kind, i)) arguments[i] = localized_places(arguments[i], tr);
        if (is_unit(fault.kind, i)) arguments[i] = with_product_dots(arguments[i]);
    }
    // A sentence that has no translation keeps its own conjunction.
    return fill(sentence, arguments, sentence == plain ? std::string("and") : tr(translatable("and")));
}

namespace {

std::string sentences(const std::vector<Fault>& faults)
{
    std::string text;
    for (const Fault& fault : faults) text += (text.empty() ? "" : "\n") + message(fault);
    return text;
}

} // namespace

ModelError::ModelError(std::vector<Fault> faults) : std::runtime_error(sentences(faults)), faults_(std::move(faults)) {}

} // namespace femoop
