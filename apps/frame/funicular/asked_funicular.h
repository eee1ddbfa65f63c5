#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/drawing/draw_options.h"
#include "apps/drawing/results/funicular_picture.h"
#include "femoop/methods/funicular/loaded_chain.h"
#include "femoop/model/model.h"

namespace frame {

/// The funicular that is looked at. It is no part of the document: it is not saved, nor undone, and belongs to the tab
/// that it was asked in. It follows the model and the load case that is shown: members are known by their names, the ends
/// of its closing line by their heights over the chain's, and its rise stays whatever the loads are.
class AskedFunicular {
public:
    bool is_on(const femoop::Model& model) const;
    void clear();
    /// Grows whenever another one is asked for.
    std::size_t number() const { return number_; }

    /// \param members  the links of its chain; none: the one that is shown, else the only chain of the structure
    void ask(const femoop::Model& model, const std::vector<femoop::MemberId>& members);
    /// A click on a member: alone, or as one more link or one less.
    void pick(const femoop::Model& model, femoop::MemberId member, bool adds);

    /// \pre there is a last picture
    void drag(drawing::FunicularHandle handle, double height);
    void read_at(std::optional<double> x);
    void reach_for(std::optional<drawing::FunicularHandle> handle);
    bool has_crown() const { return basis_ && basis_->chain.crown(); } ///< of the last picture
    void lead_through_crown();                                         ///< and through the ends of the chain

    /// Null where none is looked at, or where `why_none` says why.
    /// \param generation  grows whenever the model changes \pre the model can be discretised
    const drawing::FunicularPicture* picture(const femoop::Model& model, std::uint64_t generation,
                                             const drawing::DrawOptions& options) const;
    /// The last one; null where there was none.
    const drawing::FunicularPicture* last() const { return picture_ ? &*picture_ : nullptr; }
    /// Of the last picture that was asked for; empty where there was one.
    const std::string& why_none() const { return why_none_; }

private:
    std::vector<femoop::MemberId> members(const femoop::Model& model) const;
    void find(const femoop::Model& model, const drawing::DrawOptions& options) const;
    void draw(const femoop::Model& model, const drawing::DrawOptions& options) const;
    std::vector<std::string> sentences(const femoop::Model& model, const drawing::DrawOptions& options) const;
    femoop::funicular::Funicular funicular() const;

    bool is_on_ = false;
    std::size_t number_ = 0;
    std::vector<std::string> members_;         ///< none: the only chain
    femoop::funicular::ClosingLine over_ends_; ///< height over the ends of the chain
    std::optional<double> rise_;               ///< nothing: the usual one
    std::optional<double> reading_;
    std::optional<drawing::FunicularHandle> in_reach_;
    /// What the last picture is of.
    struct Subject {
        std::uint64_t generation;
        femoop::CaseId load_case;
        ui::Language language;
        femoop::Units units; ///< of its sentences

        friend bool operator==(const Subject&, const Subject&) = default;
    };
    mutable std::optional<Subject> subject_;                      ///< nothing after another was asked for
    mutable std::optional<femoop::funicular::LoadedChain> basis_; ///< does not change as the hand drags
    mutable std::string why_none_;
    mutable std::optional<drawing::FunicularPicture> picture_;
    mutable bool is_stale_ = false; ///< the picture, of a hand that has dragged since
};

} // namespace frame
