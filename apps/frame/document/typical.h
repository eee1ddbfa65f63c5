#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "apps/frame/document/document.h"
#include "ui/text/display_units.h"
#include "ui/text/message.h"

namespace frame {

/// A number of a typical structure as a person is asked for it, with the range of its slider. Lengths in m, forces in
/// kN, whatever the document counts in.
struct TypicalNumber {
    std::string_view id;    ///< the word that scenarios use: "bays"
    std::string_view label; ///< translatable
    ui::Measure measure = ui::Measure::Plain;
    double start = 0.0;
    double least = 0.0, most = 1.0; ///< of the slider, and of a count; typed lengths and loads may go beyond
    double step = 1.0;
    std::span<const std::string_view> options{}; ///< not empty: a choice, of which the number is the place

    bool is_count() const { return measure == ui::Measure::Plain; }
};

/// One of the structures that everybody draws (femoop/typical/typical.h).
struct TypicalStructure {
    std::string_view id, label; ///< "warren", "Warren truss"
    std::span<const TypicalNumber> numbers;
    femoop::Model (*model)(std::span<const double> numbers);
};

/// Continuous beam, portal, storey frame, gable, Vierendeel, Pratt, Howe, Warren, K-truss, arch, grillage, space truss,
/// space frame, tower.
std::span<const TypicalStructure> typical_structures();

/// The numbers that each of them starts with.
std::vector<double> first_numbers(const TypicalStructure& structure);

/// Why the structure cannot have this number; nothing where it can.
std::optional<ui::Message> why_not(const TypicalNumber& number, double value);

/// Where a structure goes among what is there.
struct Neighbour {
    double distance = 0.0;    ///< to the right, in the document's unit of length
    femoop::CaseId load_case; ///< which gets its loads; the first one for a combination
};

/// Puts a structure to the right of what is there, on the level of its lowest node, and joins what meets.
/// \pre it has one load case and is of the document's analysis \throws std::invalid_argument
void insert_beside(Document& document, const femoop::Model& structure, const Neighbour& neighbour);

/// The structure takes the place of all that is there, dimension lines too; units and notes of the document stay.
void put_in_place(Document& document, const femoop::Model& structure);

} // namespace frame
