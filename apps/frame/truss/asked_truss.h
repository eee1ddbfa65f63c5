#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/drawing/draw_options.h"
#include "apps/drawing/truss/truss_picture.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"
#include "ui/text/catalogue.h"

namespace frame {

/// The truss that is worked out by hand, by which method, and how far it has come. It is no part of the document: it is
/// not saved, nor undone, and belongs to the tab that it was asked in. It follows the model and the load case that is
/// shown.
class AskedTruss {
public:
    using Method = drawing::TrussMethod;

    bool is_on() const { return method_.has_value(); }
    std::optional<Method> method() const { return method_; }
    void show(Method method); ///< a Cremona diagram whole, the others from their first stage on
    void close() { method_.reset(); }

    /// One stage on or back, between the first one and the last; on from a diagram that was shown whole: the first.
    enum class Way : std::uint8_t { On, Back };
    void step(Way way);
    void go_to(std::size_t stage) { stage_ = stage; } ///< from 1; beyond the last: the last

    /// The truss as it is; null where none is looked at, or where `why_none` says why.
    /// \param results     of the model; null: there are none, and others say why
    /// \param generation  grows whenever the model changes
    const drawing::TrussPicture* picture(const femoop::Model& model, const femoop::Results* results,
                                         std::uint64_t generation, const drawing::DrawOptions& options) const;
    /// Of the last picture that was asked for; empty where there was one.
    const std::string& why_none() const { return found_.why_none; }

private:
    struct Found {
        std::uint64_t generation = 0;
        std::optional<Method> method;
        femoop::CaseId load_case;
        std::optional<ui::Language> language;
        femoop::Units units; ///< of its sentences
        std::optional<drawing::TrussPicture> picture;
        std::string why_none;
    };
    void find(const femoop::Model& model, const femoop::Results& results, const drawing::DrawOptions& options) const;
    std::size_t n_stages() const { return found_.picture ? found_.picture->stages.size() : 0; }

    std::optional<Method> method_;
    std::optional<std::size_t> stage_; ///< from 1; nothing: the last one
    mutable Found found_;
};

} // namespace frame
