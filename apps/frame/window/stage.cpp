#include "apps/frame/window/stage.h"

#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include "apps/drawing/geometry/structure_shape.h"
#include "ui/scenario/words.h"

namespace frame {

namespace {

constexpr const char* any_place = "a place: node B, member AB 50%, member AB 2.5, (2, 0) or pixel 400 300";

template <class Part> std::string names(const std::vector<Part>& parts)
{
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(parts.size(), most); ++i) text += (i > 0 ? ", " : "") + parts[i].id;
    return parts.empty() ? "there is none" : parts.size() > most ? text + " and more" : text;
}

} // namespace

OffscreenStage::Found OffscreenStage::locate(std::string_view place)
{
    const femoop::Model& model = application().session().model();
    const Canvas& canvas = application().canvas();
    const std::vector<std::string> words = ui::words_of(place);
    std::optional<ui::Point> at;
    if (words.size() == 2 && words[0] == "node") {
        const auto id = model.find_node(words[1]);
        if (!id) return "a node of the model: " + names(model.nodes);
        at = canvas.in_window(shape_of(model)[*id]);
    } else if (words.size() == 3 && words[0] == "member") {
        const auto cut = cut_at(model, words[1], words[2]);
        if (!cut) return "a place along a member of the model: " + names(model.members);
        at = canvas.in_window(*cut);
    } else if (const auto point = point_in(place)) {
        at = canvas.in_window(*point);
    }
    if (!at) return any_place;
    return *at;
}

std::optional<std::string> OffscreenStage::run_command(std::string_view id, std::string_view argument)
{
    if (id != "file.export_table" || argument.empty())
        return ui::OffscreenStage<Application>::run_command(id, argument);
    const auto reason = application().tables().export_to(application().workspace(), argument);
    return reason ? std::optional(ui::Catalogue()(*reason)) : std::nullopt;
}

} // namespace frame
