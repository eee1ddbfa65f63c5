#pragma once

#include "femoop/methods/truss/reciprocal.h"
#include "femoop/model/model.h"
#include "ui/text/catalogue.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drawing {

/// By which method a truss is worked out by hand.
enum class TrussMethod : std::uint8_t { ZeroForces, Joints, Cremona };

/// What one stage shows.
struct TrussStage {
    std::vector<std::string> lines;                ///< for the foot of the sheet
    std::string title{};                           ///< for a list of the stages
    std::optional<femoop::NodeId> joint{};         ///< that it is about
    std::vector<femoop::MemberId> lit{};           ///< bars that are new, or cut
    std::vector<femoop::MemberId> found{};         ///< bars whose force is known from here on
    std::optional<std::size_t> step{};             ///< of JointMethod::steps, where it goes joint by joint
    std::optional<Eigen::Vector2d> ritter_point{}; ///< of a section that helps
};

/// A plane truss worked out by hand, as far as it has come.
struct TrussPicture {
    TrussMethod method = TrussMethod::Cremona;
    femoop::truss::Truss truss{};
    femoop::truss::Arrangement arrangement{};
    femoop::truss::JointMethod joints{};
    std::optional<femoop::truss::Reciprocal> diagram{}; ///< Cremona's alone
    std::vector<TrussStage> stages{};                   ///< not empty
    std::vector<std::string> bar_sentences{};           ///< of every bar, once it is found
    std::size_t n_stages = 0;                           ///< that are drawn, from 1

    const TrussStage& stage() const { return stages[n_stages - 1]; } ///< the last one that is drawn
    bool is_found(femoop::MemberId bar) const;                       ///< at a stage that is drawn
};

/// Why the method cannot work on a truss, if so. What no method can is told by femoop::truss::why_no_truss.
std::optional<femoop::truss::Refusal> why_not(TrussMethod method, const femoop::truss::Truss& truss);

/// With all stages. \pre why_not says nothing
TrussPicture truss_picture(TrussMethod method, const femoop::Model& model, const femoop::truss::Truss& truss,
                           const ui::Catalogue& tr);

} // namespace drawing
