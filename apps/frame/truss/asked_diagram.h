#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "apps/drawing/draw_options.h"
#include "apps/drawing/truss/cremona_picture.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"
#include "ui/text/catalogue.h"

namespace frame {

/// The Cremona diagram that is looked at, and how far it is drawn. It is no part of the document: it is not saved, nor
/// undone, and belongs to the tab that it was asked in. It follows the model and the load case that is shown.
class AskedDiagram {
public:
    bool is_on() const { return is_on_; }
    void show(); ///< whole
    void close() { is_on_ = false; }

    /// One stage on or back: after the last one it begins again, before the first one stands the last.
    enum class Way : std::uint8_t { On, Back };
    void step(Way way);

    /// The diagram of the model as it is; null where it is not looked at, or where `why_none` says why.
    /// \param results     of the model; null: there are none, and others say why
    /// \param generation  grows whenever the model changes
    const drawing::CremonaPicture* picture(const femoop::Model& model, const femoop::Results* results,
                                           std::uint64_t generation, const drawing::DrawOptions& options) const;
    /// Of the last picture that was asked for; empty where there was one.
    const std::string& why_none() const { return found_.why_none; }

private:
    struct Found {
        std::uint64_t generation = 0;
        femoop::CaseId load_case;
        std::optional<ui::Language> language;
        std::optional<drawing::CremonaPicture> picture;
        std::string why_none;
    };
    void find(const femoop::Model& model, const femoop::Results& results, const drawing::DrawOptions& options) const;
    std::size_t n_stages() const { return found_.picture ? found_.picture->diagram.steps.size() : 0; }

    bool is_on_ = false;
    std::optional<std::size_t> stage_; ///< from 1; nothing: the last one
    mutable Found found_;
};

} // namespace frame
