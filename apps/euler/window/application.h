#pragma once

#include <string>
#include <vector>

#include "apps/euler/session/commands.h"
#include "apps/euler/window/canvas.h"
#include "apps/euler/window/operators_panel.h"
#include "apps/euler/window/script_panel.h"
#include "apps/euler/window/tables_panel.h"
#include "ui/app/document_app.h"

extern template class ui::DocumentApp<euler::Workspace>;

namespace euler {

/// The stepper on a context, on the screen or off it.
class Application final : public ui::DocumentApp<Workspace> {
public:
    /// \pre context and fonts outlive the application
    Application(ui::Context& context, const ui::Fonts& fonts, Session session);

    const Canvas& canvas() const { return canvas_; }

private:
    ui::Picture picture() override { return canvas_.picture_of(session()); }
    /// An operator that asks has the keyboard until it is done or given up.
    bool is_typing() const override { return session().draft() || (shows_script() && script_.is_typing()); }
    void settle_fields() override;
    bool refuses_text() const override { return shows_script() && script_.has_line(); }
    bool shows_script() const { return workspace().has_panels && workspace().topic == Topic::Script; }
    void fit() override { workspace().session.is_fitted = true; }
    void zoom(double factor) override { canvas_.zoom(workspace().session, factor); }
    void handle_own_requests() override;
    void show_body() override;
    void show_left() override;
    void show_right() override;
    void show_canvas() override;
    void follow_draft();
    void show_status() const override;
    std::string words() const override;
    std::vector<std::string> own_look() const override { return {"--step", std::to_string(session().step())}; }

    Canvas canvas_;
    ScriptPanel script_;
    OperatorsPanel operators_;
    TablesPanel tables_;
    float tables_height_ = 15.0F;
};

} // namespace euler
