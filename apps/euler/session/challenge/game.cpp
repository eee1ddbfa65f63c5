#include "apps/euler/session/challenge/game.h"

#include <algorithm>
#include <utility>

#include "ui/text/catalogue.h"

namespace euler {

using ui::Message;
using ui::translatable;

namespace {

// All hints of a task, in the order of giving; those on a solid to reach depend on how far it is.
std::vector<Message> all_hints(const Game::Task& task)
{
    if (const auto* const which = std::get_if<WhichOperator>(&task)) return {which->hint};
    if (const auto* const broken = std::get_if<CorruptedPointer>(&task)) return {broken->where, broken->message};
    return {};
}

} // namespace

Message Game::question() const
{
    if (const auto* const reach = std::get_if<ReachChallenge>(&task_)) return reach->task;
    if (std::holds_alternative<WhichOperator>(task_))
        return translatable("One operator leads from the first picture to the second. Which?");
    return translatable(
        "The tables below are those of the solid in the picture, but one pointer is wrong. Set it right.");
}

std::optional<Message> Game::why_no_hint() const
{
    if (is_over()) return translatable("the challenge is over");
    if (!std::holds_alternative<ReachChallenge>(task_) && hints_.size() == all_hints(task_).size())
        return translatable("there is no further hint");
    return std::nullopt;
}

void Game::give_hint(const Stepper& attempt)
{
    const auto* const reach = std::get_if<ReachChallenge>(&task_);
    const Message hint = reach != nullptr ? judged(*reach, attempt).hint : all_hints(task_)[hints_.size()];
    if (!hints_.empty() && hints_.back() == hint) return; // what was told costs nothing
    hints_.push_back(hint);
    ++score_.hints;
}

std::optional<Message> Game::answer(std::string_view words)
{
    if (is_over()) return translatable("the challenge is over");
    if (const auto* const which = std::get_if<WhichOperator>(&task_)) {
        const auto chosen = std::find(which->choices.begin(), which->choices.end(), words);
        if (chosen == which->choices.end()) return translatable("choose one of the four operators");
        const Message::Argument name("operator", std::string(words));
        if (*chosen == which->choices[which->answer]) win({translatable("Right: it was {operator}."), {name}});
        else miss({translatable("No, it was not {operator}."), {name}});
        return std::nullopt;
    }
    const auto* const broken = std::get_if<CorruptedPointer>(&task_);
    if (broken == nullptr) return translatable("the answer is a solid: make it by operators");
    const auto set = link_typed(*broken, words);
    if (const auto* const reason = std::get_if<Message>(&set)) return *reason;
    if (is_mended(*broken, std::get<topology::CorruptedLink>(set)))
        win(translatable("Right: every pointer is sound again."));
    else miss(translatable("No, the structure is still not sound."));
    return std::nullopt;
}

void Game::judge(const Stepper& attempt)
{
    const auto* const reach = std::get_if<ReachChallenge>(&task_);
    if (reach == nullptr || is_over()) return;
    const ReachState state = judged(*reach, attempt);
    const Message::Argument n("n", std::to_string(state.n_operators));
    verdict_.reset();
    if (state.is_won) win({translatable("Reached with {n} operators."), {n}});
    else if (state.is_reached)
        verdict_ = Message(translatable("Reached, but with {n} operators. Go back and try a shorter way."), {n});
}

void Game::give_up()
{
    end_ = End::GivenUp;
    if (const auto* const which = std::get_if<WhichOperator>(&task_))
        verdict_ = Message(translatable("It was {operator}."), {{"operator", which->choices[which->answer]}});
    else if (const auto* const broken = std::get_if<CorruptedPointer>(&task_))
        verdict_ = Message(translatable("This sets it right: {cell}"), {{"cell", way_back(*broken)}});
    else verdict_ = Message(translatable("The script is one way to it."));
}

void Game::win(Message verdict)
{
    end_ = End::Won;
    verdict_ = std::move(verdict);
}

void Game::miss(Message verdict)
{
    ++score_.misses;
    verdict_ = std::move(verdict);
}

} // namespace euler
