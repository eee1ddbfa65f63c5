#include "ui/context/imgui_session.h"

#include "ui/context/draw_list_surface.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr float double_click_time = 0.5F; // s between two presses, as desktops have it
constexpr float line_of_em = 1.164F;      // Dear ImGui gives type by the height of a line, ascender to descender

/// Characters that widgets can show: European letters, Greek, punctuation, arrows, mathematics and shapes, and the sign
/// for all others.
constexpr ImWchar glyph_ranges[] = {0x0020, 0x024F, 0x02B0, 0x02DF, 0x0370, 0x03FF, 0x0400, 0x052F, 0x1E00,
                                    0x1EFF, 0x2010, 0x2027, 0x2030, 0x205E, 0x2070, 0x209F, 0x20A0, 0x20BF,
                                    0x2100, 0x214F, 0x2190, 0x21FF, 0x2200, 0x23FF, 0x25A0, 0x25FF, 0x2713,
                                    0x2718, 0x27C0, 0x27EF, 0xFFFD, 0xFFFD, 0};

ImVec4 vec(Color c)
{
    const auto part = [](std::uint8_t v) { return static_cast<float>(v) / 255.0F; };
    return {part(c.r), part(c.g), part(c.b), part(c.a)};
}

constexpr std::pair<int, Key> key_map[] = {{ImGuiKey_Tab, Key::Tab},
                                           {ImGuiKey_LeftArrow, Key::Left},
                                           {ImGuiKey_RightArrow, Key::Right},
                                           {ImGuiKey_UpArrow, Key::Up},
                                           {ImGuiKey_DownArrow, Key::Down},
                                           {ImGuiKey_PageUp, Key::PageUp},
                                           {ImGuiKey_PageDown, Key::PageDown},
                                           {ImGuiKey_Home, Key::Home},
                                           {ImGuiKey_End, Key::End},
                                           {ImGuiKey_Delete, Key::Delete},
                                           {ImGuiKey_Backspace, Key::Backspace},
                                           {ImGuiKey_Space, Key::Space},
                                           {ImGuiKey_Enter, Key::Enter},
                                           {ImGuiKey_Escape, Key::Escape},
                                           {ImGuiKey_A, Key::A},
                                           {ImGuiKey_C, Key::C},
                                           {ImGuiKey_V, Key::V},
                                           {ImGuiKey_X, Key::X},
                                           {ImGuiKey_Y, Key::Y},
                                           {ImGuiKey_Z, Key::Z}};

/// Colours of widgets, all mixed from the theme's background, its ink and its colour of selection.
void set_colors(ImGuiStyle& style, const Theme& theme)
{
    const Color back = theme.background(), ink = theme[Role::Label].text, accent = theme[Role::Selection].stroke.color;
    const auto shade = [&](double t) { return vec(mixed(back, ink, t)); };
    const auto tint = [&](double t) { return vec(mixed(back, accent, t)); };
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = vec(ink);
    c[ImGuiCol_TextDisabled] = vec(theme[Role::FaintLabel].text);
    c[ImGuiCol_WindowBg] = c[ImGuiCol_ChildBg] = shade(0.03);
    c[ImGuiCol_PopupBg] = c[ImGuiCol_MenuBarBg] = shade(0.04);
    c[ImGuiCol_Border] = c[ImGuiCol_Separator] = c[ImGuiCol_TableBorderStrong] = shade(0.20);
    c[ImGuiCol_TableBorderLight] = shade(0.12);
    c[ImGuiCol_TableHeaderBg] = c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgCollapsed] = shade(0.08);
    c[ImGuiCol_TitleBgActive] = c[ImGuiCol_Tab] = c[ImGuiCol_TabUnfocused] = shade(0.12);
    c[ImGuiCol_TableRowBgAlt] = vec(with_opacity(ink, 0.03));
    c[ImGuiCol_FrameBg] = shade(0.09);
    c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_HeaderHovered] = c[ImGuiCol_TabHovered] = tint(0.30);
    c[ImGuiCol_FrameBgActive] = c[ImGuiCol_HeaderActive] = tint(0.40);
    c[ImGuiCol_Header] = c[ImGuiCol_TabActive] = c[ImGuiCol_TabUnfocusedActive] = tint(0.20);
    c[ImGuiCol_Button] = shade(0.12);
    c[ImGuiCol_ButtonHovered] = tint(0.30);
    c[ImGuiCol_ButtonActive] = tint(0.45);
    c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = c[ImGuiCol_PlotLines] = c[ImGuiCol_PlotHistogram] = vec(accent);
    c[ImGuiCol_SliderGrabActive] = c[ImGuiCol_NavHighlight] = c[ImGuiCol_DragDropTarget] = vec(accent);
    c[ImGuiCol_ScrollbarBg] = shade(0.05);
    c[ImGuiCol_ScrollbarGrab] = shade(0.25);
    c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_ResizeGripHovered] = tint(0.5);
    c[ImGuiCol_ScrollbarGrabActive] = c[ImGuiCol_SeparatorActive] = c[ImGuiCol_ResizeGripActive] = tint(0.7);
    c[ImGuiCol_ResizeGrip] = shade(0.2);
    c[ImGuiCol_TextSelectedBg] = vec(with_opacity(accent, 0.35));
    c[ImGuiCol_ModalWindowDimBg] = c[ImGuiCol_NavWindowingDimBg] = vec(with_opacity(rgb(0x000000), 0.35));
}

} // namespace

