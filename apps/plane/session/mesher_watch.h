#pragma once

#include <cstddef>
#include <memory>

#include "apps/plane/discretize/mesh_player.h"
#include "apps/plane/document/solution.h"

namespace plane {

/// The mesher that is watched: which step of the making of a drawing's mesh is shown, and whether one follows the other
/// by itself.
class MesherWatch {
public:
    static constexpr double slowest = 0.25, fastest = 4.0;

    /// \param sizes  that the mesh is made by in place of the drawing's own; null: those
    /// \pre the drawing has a sound mesh
    void begin(std::shared_ptr<const Solution> solution, const std::shared_ptr<const topology::SizeField>& sizes);
    void end();

    /// Null where none is watched, or of another solution.
    const discretize::MeshPlayer* of(const std::shared_ptr<const Solution>& solution) const;

    /// \pre one is watched
    void go_to(std::size_t place);
    void play(bool is_on); ///< from the beginning, where it is at its end
    void change_speed(double factor);
    void tick(double seconds); ///< takes the steps that are due

    bool is_playing() const { return player_ != nullptr && is_playing_; }
    double speed = 1.0;

private:
    std::shared_ptr<const Solution> solution_;
    std::shared_ptr<discretize::MeshPlayer> player_;
    bool is_playing_ = false;
    double due_ = 0.0; ///< steps
};

} // namespace plane
