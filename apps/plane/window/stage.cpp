#include "apps/plane/window/stage.h"

#include <algorithm>
#include <string>

#include "apps/plane/document/points.h"
#include "ui/command/argument.h"
#include "ui/scenario/words.h"

namespace plane {

OffscreenStage::Found OffscreenStage::locate(std::string_view place)
{
    const Canvas& canvas = application().canvas();
    const PlaneModel& model = application().session().model();
    const auto words = ui::words_of(place);
    if (words.size() == 2 && words[0] == "point") {
        const auto point = std::ranges::find(model.points, words[1], &femoop::plane::PlanePoint::id);
        if (point == model.points.end()) return "a point of the drawing";
        return canvas.in_window({point->at[0], point->at[1]});
    }
    if (place.starts_with('('))
        if (const auto p = ui::Argument{place, place}.numbers(2)) return canvas.in_window({p->at(0), p->at(1)});
    return "a place: (30, 10), point A or pixel 400 300";
}

} // namespace plane
