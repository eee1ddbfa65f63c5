#pragma once

#include <optional>
#include <string>

#include "apps/cli/asked_effect.h"
#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/option_parser.h"
#include "apps/cli/picture.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/model/model.h"

namespace cli {

/// An influence line for a reader who cannot see it: what it is of, its extremes with their places, its areas.
std::string line_in_words(const femoop::Model& model, const femoop::InfluenceLineDefinition& definition,
                          const femoop::influence::InfluenceLine& line, const drawing::DrawOptions& options);

/// A train likewise, with the line that it stands on: where it is worst for the effect, or for the one that `render`
/// draws where none is asked for; what of it stands where, and what that comes to. \throws ModelError
std::string train_in_words(const femoop::Model& model, const femoop::Train& train,
                           const std::optional<femoop::MovingEffect>& asked, const drawing::DrawOptions& options,
                           const std::string& file, const Console& console);

/// On stderr, where the support does not hold the reaction that is asked for, or holds the displacement: the zeros would
/// be taken for an answer.
void warn_of_zero_by_support(const femoop::Model& model, const femoop::MovingEffect& effect, const std::string& file,
                             const Console& console);

/// What options of `render` ask for of loads that move: one influence line, or one train.
class MovingPicture {
public:
    void declare(OptionParser& options, const ui::Catalogue& tr);
    bool is_asked() const { return line_ || train_ || position_ || effect_.is_asked(); }
    /// `--at` alone says where a plane model is looked at.
    bool is_of_members() const { return is_asked() && (line_ || train_ || position_ || !effect_.is_place_alone()); }
    /// \throws UsageError for options that do not go together
    void require_sensible(const ui::Catalogue& tr) const;

    /// Draws the line on the structure; or the train where it is worst, or where it is asked for, with the line of the
    /// effect and what the structure does under it. \param shows_own  the order says itself what is shown
    ExitStatus draw(const femoop::Model& model, const std::string& file, PictureOrder order, bool shows_own,
                    const Console& console) const;

private:
    std::optional<std::string> line_, train_, position_;
    AskedEffect effect_;
};

} // namespace cli
