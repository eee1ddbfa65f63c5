#include "ui/files/linked_copy.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace ui {

namespace {

std::set<std::string_view> lines(std::string_view text)
{
    std::set<std::string_view> found;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        found.insert(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return found;
}

} // namespace

bool LinkedCopy::undoes_own_change(const std::string& offered) const
{
    if (sent_ == shared_) return false;
    const auto now = lines(sent_), then = lines(shared_), theirs = lines(offered);
    const auto is_undone = [&](std::string_view line) { return !then.contains(line) && !theirs.contains(line); };
    const auto comes_back = [&](std::string_view line) { return !now.contains(line) && theirs.contains(line); };
    return std::ranges::any_of(now, is_undone) || std::ranges::any_of(then, comes_back);
}

void LinkedCopy::tick(double seconds, const Document& document)
{
    waited_ += seconds;
    if (waited_ < pause) return;
    waited_ = 0.0;
    look_for_news(document);
    would_undo_own_change_ = offered_ && undoes_own_change(*offered_);
}

void LinkedCopy::look_for_news(const Document& document)
{
    if (link_.is_cut()) return offered_.reset();
    if (std::string now = document.text(); now != sent_ && !link_.notify(now)) sent_ = std::move(now);
    if (std::exchange(is_taken_, false)) shared_ = sent_;
    if (auto heard = link_.heard()) offered_ = std::move(heard);
    if (link_.is_withdrawn()) offered_.reset();
    if (!offered_ || document.is_news(*offered_)) return;
    offered_.reset();
    shared_ = sent_;
}

std::string LinkedCopy::accept()
{
    is_taken_ = true;
    return *std::exchange(offered_, {});
}

} // namespace ui
