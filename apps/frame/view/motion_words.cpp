#include "apps/frame/view/motion_words.h"

#include "apps/frame/document/fault/sentence.h"

namespace frame {

namespace {

std::string motion_sentence(std::span<const femoop::Mechanism> all, std::size_t shown, const ui::Catalogue& tr)
{
    const std::string words = sentence(all[shown].fault, tr);
    if (all.size() == 1) return words;
    return tr("motion {n} of {total}: {words}",
              {{"n", std::to_string(shown + 1)}, {"total", std::to_string(all.size())}, {"words", words}});
}

} // namespace

drawing::MotionChoice motion_choice(std::span<const femoop::Mechanism> all, std::size_t shown, const ui::Catalogue& tr)
{
    return {all, shown, motion_sentence(all, shown, tr)};
}

} // namespace frame
