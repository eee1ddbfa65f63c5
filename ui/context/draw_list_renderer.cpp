#include "ui/context/draw_list_renderer.h"

#include "ui/paint/surface/alpha_image.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace ui {

namespace {

// A vertex of a Mesh's line or disc gives how far it lies across and, negated, its reach in place of a texture's place.
// frame = (left, top, 2 / width, 2 / height) of the part of the plane that is seen.
constexpr const char* vertex_source = R"(#version 330 core
layout(location = 0) in vec2 place;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;
uniform vec4 frame;
out vec2 frag_uv;
out vec4 frag_color;
void main()
{
    frag_uv = uv;
    frag_color = color;
    gl_Position = vec4((place.x - frame.x) * frame.z - 1.0, 1.0 - (place.y - frame.y) * frame.w, 0.0, 1.0);
}
)";

// Text and widgets, with an image; it draws lines and areas too.
constexpr const char* image_source = R"(#version 330 core
in vec2 frag_uv;
in vec4 frag_color;
uniform sampler2D image;
layout(location = 0) out vec4 result;
void main()
{
    float coverage = texture(image, max(frag_uv, vec2(0.0))).r;
    if (frag_uv.y < 0.0) coverage = clamp(-frag_uv.y - abs(frag_uv.x), 0.0, 1.0);
    result = vec4(frag_color.rgb, frag_color.a * coverage);
}
)";

// Lines and areas alone: a software renderer is much faster where it need not look into an image.
constexpr const char* plain_source = R"(#version 330 core
in vec2 frag_uv;
in vec4 frag_color;
layout(location = 0) out vec4 result;
void main()
{
    float coverage = frag_uv.y < 0.0 ? clamp(-frag_uv.y - abs(frag_uv.x), 0.0, 1.0) : 1.0;
    result = vec4(frag_color.rgb, frag_color.a * coverage);
}
)";

gl::Uint compiled(const gl::Functions& gl, gl::Enum kind, const char* source)
{
    const gl::Uint shader = gl.CreateShader(kind);
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    gl::Int is_good = 0;
    gl.GetShaderiv(shader, gl::compile_status, &is_good);
    if (is_good) return shader;
    std::array<char, 1024> words{};
    gl.GetShaderInfoLog(shader, static_cast<gl::Sizei>(words.size()), nullptr, words.data());
    gl.DeleteShader(shader);
    throw ContextError("OpenGL: the driver refuses a shader: " + std::string(words.data()));
}

gl::Uint linked(const gl::Functions& gl, const char* fragment_source)
{
    const gl::Uint vertex = compiled(gl, gl::vertex_shader, vertex_source);
    const gl::Uint fragment = compiled(gl, gl::fragment_shader, fragment_source);
    const gl::Uint program = gl.CreateProgram();
    gl.AttachShader(program, vertex);
    gl.AttachShader(program, fragment);
    gl.LinkProgram(program);
    gl.DeleteShader(vertex);
    gl.DeleteShader(fragment);
    gl::Int is_good = 0;
    gl.GetProgramiv(program, gl::link_status, &is_good);
    if (is_good) return program;
    std::array<char, 1024> words{};
    gl.GetProgramInfoLog(program, static_cast<gl::Sizei>(words.size()), nullptr, words.data());
    gl.DeleteProgram(program);
    throw ContextError("OpenGL: the driver refuses the program: " + std::string(words.data()));
}

const void* offset_of(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); } // NOLINT: as OpenGL asks

struct Scissor {
    int x, y, width, height; // from the bottom left corner
};

Scissor scissor(const ImDrawCmd& command, const ImDrawData& data)
{
    const float left = std::max(command.ClipRect.x - data.DisplayPos.x, 0.0F);
    const float top = std::max(command.ClipRect.y - data.DisplayPos.y, 0.0F);
    const float right = std::min(command.ClipRect.z - data.DisplayPos.x, data.DisplaySize.x);
    const float bottom = std::min(command.ClipRect.w - data.DisplayPos.y, data.DisplaySize.y);
    const auto whole = [](float v) { return static_cast<int>(std::lround(v)); };
    return {whole(left), whole(data.DisplaySize.y - bottom), whole(right) - whole(left), whole(bottom) - whole(top)};
}

} // namespace

