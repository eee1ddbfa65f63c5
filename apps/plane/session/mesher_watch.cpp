#include "apps/plane/session/mesher_watch.h"

#include <algorithm>
#include <utility>

namespace plane {

namespace {

constexpr double seconds_in_all = 40.0;                        // that a long one takes at speed 1
constexpr double fewest_a_second = 2.0, most_a_second = 200.0; // steps

} // namespace

void MesherWatch::begin(std::shared_ptr<const Solution> solution,
                        const std::shared_ptr<const topology::SizeField>& sizes)
{
    end();
    solution_ = std::move(solution);
    player_ = std::make_shared<discretize::MeshPlayer>(*solution_->drawing(), sizes);
}

void MesherWatch::end()
{
    player_.reset();
    solution_.reset();
    is_playing_ = false;
    due_ = 0.0;
}

const discretize::MeshPlayer* MesherWatch::of(const std::shared_ptr<const Solution>& solution) const
{
    return solution_ == solution ? player_.get() : nullptr;
}

void MesherWatch::go_to(std::size_t place)
{
    is_playing_ = false;
    player_->go_to(place);
}

void MesherWatch::play(bool is_on)
{
    if (is_on && player_->place() == player_->n_steps()) player_->go_to(0);
    is_playing_ = is_on;
    due_ = 0.0;
}

void MesherWatch::change_speed(double factor) { speed = std::clamp(speed * factor, slowest, fastest); }

void MesherWatch::tick(double seconds)
{
    if (!is_playing()) return;
    const double pace = std::clamp(static_cast<double>(player_->n_steps()) / seconds_in_all, fewest_a_second,
                                   most_a_second);
    due_ += seconds * speed * pace;
    const auto n = static_cast<std::size_t>(due_);
    due_ -= static_cast<double>(n);
    player_->go_to(player_->place() + n);
    if (player_->place() == player_->n_steps()) is_playing_ = false;
}

} // namespace plane