ImGuiSession::ImGuiSession(Context& context, const Fonts& fonts, const Theme& theme)
    : context_(context),
      fonts_(fonts),
      theme_(theme),
      scale_(wanted_scale()),
      imgui_(ImGui::CreateContext()),
      renderer_(context),
      atlas_(fonts)
{
    ImGui::SetCurrentContext(imgui_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset | ImGuiBackendFlags_HasMouseCursors;
    io.MouseDoubleClickTime = double_click_time;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    for (const auto& [theirs, ours] : key_map) io.KeyMap[theirs] = static_cast<int>(ours);
    io.ClipboardUserData = this;
    io.GetClipboardTextFn = [](void* user) {
        auto& session = *static_cast<ImGuiSession*>(user);
        if (session.clipboard_.text) session.copied_ = session.clipboard_.text();
        return session.copied_.c_str();
    };
    io.SetClipboardTextFn = [](void* user, const char* text) {
        auto& session = *static_cast<ImGuiSession*>(user);
        session.copied_ = text;
        if (session.clipboard_.set_text) session.clipboard_.set_text(session.copied_);
    };
    load_type();
    set_style();
}

ImGuiSession::~ImGuiSession() { ImGui::DestroyContext(imgui_); }

void ImGuiSession::set_theme(const Theme& theme)
{
    theme_ = theme;
    is_stale_ = true;
}

double ImGuiSession::wanted_scale() const
{
    if (theme_.name() != ThemeName::Projector) return context_.scale();
    constexpr Size roomy{1120.0, 720.0}; // for the projector's type
    constexpr double least = 0.65;       // type is then as large as that of a desk
    constexpr double step = 0.05;        // a window that is being made smaller does not load its type for each pixel
    const Size window = logical_size(context_);
    const double share = std::min({1.0, window.width / roomy.width, window.height / roomy.height});
    return context_.scale() * std::max(least, step * std::floor(share / step + 1e-9));
}

void ImGuiSession::load_type()
{
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoMouseCursors;
    const auto add = [&](Weight weight, double em) {
        const auto file = fonts_.file(weight);
        ImFontConfig config;
        config.FontDataOwnedByAtlas = false;
        config.OversampleH = 2;
        config.OversampleV = 1;
        const float height = std::round(static_cast<float>(em * scale_) * line_of_em);
        return atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(file.data()), static_cast<int>(file.size()),
                                          height, &config, glyph_ranges);
    };
    regular_ = add(Weight::Regular, theme_.type().normal);
    bold_ = add(Weight::Bold, theme_.type().normal);
    large_ = add(Weight::Bold, theme_.type().large);
    unsigned char* pixels = nullptr;
    atlas.GetTexDataAsAlpha8(&pixels, &type_image_.width, &type_image_.height);
    type_image_.pixels.assign(pixels, pixels + static_cast<std::ptrdiff_t>(type_image_.width) * type_image_.height);
    ++type_image_.version;
    atlas.ClearTexData();
    atlas.SetTexID(&type_image_);
}

void ImGuiSession::set_style()
{
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    set_colors(style, theme_);
    style.WindowRounding = style.PopupRounding = 4.0F;
    style.FrameRounding = style.GrabRounding = style.TabRounding = 3.0F;
    style.FramePadding = {6.0F, 3.0F};
    style.ItemSpacing = {8.0F, 5.0F};
    style.ScrollbarSize = 12.0F;
    style.ScaleAllSizes(static_cast<float>(scale_));
}

void ImGuiSession::feed(const Input& input)
{
    ImGuiIO& io = ImGui::GetIO();
    const PixelSize size = context_.size();
    io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    io.DeltaTime = std::max(1e-4F, static_cast<float>(input.seconds));
    io.MousePos = {-FLT_MAX, -FLT_MAX};
    if (input.pointer)
        io.MousePos = {static_cast<float>(context_.scale() * input.pointer->x),
                       static_cast<float>(context_.scale() * input.pointer->y)};
    for (std::size_t i = 0; i < n_pointer_buttons; ++i)
        if (input.since_press && input.is_button_down[i] && !io.MouseDown[i])
            io.MouseClickedTime[i] = imgui_->Time + static_cast<double>(io.DeltaTime) - *input.since_press;
    std::copy(input.is_button_down.begin(), input.is_button_down.end(), io.MouseDown);
    io.MouseWheel += static_cast<float>(input.wheel.y);
    io.MouseWheelH += static_cast<float>(input.wheel.x);
    // A chord that is over before the frame ends is seen all the same.
    const auto held_ctrl = [](const KeyEvent& event) { return event.is_down && event.modifiers.ctrl; };
    io.KeyCtrl = input.modifiers.ctrl || std::ranges::any_of(input.keys, held_ctrl);
    io.KeyShift = input.modifiers.shift;
    io.KeyAlt = input.modifiers.alt;
    if (input.has_lost_focus) io.AddFocusEvent(false);
    feed_keys(input.keys);
    if (!input.text.empty()) io.AddInputCharactersUTF8(input.text.c_str());
}