namespace {

/// How many of the command's first indices belong to an opaque rectangle along the axes, such as a window's
/// background: 6 or none. A software renderer fills it several times faster without image and blending.
unsigned n_of_background(const ImDrawList& list, const ImDrawCmd& command)
{
    constexpr unsigned n = 6; // of Dear ImGui's rectangle: 0 1 2, 0 2 3
    if (command.ElemCount < n) return 0;
    const auto* const indices = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawVert* const corners = list.VtxBuffer.Data + command.VtxOffset + indices[0];
    constexpr std::array<unsigned, n> of_rectangle = {0, 1, 2, 0, 2, 3};
    for (unsigned i = 0; i < n; ++i)
        if (indices[i] != indices[0] + of_rectangle[i]) return 0;
    const auto is_like_first = [&](const ImDrawVert& v) {
        return v.col == corners[0].col && v.uv.x == corners[0].uv.x && v.uv.y == corners[0].uv.y;
    };
    const bool is_plain = std::all_of(corners, corners + 4, is_like_first) && corners[0].col >> IM_COL32_A_SHIFT == 255;
    const bool is_level = corners[0].pos.y == corners[1].pos.y && corners[1].pos.x == corners[2].pos.x &&
                          corners[2].pos.y == corners[3].pos.y && corners[3].pos.x == corners[0].pos.x;
    return is_plain && is_level ? n : 0;
}

} // namespace

DrawListRenderer::DrawListRenderer(Context& context) : context_(context)
{
    context_.make_current();
    const auto& gl = context_.gl();
    const auto program = [&](const char* source) {
        const gl::Uint name = linked(gl, source);
        return Program{name, gl.GetUniformLocation(name, "frame")};
    };
    plain_ = program(plain_source);
    image_ = program(image_source);
    gl.UseProgram(image_.name);
    gl.Uniform1i(gl.GetUniformLocation(image_.name, "image"), 0);
    gl.GenVertexArrays(1, &vertex_array_);
    gl.GenBuffers(1, &vertices_);
    gl.GenBuffers(1, &indices_);
    gl.BindVertexArray(vertex_array_);
    gl.BindBuffer(gl::array_buffer, vertices_);
    gl.BindBuffer(gl::element_array_buffer, indices_);
    constexpr gl::Sizei stride = sizeof(ImDrawVert);
    for (const gl::Uint i : {0u, 1u, 2u}) gl.EnableVertexAttribArray(i);
    gl.VertexAttribPointer(0, 2, gl::float_type, 0, stride, offset_of(offsetof(ImDrawVert, pos)));
    gl.VertexAttribPointer(1, 2, gl::float_type, 0, stride, offset_of(offsetof(ImDrawVert, uv)));
    gl.VertexAttribPointer(2, 4, gl::unsigned_byte, 1, stride, offset_of(offsetof(ImDrawVert, col)));
}

DrawListRenderer::~DrawListRenderer()
{
    context_.make_current();
    const auto& gl = context_.gl();
    for (const auto& [image, texture] : textures_) gl.DeleteTextures(1, &texture.name);
    gl.DeleteBuffers(1, &vertices_);
    gl.DeleteBuffers(1, &indices_);
    gl.DeleteVertexArrays(1, &vertex_array_);
    gl.DeleteProgram(plain_.name);
    gl.DeleteProgram(image_.name);
}

void DrawListRenderer::clear(Color color)
{
    const auto& gl = context_.gl();
    gl.Disable(gl::scissor_test);
    const auto part = [](std::uint8_t c) { return static_cast<float>(c) / 255.0F; };
    gl.ClearColor(part(color.r), part(color.g), part(color.b), part(color.a));
    gl.Clear(gl::color_buffer_bit);
}

