#pragma once

#include <optional>

#include "apps/drawing/pick.h"
#include "apps/drawing/sheet/subject.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/session/pointed_number.h"
#include "apps/frame/session/session.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// A picture that was drawn, as far as numbers are pointed at in it.
struct NumbersOfPicture {
    const Subject::Plan& plan;
    const Grips& grips;
};

/// The number of the results that the pointer means: the one that is written under it, else at a section what its panel
/// shows, else of a support its foremost reaction, of a node its displacement. On an influence line that nothing stands
/// on: the ordinate of the place. Nothing where no numbers are seen.
std::optional<PointedNumber> number_of_picture(const Session& session, const NumbersOfPicture& picture, ui::Point at,
                                               const Pick& under, const Aim& aim);

} // namespace frame
