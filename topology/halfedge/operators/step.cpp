#include "topology/halfedge/operators/step.h"

#include <utility>

namespace topology {

namespace {

constexpr std::array<std::pair<std::string_view, OperatorKind>, 16> names_and_inverses{{
    {"MVFS", OperatorKind::KVFS},
    {"KVFS", OperatorKind::MVFS},
    {"MEV", OperatorKind::KEV},
    {"KEV", OperatorKind::MEV},
    {"SEMV", OperatorKind::JEKV},
    {"JEKV", OperatorKind::SEMV},
    {"MVR", OperatorKind::KVR},
    {"KVR", OperatorKind::MVR},
    {"MEF", OperatorKind::KEF},
    {"KEF", OperatorKind::MEF},
    {"KEMR", OperatorKind::MEKR},
    {"MEKR", OperatorKind::KEMR},
    {"KFMRH", OperatorKind::MFKRH},
    {"MFKRH", OperatorKind::KFMRH},
    {"RINGMV", OperatorKind::RINGMV},
    {"MOVE", OperatorKind::MOVE},
}};

} // namespace

std::string_view name(OperatorKind kind) { return names_and_inverses[static_cast<std::size_t>(kind)].first; }
OperatorKind inverse(OperatorKind kind) { return names_and_inverses[static_cast<std::size_t>(kind)].second; }

} // namespace topology
