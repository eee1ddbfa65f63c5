#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "femoop/model/ids.h"
#include "femoop/model/model.h"
#include "ui/text/phrase.h"

namespace frame {

struct Document;

/// Places in the lists of a model that femoop itself has no ids for.
struct LoadCasePlace {
    std::size_t load_case = 0;
    friend auto operator<=>(LoadCasePlace, LoadCasePlace) = default;
};
struct CombinationPlace {
    std::size_t combination = 0;
    friend auto operator<=>(CombinationPlace, CombinationPlace) = default;
};
struct NodeLoadPlace {
    std::size_t load_case = 0, load = 0;
    friend auto operator<=>(NodeLoadPlace, NodeLoadPlace) = default;
};
struct SettlementPlace {
    std::size_t load_case = 0, settlement = 0;
    friend auto operator<=>(SettlementPlace, SettlementPlace) = default;
};
struct MemberLoadPlace {
    std::size_t load_case = 0, load = 0;
    friend auto operator<=>(MemberLoadPlace, MemberLoadPlace) = default;
};

/// A dimension line of the document's companion.
struct DimensionPlace {
    std::size_t dimension = 0;
    friend auto operator<=>(DimensionPlace, DimensionPlace) = default;
};

/// Anything in a document that has properties: what can be selected and edited.
using Part = std::variant<femoop::NodeId, femoop::MemberId, femoop::MaterialId, femoop::SectionId, LoadCasePlace,
                          CombinationPlace, NodeLoadPlace, SettlementPlace, MemberLoadPlace, DimensionPlace>;

/// False where the document no longer has it, as after an undo.
bool has(const Document& document, const Part& part);
bool has(const femoop::Model& model, const Part& part); ///< of what is the model's own

/// "Node B", "Load on member BC". \pre has(document, part)
ui::Phrase title(const Document& document, const Part& part);
ui::Phrase title(const femoop::Model& model, const Part& part); ///< of what is the model's own

/// Every part of the model, in the order of the file.
std::vector<Part> parts(const femoop::Model& model);

/// The place of the load case that a load or settlement belongs to. \pre the part is one
std::size_t load_case_of(const Part& load);

/// The loads and settlements of all load cases that act on this node or member.
std::vector<Part> loads_on(const femoop::Model& model, const Part& part);

} // namespace frame