void DrawListRenderer::set_state(const ImDrawData& data)
{
    const auto& gl = context_.gl();
    gl.Viewport(0, 0, context_.size().width, context_.size().height);
    gl.Enable(gl::blend);
    gl.BlendEquation(gl::func_add);
    gl.BlendFuncSeparate(gl::src_alpha, gl::one_minus_src_alpha, gl::one, gl::one_minus_src_alpha);
    gl.Disable(gl::cull_face);
    gl.Disable(gl::depth_test);
    gl.Disable(gl::framebuffer_srgb);
    gl.Enable(gl::scissor_test);
    for (const Program& program : {plain_, image_}) {
        gl.UseProgram(program.name);
        gl.Uniform4f(program.frame, data.DisplayPos.x, data.DisplayPos.y, 2.0F / data.DisplaySize.x,
                     2.0F / data.DisplaySize.y);
    }
    gl.ActiveTexture(gl::texture0);
    gl.BindVertexArray(vertex_array_);
    gl.BindBuffer(gl::array_buffer, vertices_);
}

void DrawListRenderer::upload(Texture& texture, const AlphaImage& image)
{
    const auto& gl = context_.gl();
    if (texture.name == 0) gl.GenTextures(1, &texture.name);
    gl.BindTexture(gl::texture_2d, texture.name);
    const auto set = [&](gl::Enum what, gl::Enum value) {
        gl.TexParameteri(gl::texture_2d, what, static_cast<gl::Int>(value));
    };
    set(gl::texture_min_filter, gl::linear);
    set(gl::texture_mag_filter, gl::linear);
    set(gl::texture_wrap_s, gl::clamp_to_edge);
    set(gl::texture_wrap_t, gl::clamp_to_edge);
    gl.PixelStorei(gl::unpack_alignment, 1);
    gl.TexImage2D(gl::texture_2d, 0, static_cast<gl::Int>(gl::r8), image.width, image.height, 0, gl::red,
                  gl::unsigned_byte, image.pixels.data());
    texture.version = image.version;
}

gl::Uint DrawListRenderer::texture(const AlphaImage& image)
{
    Texture& texture = textures_[&image];
    if (texture.name == 0 || texture.version != image.version) upload(texture, image);
    texture.last_used = n_rendered_;
    return texture.name;
}

/// Makes ready for a command with this image, or with none.
void DrawListRenderer::use(const AlphaImage* image)
{
    const auto& gl = context_.gl();
    gl.UseProgram(image ? image_.name : plain_.name);
    if (image) gl.BindTexture(gl::texture_2d, texture(*image));
}

void DrawListRenderer::forget_unused_textures()
{
    for (auto it = textures_.begin(); it != textures_.end();) {
        if (it->second.last_used == n_rendered_) {
            ++it;
            continue;
        }
        context_.gl().DeleteTextures(1, &it->second.name);
        it = textures_.erase(it);
    }
}

void DrawListRenderer::render(const ImDrawData& data)
{
    if (data.DisplaySize.x <= 0.0F || data.DisplaySize.y <= 0.0F) return; // a minimized window
    ++n_rendered_;
    set_state(data);
    const auto& gl = context_.gl();
    constexpr gl::Enum index_type = sizeof(ImDrawIdx) == 2 ? gl::unsigned_short : gl::unsigned_int;
    for (int k = 0; k < data.CmdListsCount; ++k) {
        const ImDrawList& list = *data.CmdLists[k];
        gl.BufferData(gl::array_buffer, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, gl::stream_draw);
        gl.BufferData(gl::element_array_buffer, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, gl::stream_draw);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback && command.UserCallback != ImDrawCallback_ResetRenderState)
                command.UserCallback(&list, &command);
            const Scissor box = scissor(command, data);
            if (command.UserCallback || command.ElemCount == 0 || box.width <= 0 || box.height <= 0) continue;
            gl.Scissor(box.x, box.y, box.width, box.height);
            const auto draw_indices = [&](unsigned first, unsigned n) {
                gl.DrawElementsBaseVertex(gl::triangles, static_cast<gl::Sizei>(n), index_type,
                                          offset_of((command.IdxOffset + first) * sizeof(ImDrawIdx)),
                                          static_cast<gl::Int>(command.VtxOffset));
            };
            const unsigned n_first = n_of_background(list, command);
            if (n_first > 0) {
                gl.Disable(gl::blend);
                use(nullptr);
                draw_indices(0, n_first);
                gl.Enable(gl::blend);
            }
            use(static_cast<const AlphaImage*>(command.GetTexID()));
            draw_indices(n_first, command.ElemCount - n_first);
        }
    }
    forget_unused_textures();
}

} // namespace ui
