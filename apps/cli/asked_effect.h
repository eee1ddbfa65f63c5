#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/option_parser.h"
#include "femoop/model/model.h"

namespace cli {

/// An effect of a moving load that options ask for: --member M --at X --component C, or --node N --component C.
class AskedEffect {
public:
    void declare(OptionParser& options, const ui::Catalogue& tr);

    /// What the option that has it as a text takes: messages offer no other components. Numbers has the resultant R of a
    /// reaction in the plane, too.
    enum class Takes { Anything, Forces, Displacements, Numbers };
    /// The same in one text: member=M,at=X,component=C or node=N,component=C. \throws UsageError naming `option`
    void set(std::string_view option, std::string_view text, const ui::Catalogue& tr, Takes takes = Takes::Anything);

    bool is_asked() const { return member_ || node_ || component_ || at_; }
    bool is_place_alone() const { return at_ && !member_ && !node_ && !component_; }
    std::string option() const; ///< by which messages name it
    std::string text() const;   ///< "BC M 50%"

    /// Where --at may be missing the effect is the extreme along the member.
    enum class Place { Needed, Optional };
    /// \throws UsageError for options that do not go together
    void require_sensible(const ui::Catalogue& tr, Place place = Place::Needed) const;
    /// \throws UsageError for a name that the model lacks; what else is wrong `check_line` says
    femoop::MovingEffect effect(const femoop::Model& model, const ui::Catalogue& tr) const;
    /// Likewise. \throws ModelError for what `check_effect` finds wrong, too
    femoop::MovingEffect sound_effect(const femoop::Model& model, const ui::Catalogue& tr) const;

private:
    femoop::Position place(const femoop::Model& model) const;

    std::string named(std::string_view key) const; ///< "--member", or "--why member" in one text

    Takes takes_ = Takes::Anything;
    std::string within_; ///< the option whose text it is; empty where each part has an option of its own
    std::optional<std::string> member_, node_, component_, at_;
};

/// A place along a member of this length: a length from its first end, or a part of it like 50%. \throws ModelError
double place_named(std::string_view option, const std::string& text, double length, const femoop::Model& model);

/// A length that an option gives: a number in the model's unit, or one with its own. \throws ModelError
femoop::Quantity length_named(std::string_view option, const std::string& text, const femoop::Model& model);

/// So many of them, with commas between. \throws ModelError, UsageError where there are more or fewer
std::vector<double> lengths_named(std::string_view option, const std::string& text, std::size_t wanted,
                                  const femoop::Model& model, const ui::Catalogue& tr);

/// \throws UsageError for lengths so far off that the structure would shrink to a point beside them.
void require_near(std::string_view option, const std::string& found, std::span<const double> lengths,
                  const femoop::Model& model, const ui::Catalogue& tr);

/// A path of the file by its id, else members by theirs: m1,m2. \throws UsageError
femoop::LoadPathReference path_named(const femoop::Model& model, const std::string& name, const ui::Catalogue& tr);

/// The only path that the file has, or that of its block `influence`. \throws ModelError if there is none, or more
femoop::LoadPathReference only_path(const femoop::Model& model);

} // namespace cli