/// A key that goes down and up within one frame goes up in the next one, so that its stroke is seen.
void ImGuiSession::feed_keys(const std::vector<KeyEvent>& events)
{
    std::vector<KeyEvent> all = std::exchange(waiting_keys_, {});
    all.insert(all.end(), events.begin(), events.end());
    std::array<bool, n_keys> has_changed{};
    for (const KeyEvent& event : all) {
        if (event.key == Key::Tab && event.is_down && event.modifiers.ctrl)
            continue; // Dear ImGui would list its windows
        const auto key = static_cast<std::size_t>(meant(event));
        if (has_changed[key]) {
            waiting_keys_.push_back(event);
            continue;
        }
        ImGui::GetIO().KeysDown[key] = event.is_down;
        has_changed[key] = true;
    }
}

// Enter chooses in menus and lists, where Dear ImGui hears the space bar alone.
Key ImGuiSession::meant(const KeyEvent& event)
{
    if (event.key != Key::Enter) return event.key;
    if (event.is_down) {
        const ImGuiWindow* const window = imgui_->NavWindow;
        const bool is_list = window != nullptr && (window->Flags & ImGuiWindowFlags_Popup) != 0;
        is_enter_space_ = is_list && (window->Flags & ImGuiWindowFlags_Modal) == 0;
    }
    return is_enter_space_ ? Key::Space : Key::Enter;
}

Typing::Reader ImGuiSession::reader() const
{
    return imgui_->IO.WantTextInput ? Typing::Reader::Field : Typing::Reader::Keys;
}

void ImGuiSession::look_for_field()
{
    const bool is_asked_for = imgui_->NavMoveSubmitted && (imgui_->NavMoveFlags & ImGuiNavMoveFlags_FocusApi) != 0;
    awaits_field_ = is_asked_for || imgui_->NavNextActivateId != 0;
    unread_text_.clear();
    if (!awaits_field_) return;
    for (const ImWchar letter : imgui_->IO.InputQueueCharacters) {
        std::array<char, 5> utf8{};
        unread_text_ += ImTextCharToUtf8(utf8.data(), letter);
    }
}

namespace {

bool is_escaping(const ImGuiIO& io)
{
    constexpr auto escape = static_cast<std::size_t>(Key::Escape);
    return io.KeysDownDuration[escape] >= 0.0F || io.KeysDownDurationPrev[escape] >= 0.0F;
}

/// In the frame before: it was shown there, and is open no more.
bool has_popup_closed(const ImGuiContext& gui)
{
    return std::ranges::any_of(gui.Windows, [&](const ImGuiWindow* window) {
        if ((window->Flags & ImGuiWindowFlags_Popup) == 0 || !window->WasActive) return false;
        return std::ranges::none_of(gui.OpenPopupStack,
                                    [&](const ImGuiPopupData& popup) { return popup.Window == window; });
    });
}

// Escape leaves a panel for the window around it, a dialog that closes gives the keyboard back to that window, and the
// panel would be framed like something that has the keyboard.
void unframe_panels(ImGuiContext& gui)
{
    if (!is_escaping(gui.IO) && !has_popup_closed(gui)) return;
    for (const ImGuiWindow* const window : gui.Windows)
        if (window->ChildId != 0 && window->ChildId == gui.NavId) gui.NavId = 0;
}

} // namespace

bool ImGuiSession::is_widget_framed() const { return imgui_->NavId != 0 && !imgui_->NavDisableHighlight; }

void ImGuiSession::unframe_widget()
{
    if (is_widget_framed()) imgui_->NavDisableHighlight = true;
}

void ImGuiSession::begin_frame(const Input& input, bool keeps_panels_still)
{
    ImGui::SetCurrentContext(imgui_);
    atlas_.trim();
    if (is_stale_ || wanted_scale() != scale_) { // or the window went to another screen
        scale_ = wanted_scale();
        load_type();
        set_style();
        is_stale_ = false;
    }
    feed(input);
    ImGuiIO& io = ImGui::GetIO();
    const ImGuiConfigFlags flags = io.ConfigFlags;
    if (keeps_panels_still) io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::NewFrame();
    io.ConfigFlags = flags;
    unframe_panels(*imgui_);
}

void ImGuiSession::end_frame()
{
    ImGui::SetCurrentContext(imgui_);
    look_for_field();
    ImGui::Render();
    context_.make_current();
    renderer_.render(*ImGui::GetDrawData(), theme_.background());
}

void ImGuiSession::show(const Picture& picture, ImDrawList& list, Point corner)
{
    DrawListSurface surface(list, atlas_, {.origin = corner, .scale = scale_});
    picture.draw_on(surface);
}

} // namespace ui
