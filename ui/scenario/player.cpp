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
    const std::optional<PointerPlace> at = stage.find(place);
    if (!at) throw ScenarioError(step.line, "no place \"" + place + "\"");
    return *at;
}

void require(const ScenarioStep& step, const std::optional<std::string>& complaint)
{
    if (complaint) throw ScenarioError(step.line, *complaint);
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

void Player::begin(const ScenarioStep& step, Stage& stage)
{
    const auto press = [&](bool is_down) {
        state_.is_left_down = is_down;
        push();
        push();
    };
    std::visit(Overloaded{
                   [&](const step::Click& click) {
                       move_to(found(step, click.at, stage));
                       press(true);
                       press(false);
                   },
                   [&](const step::Hover& hover) { move_to(found(step, hover.at, stage)); },
                   [&](const step::Drag& drag) {
                       const PointerPlace from = found(step, drag.from, stage);
                       const PointerPlace to = found(step, drag.to, stage);
                       move_to(from);
                       press(true);
                       for (int i = 1; i <= n_drag_frames; ++i) {
                           const double t = static_cast<double>(i) / n_drag_frames;
                           state_.pointer = {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
                           push();
                       }
                       press(false);
                   },
                   [&](const step::Wheel& wheel) {
                       move_to(found(step, wheel.at, stage));
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
