#include "ui/files/linked_copy.h"

#include <utility>

namespace ui {

void LinkedCopy::tick(double seconds, const Document& document)
{
    waited_ += seconds;
    if (waited_ < pause) return;
    waited_ = 0.0;
    if (link_.is_cut()) return offered_.reset();
    if (std::string now = document.text(); now != told_ && !link_.notify(now)) told_ = std::move(now);
    if (std::exchange(is_taken_, false)) shared_ = told_;
    if (auto heard = link_.heard()) offered_ = std::move(heard);
    if (link_.is_withdrawn()) offered_.reset();
    if (!offered_ || document.is_news(*offered_)) return;
    offered_.reset();
    shared_ = told_;
}

std::string LinkedCopy::take()
{
    is_taken_ = true;
    return *std::exchange(offered_, {});
}

} // namespace ui
