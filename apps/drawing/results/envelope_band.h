#pragma once

#include "apps/drawing/results/solved_case.h"
#include "femoop/model/component.h"
#include "femoop/model/dof.h"
#include "femoop/model/ids.h"

#include <cstddef>
#include <string>
#include <vector>

namespace drawing {

/// A value, and the place of what makes it among the names of its envelope; of equal ones the first.
struct Bound {
    double value = 0.0;
    std::size_t made_by = 0;
    friend bool operator==(const Bound&, const Bound&) = default;
};

/// Both of them, at a section of a member.
struct BandSection {
    double x = 0.0;
    Bound least, most;
    friend bool operator==(const BandSection&, const BandSection&) = default;
};

/// The least and the largest value of a section force along every member.
struct EnvelopeBands {
    femoop::MemberComponent component = femoop::MemberComponent::Mz;
    std::vector<std::vector<BandSection>> members; ///< ascending; two at a jump, the - side first

    double largest() const; ///< absolute value in the structure
};

/// What a support bears at least and at most; nothing but rounding is 0.
struct ReactionBand {
    femoop::NodeId node;
    femoop::Dof dof = femoop::Dof::uy;
    Bound least, most;
};

/// Over several cases; `made_by` is a place among them.
EnvelopeBands bands_of(const std::vector<SolvedCase>& cases, femoop::MemberComponent component);
std::vector<ReactionBand> reaction_bands_of(const std::vector<SolvedCase>& cases, std::size_t n_nodes);
std::vector<std::string> names_of(const std::vector<SolvedCase>& cases);

/// "58.5 (G)"; the number alone where the envelope has one name.
std::string governed(const std::string& number, const Bound& bound, const std::vector<std::string>& names);

/// An envelope as it is drawn: of load cases, or of trains.
struct EnvelopePicture {
    std::string title;                ///< for the head of the sheet: "Envelope of HS20 with G"
    std::vector<std::string> names{}; ///< of its cases, or of its trains
    std::vector<EnvelopeBands> bands{};
    std::vector<ReactionBand> reactions{};

    const EnvelopeBands* find(femoop::MemberComponent component) const; ///< null where it is not drawn
};

} // namespace drawing
