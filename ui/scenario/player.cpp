#include "ui/scenario/player.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr int n_drag_frames = 12;

template <class... Functions> struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions> Overloaded(Functions...) -> Overloaded<Functions...>;

PointerPlace found(const ScenarioStep& step, const std::string& place, Stage& stage)
{
    const Stage::Located sought = stage.find(place);
    if (const auto* const wanted = std::get_if<std::string>(&sought))
        throw ScenarioError(step.line, "found \"" + place + "\", wanted " + *wanted);
    return std::get<PointerPlace>(sought);
}

void require(const ScenarioStep& step, const std::optional<std::string>& mismatch)
{
    if (mismatch) throw ScenarioError(step.line, *mismatch);
}

} // namespace

std::optional<InputFrame> Player::next(Stage& stage)
{
    while (frames_.empty() && next_step_ < steps_.size()) begin(steps_[next_step_++], stage);
    if (frames_.empty()) return std::nullopt;
    InputFrame frame = std::move(frames_.front());
    frames_.pop_front();
    return frame;
}

void Player::push(double wheel)
{
    frames_.push_back(state_);
    frames_.back().wheel = wheel;
}

void Player::move_to(PointerPlace place)
{
    state_.pointer = place;
    push();
    push(); // what the pointer is over is known one frame later
}

// In small steps, as a hand goes.
void Player::glide_to(PointerPlace to)
{
    const PointerPlace from = state_.pointer;
    for (int i = 1; i <= n_drag_frames; ++i) {
        const double t = static_cast<double>(i) / n_drag_frames;
        state_.pointer = {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
        push();
    }
}

void Player::hold(bool InputFrame::*button, bool is_down)
{
    state_.*button = is_down;
    push();
    push();
}

void Player::begin(const ScenarioStep& step, Stage& stage)
{
    const auto move_there = [&](const auto& words) {
        const PointerPlace place = found(step, words.at, stage);
        state_.held = words.held;
        if (state_.is_left_down) glide_to(place);
        else move_to(place);
    };
    state_.held = {};
    constexpr auto left = &InputFrame::is_left_down;
    std::visit(Overloaded{
                   [&](const step::Click& click) {
                       move_there(click);
                       hold(left, true);
                       hold(left, false);
                   },
                   [&](const step::RightClick& click) {
                       move_there(click);
                       hold(&InputFrame::is_right_down, true);
                       hold(&InputFrame::is_right_down, false);
                   },
                   [&](const step::Hover& hover) { move_there(hover); },
                   [&](const step::Drag& drag) {
                       const PointerPlace to = found(step, drag.to, stage);
                       move_there(step::Hover{drag.from, drag.held});
                       hold(left, true);
                       glide_to(to);
                       hold(left, false);
                   },
                   [&](const step::PressButton& press) {
                       move_there(press);
                       hold(left, true);
                   },
                   [&](const step::ReleaseButton& release) {
                       state_.held = release.held;
                       hold(left, false);
                   },
                   [&](const step::Wheel& wheel) {
                       move_there(wheel);
                       push(wheel.turns);
                       push();
                   },
                   [&](const step::Press& key) {
                       push();
                       frames_.back().key = key.chord;
                       push();
                   },
                   [&](const step::Type& type) {
                       push();
                       frames_.back().text = type.text;
                       push();
                   },
                   [&](const step::RunCommand& command) {
                       require(step, stage.run_command(command.id, command.argument));
                       push();
                       push();
                   },
                   [&](const step::Wait& wait) {
                       const int n = std::max(1, static_cast<int>(std::lround(wait.seconds / time_step)));
                       for (int i = 0; i < n; ++i) push();
                   },
                   [&](const step::TakePicture& picture) { require(step, stage.take_picture(picture.name)); },
                   [&](const step::Expect& expect) { require(step, stage.expect(expect.words)); },
               },
               step.what);
}

} // namespace ui
