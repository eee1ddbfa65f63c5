#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/mohr/document/document.h"
#include "femoop/methods/mohr/construction.h"
#include "femoop/methods/mohr/loading_path.h"
#include "femoop/methods/mohr/point_results.h"
#include "femoop/methods/mohr/rosette.h"
#include "femoop/methods/mohr/section_stress.h"
#include "femoop/model/fault/fault.h"
#include "ui/text/message.h"

namespace mohr {

/// A library's fault as a sentence.
ui::Message sentence(const femoop::Fault& fault);

/// A reason why a document cannot be shown, with the number that is at fault.
struct Fault {
    ui::Message reason;
    std::optional<NumberId> number{};
};

/// A section, what is carried by it, and the fibre whose state is shown. In N and mm.
struct SectionState {
    femoop::mohr::SectionFigure figure;
    femoop::mohr::SectionForces forces;
    femoop::mohr::FibreStress fibre;
    std::vector<femoop::mohr::FibreStress> distribution;
};

/// Everything that follows from a document: how it was typed, and what a textbook's table holds. All components count
/// in `unit`, angles are radians.
struct Solution : femoop::mohr::PointResults {
    femoop::mohr::State state;
    std::string unit;        ///< "MPa", "cm^4"; "10⁻⁶" of strains
    std::string stress_unit; ///< of stresses that follow from strains, of E
    std::optional<femoop::mohr::Rosette> rosette{};
    std::optional<SectionState> section{};

    double angle = 0.0;             ///< of the plane's normal from x
    femoop::mohr::ShearRule rule{}; ///< in which way the shear is drawn

    femoop::mohr::LoadingPath path; ///< in `unit`

    std::optional<femoop::mohr::Strength> strength{}; ///< of the criterion, in the unit of the stress
};

/// Why the document's numbers cannot be used, everything that is wrong with them; empty if they can.
std::vector<Fault> faults(const Document& document);
std::optional<Fault> why_not(const Document& document); ///< the first of them

/// \pre `why_not` has nothing to say
Solution solve(const Document& document, femoop::mohr::ShearRule rule = femoop::mohr::ShearRule::ClockwiseUp);

/// The steps in which its circle, or its three circles, are drawn.
std::vector<femoop::mohr::ConstructionStep> construction_of(const Document& document, const Solution& solution);

/// A word on a state that is special: a point circle, one stress alone, pure shear; and on the third direction where
/// the largest shear lies across the plane. Sentences, in order.
std::vector<ui::Message> remarks(const Document& document, const Solution& solution);

} // namespace mohr
