#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/option_parser.h"
#include "apps/cli/picture_file.h"
#include "apps/plane/discretize/mesh_player.h"
#include "apps/plane/view/plate_picture.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/io/plane/plane_file.h"

namespace cli {

/// What `cremona render` does with a plane model, and the options that only such a model has.
class PlaneRender {
public:
    struct Order {
        PictureFile file;
        bool has_file = true;                    ///< else it is only described
        std::optional<std::string> model_file{}; ///< beside which its view file stands; none: standard input
        std::optional<std::string> show, load_case;
        std::optional<std::size_t> mechanism{}; ///< which motion, of a body that can move; from 0
        ::plane::PlateOptions look;             ///< theme, units, language, scale of displacements
    };

    void declare(OptionParser& options,
                 const ui::Catalogue& tr);              ///< \pre `--at` is declared: it says a place of either
    void require_none(const ui::Catalogue& tr) const;   ///< \throws UsageError if an option is given: no plane model
    bool is_described() const { return is_described_; } ///< so that it needs no output
    /// \param name  of the file, as messages call it  \throws UsageError
    ExitStatus draw(femoop::plane::PlaneReading& reading, const std::string& name, const Order& order,
                    Console& console) const;

private:
    bool is_modal(const ui::Catalogue& tr) const; ///< of --analysis. \throws UsageError
    void require_modes_alone(const Order& order, const ui::Catalogue& tr) const;
    ExitStatus draw_mode(::plane::PlateInput shown, ::plane::PlateOptions options, const std::string& name,
                         const Order& order, Console& console) const;
    ExitStatus draw_motion(::plane::PlateInput shown, const femoop::MechanismError& error, const std::string& name,
                           const Order& order, const ::plane::PlateOptions& options, Console& console) const;
    ExitStatus write(const ::plane::PlateInput& input, const Order& order, const ::plane::PlateOptions& options,
                     Console& console) const;
    std::vector<std::string> places() const;
    std::unique_ptr<discretize::MeshPlayer> player_at_step(const discretize::Drawing* drawing,
                                                           const ui::Catalogue& tr) const;

    std::optional<DeclaredOption> at_;
    void look(::plane::PlateOptions& options, const Order& order, const ui::Catalogue& tr) const;

    std::vector<std::string> cuts_;
    std::optional<std::string> range_, read_;
    std::optional<std::string> step_, analysis_, mode_;
    bool is_described_ = false;
};

} // namespace cli
