#include "apps/plane/discretize/fault_place.h"

#include <charconv>
#include <system_error>

namespace discretize {

bool is_of_faces(femoop::FaultKind kind)
{
    using femoop::FaultKind;
    switch (kind) {
    case FaultKind::RegionPlaceOnCurve:
    case FaultKind::RegionPlaceOutside:
    case FaultKind::RegionPlaceTaken:
    case FaultKind::NoFaceLeft:
    case FaultKind::DivisionsOfPieces:
    case FaultKind::TouchesNoMaterial:
    case FaultKind::PressureInside:
    case FaultKind::CheckFaceRank:
    case FaultKind::CheckFaceOutside: return true;
    default: return false;
    }
}

std::optional<EntryPlace> entry_of(std::string_view place)
{
    const std::size_t open = place.find('['), close = place.find(']');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) return std::nullopt;
    std::size_t index = 0;
    const char* const last = place.data() + close;
    const auto [end, error] = std::from_chars(place.data() + open + 1, last, index);
    if (error != std::errc() || end != last) return std::nullopt;
    return EntryPlace{place.substr(0, open), index};
}

} // namespace discretize
