#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "apps/plane/discretize/drawing.h"
#include "apps/plane/document/document.h"
#include "apps/plane/document/part.h"

namespace plane {

/// An entry for a face that has none, with the material and the thickness of the last one. A model without a material
/// gets steel.
RegionId make_region(Document& document, const FlatPoint& at);

/// Gives a face that shares its entry with others one of its own, alike. \pre it lies in the region's faces
/// \returns the face's entry: the same where it is the entry's only face
RegionId part_off(Document& document, const discretize::Drawing& drawing, std::size_t face);

/// Whether a face is left empty. A face that shares its entry with others is parted off first; one that becomes a
/// region of a model without a material gets steel.
void set_hole(Document& document, const discretize::Drawing& drawing, std::size_t face, bool is_hole);

/// The faces of a drawing that each entry has.
std::vector<std::vector<std::size_t>> faces_of_regions(const discretize::Drawing& drawing);

/// Entries go with their faces where curves have changed: a face that was split keeps its entry in all its parts, one
/// whose place came to lie elsewhere gets another place, faces that have become one are of one entry where their
/// entries are alike, and an entry goes when all the curves around its faces have gone.
/// \param before  the drawing that the document's regions are of  \pre the document's curves can be drawn
void follow_faces(Document& document, const discretize::Drawing& before);

/// Two entries that differ and claim one face, since what parted them has gone: somebody must choose.
struct Dispute {
    RegionId first, second;
    FlatPoint at; ///< in the face
};
std::optional<Dispute> dispute_in(const PlaneModel& model, const discretize::Drawing& drawing);
/// The face is one entry's; the other has it no more, and goes where it has no other.
void settle_dispute(Document& document, const discretize::Drawing& drawing, const Dispute& dispute, RegionId keeps);

} // namespace plane
