#pragma once

#include "apps/drawing/draw_options.h"
#include "apps/drawing/results/influence_picture.h"
#include "femoop/methods/influence/train/train_search.h"
#include "femoop/model/model.h"

#include <string>
#include <vector>

namespace drawing {

/// A train that stands on the path of an influence line.
struct StandingTrain {
    std::string name;
    femoop::influence::MovingTrain train;
    femoop::influence::Placing placing;
    femoop::ExtremeKind kind = femoop::ExtremeKind::Max; ///< what it was placed for
    bool is_worst = true;                                ///< else where somebody put it
};

/// Stands it on the picture's line: its forces with their ordinates.
void stand_on(InfluencePicture& picture, const StandingTrain& standing);

/// What it does to the line's effect, and where its axles, uniform load and single forces stand: for words alone.
std::string train_sentence(const femoop::Model& model, const DrawOptions& options, const InfluencePicture& picture,
                           const StandingTrain& standing);

/// For the foot of the sheet: what it does to the line's effect and where its leading axle stands; and that as a sum, each force
/// times its ordinate and the uniform load times its areas, where that is short enough to be read.
/// \pre it stands on the picture
std::vector<std::string> train_sentences(const femoop::Model& model, const DrawOptions& options,
                                         const InfluencePicture& picture, const StandingTrain& standing);

/// What a unit load says that traces the line: its ordinate there; and when all is traced, that the released structure
/// moves by the same line. \pre one force stands on the picture
std::vector<std::string> trace_sentences(const femoop::Model& model, const DrawOptions& options,
                                         const InfluencePicture& picture);

} // namespace drawing
