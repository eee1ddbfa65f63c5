#include "apps/mohr/view/sentence.h"

#include <algorithm>
#include <sstream>

namespace mohr {

std::vector<std::string> lines_of(const ui::Painter& painter, const std::string& words, const ui::TextStyle& style,
                                  double width)
{
    std::vector<std::string> lines{""};
    std::istringstream text(words);
    for (std::string word; text >> word;) {
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (painter.measure(longer, style).width > width && !lines.back().empty()) lines.push_back(word);
        else lines.back() = longer;
    }
    return lines;
}

ui::Box write_at_foot(ui::Painter& painter, const ui::Box& box, const std::string& words, ui::TextStyle style,
                      std::size_t least_lines)
{
    const auto lines = lines_of(painter, words, style, box.width());
    const double height = 1.4 * style.size;
    style.anchor = ui::Anchor::BottomRight;
    const double top = box.max.y - height * static_cast<double>(std::max(lines.size(), least_lines));
    for (std::size_t i = 0; i < lines.size(); ++i)
        painter.text({box.max.x, top + height * static_cast<double>(i + 1)}, lines[i], style);
    return {box.min, {box.max.x, top - 0.2 * style.size}};
}

} // namespace mohr
