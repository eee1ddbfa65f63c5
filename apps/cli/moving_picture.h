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

/// What is told of a train.
struct TrainTold {
    std::optional<femoop::MovingEffect> effect; ///< none: the one that `render` draws
    bool is_proved = false;                     ///< also how it was found
};
/// A train likewise, with the line that it stands on: where it is worst for the effect, what of it stands where, and
/// what that comes to. \throws ModelError
std::string train_in_words(const femoop::Model& model, const femoop::Train& train, const TrainTold& told,
                           const drawing::DrawOptions& options, const std::string& file, const Console& console);

/// An envelope: of one effect the largest and the least value, the train that makes each and how it stands; where none is
/// asked, of each component the largest and the least of all members, and of each reaction. \throws ModelError
std::string envelope_in_words(const femoop::Model& model, const femoop::MovingEnvelope& envelope,
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
