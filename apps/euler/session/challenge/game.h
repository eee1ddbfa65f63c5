#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/euler/document/challenge/corrupted_pointer.h"
#include "apps/euler/document/challenge/reach.h"
#include "apps/euler/document/challenge/score.h"
#include "apps/euler/document/challenge/which_operator.h"

namespace euler {

/// A challenge on its way: what is asked, what was told about it, and what it is worth still.
class Game {
public:
    using Task = std::variant<ReachChallenge, WhichOperator, CorruptedPointer>;
    explicit Game(Task task) : task_(std::move(task)) {}

    const Task& task() const { return task_; }
    ui::Message question() const;
    const std::vector<ui::Message>& hints() const { return hints_; }       ///< that were given
    const std::optional<ui::Message>& verdict() const { return verdict_; } ///< on the last answer

    bool is_over() const { return end_.has_value(); }
    int points() const { return end_ == End::Won ? score_.points() : 0; } ///< none before the end

    /// Why there is no hint now.
    std::optional<ui::Message> why_no_hint() const;
    void give_hint(const Stepper& attempt); ///< \pre there is one
    /// The operator's name, or a cell: "MEF", "H 3 N 4". \returns why it is no answer, nothing being lost then
    std::optional<ui::Message> answer(std::string_view words);
    void judge(const Stepper& attempt); ///< of a solid that is to be reached
    void give_up();

    std::string typed{}; ///< the answer, as far as it is typed

private:
    enum class End : std::uint8_t { Won, GivenUp };
    void win(ui::Message verdict);
    void miss(ui::Message verdict);

    Task task_;
    Score score_;
    std::optional<End> end_;
    std::vector<ui::Message> hints_;
    std::optional<ui::Message> verdict_;
};

} // namespace euler
