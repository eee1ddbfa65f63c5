#include "ui/context/draw_list_renderer.h"

#include "ui/context/memory_picture.h"
#include "ui/paint/image.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ui {

namespace {

// A vertex of a Mesh's line or disc gives how far it lies across and, negated, its reach in place of a texture's place.
// frame = (left, top, 2 / width, 2 / height) of the part of the plane that is seen.
constexpr const char* vertex_source = R"(layout(location = 0) in vec2 place;
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
constexpr const char* image_source = R"(in vec2 frag_uv;
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

// An image in colours.
constexpr const char* photo_source = R"(in vec2 frag_uv;
in vec4 frag_color;
uniform sampler2D image;
layout(location = 0) out vec4 result;
void main()
{
    result = texture(image, frag_uv) * frag_color;
}
)";

// Lines and areas alone: a software renderer is much faster where it need not look into an image.
constexpr const char* plain_source = R"(in vec2 frag_uv;
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
    const char* const head = gl.is_embedded ? "#version 300 es\nprecision highp float;\n" : "#version 330 core\n";
    const std::array<const char*, 2> sources = {head, source};
    gl.ShaderSource(shader, 2, sources.data(), nullptr);
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
    photo_ = program(photo_source);
    for (const Program& with_image : {image_, photo_}) {
        gl.UseProgram(with_image.name);
        gl.Uniform1i(gl.GetUniformLocation(with_image.name, "image"), 0);
    }
    gl.GenVertexArrays(1, &vertex_array_);
    gl.GenBuffers(1, &vertices_);
    gl.GenBuffers(1, &indices_);
    gl.GenFramebuffers(1, &framebuffer_);
    gl.GenRenderbuffers(1, &renderbuffer_);
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
    gl.DeleteFramebuffers(1, &framebuffer_);
    gl.DeleteRenderbuffers(1, &renderbuffer_);
    gl.DeleteProgram(plain_.name);
    gl.DeleteProgram(image_.name);
    gl.DeleteProgram(photo_.name);
}

/// Gives the kept picture the size of the context's.
void DrawListRenderer::fit_picture()
{
    if (size_ == context_.size()) return;
    size_ = context_.size();
    make_memory_picture(context_.gl(), framebuffer_, renderbuffer_, size_);
}

void DrawListRenderer::scissor(const PixelBox& box)
{
    context_.gl().Scissor(box.left, size_.height - box.bottom, box.right - box.left, box.bottom - box.top);
}

void DrawListRenderer::clear(const PixelBox& box, Color color)
{
    const auto& gl = context_.gl();
    scissor(box);
    const auto part = [](std::uint8_t c) { return static_cast<float>(c) / 255.0F; };
    gl.ClearColor(part(color.r), part(color.g), part(color.b), part(color.a));
    gl.Clear(gl::color_buffer_bit);
}

void DrawListRenderer::set_state(const ImDrawData& data)
{
    const auto& gl = context_.gl();
    gl.Viewport(0, 0, size_.width, size_.height);
    gl.Enable(gl::blend);
    gl.BlendEquation(gl::func_add);
    gl.BlendFuncSeparate(gl::src_alpha, gl::one_minus_src_alpha, gl::one, gl::one_minus_src_alpha);
    gl.Disable(gl::cull_face);
    gl.Disable(gl::depth_test);
    if (!gl.is_embedded) gl.Disable(gl::framebuffer_srgb);
    gl.Enable(gl::scissor_test);
    for (const Program& program : {plain_, image_, photo_}) {
        gl.UseProgram(program.name);
        gl.Uniform4f(program.frame, data.DisplayPos.x, data.DisplayPos.y, 2.0F / data.DisplaySize.x,
                     2.0F / data.DisplaySize.y);
    }
    gl.ActiveTexture(gl::texture0);
    gl.BindVertexArray(vertex_array_);
    gl.BindBuffer(gl::array_buffer, vertices_);
}

void DrawListRenderer::upload(Texture& texture, const Image& image)
{
    const auto& gl = context_.gl();
    if (texture.name == 0) gl.GenTextures(1, &texture.name);
    gl.BindTexture(gl::texture_2d, texture.name);
    const auto set = [&](gl::Enum what, gl::Enum value) {
        gl.TexParameteri(gl::texture_2d, what, static_cast<gl::Int>(value));
    };
    const bool is_photo = image.kind == PixelKind::Color; // which is seen from afar too
    set(gl::texture_min_filter, is_photo ? gl::linear_mipmap_linear : gl::linear);
    set(gl::texture_mag_filter, gl::linear);
    set(gl::texture_wrap_s, gl::clamp_to_edge);
    set(gl::texture_wrap_t, gl::clamp_to_edge);
    gl.PixelStorei(gl::unpack_alignment, 1);
    gl.TexImage2D(gl::texture_2d, 0, static_cast<gl::Int>(is_photo ? gl::rgba8 : gl::r8), image.width, image.height, 0,
                  is_photo ? gl::rgba : gl::red, gl::unsigned_byte, image.pixels.data());
    if (is_photo) gl.GenerateMipmap(gl::texture_2d);
    texture.version = image.version;
}

gl::Uint DrawListRenderer::texture(const Image& image)
{
    Texture& texture = textures_[&image];
    if (texture.name == 0 || texture.version != image.version) upload(texture, image);
    texture.last_used = n_rendered_;
    return texture.name;
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

/// \pre all batches are of one list
void DrawListRenderer::render_list(std::span<const DrawBatch> batches)
{
    std::vector<unsigned> indices;
    std::vector<Stretch> stretches;
    for (const DrawBatch& batch : batches) {
        const auto by_box = tiles_.triangles_by_box(batch);
        for (std::size_t i = 0; i < by_box.size(); ++i) {
            const std::vector<unsigned>& triangles = by_box[i];
            if (triangles.empty()) continue;
            stretches.push_back({&batch, common_part(batch.clip, tiles_.boxes()[i]), indices.size(), triangles.size()});
            indices.insert(indices.end(), triangles.begin(), triangles.end());
        }
    }
    if (stretches.empty()) return;
    const auto& gl = context_.gl();
    const auto& vertices = batches.front().list->VtxBuffer;
    gl.BufferData(gl::array_buffer, vertices.size_in_bytes(), vertices.Data, gl::stream_draw);
    gl.BufferData(gl::element_array_buffer, static_cast<gl::Intptr>(indices.size() * sizeof(unsigned)), indices.data(),
                  gl::stream_draw);
    for (const Stretch& stretch : stretches) draw(stretch);
}

const DrawListRenderer::Program& DrawListRenderer::program_of(const DrawBatch& batch) const
{
    if (!batch.image) return plain_;
    return batch.image->kind == PixelKind::Color ? photo_ : image_;
}

void DrawListRenderer::draw(const Stretch& stretch)
{
    const auto& gl = context_.gl();
    const DrawBatch& batch = *stretch.batch;
    scissor(stretch.box);
    if (!batch.is_blended) gl.Disable(gl::blend);
    gl.UseProgram(program_of(batch).name);
    if (batch.image) gl.BindTexture(gl::texture_2d, texture(*batch.image));
    gl.DrawElements(gl::triangles, static_cast<gl::Sizei>(stretch.n), gl::unsigned_int,
                    offset_of(stretch.first * sizeof(unsigned)));
    if (!batch.is_blended) gl.Enable(gl::blend);
}

void DrawListRenderer::copy_to(gl::Uint framebuffer)
{
    const auto& gl = context_.gl();
    gl.Disable(gl::scissor_test);
    gl.BindFramebuffer(gl::read_framebuffer, framebuffer_);
    gl.BindFramebuffer(gl::draw_framebuffer, framebuffer);
    gl.BlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height, gl::color_buffer_bit,
                       gl::nearest);
    gl.BindFramebuffer(gl::framebuffer, framebuffer);
}

void DrawListRenderer::render(const ImDrawData& data, Color background)
{
    if (data.DisplaySize.x <= 0.0F || data.DisplaySize.y <= 0.0F) return; // a minimized window
    ++n_rendered_;
    const auto& gl = context_.gl();
    gl::Int shown = 0;
    gl.GetIntegerv(gl::framebuffer_binding, &shown);
    fit_picture();
    gl.BindFramebuffer(gl::framebuffer, framebuffer_);
    set_state(data);
    const std::vector<DrawBatch> batches = batches_of(data);
    for (const DrawBatch& batch : batches)
        if (batch.image) texture(*batch.image); // none is forgotten while the picture shows it
    tiles_.compare(batches, size_, background);
    for (const PixelBox& box : tiles_.boxes()) clear(box, background);
    for (auto begin = batches.begin(); begin != batches.end();) {
        const auto end = std::find_if(begin, batches.end(),
                                      [&](const DrawBatch& batch) { return batch.list != begin->list; });
        render_list({&*begin, static_cast<std::size_t>(end - begin)});
        begin = end;
    }
    copy_to(static_cast<gl::Uint>(shown));
    forget_unused_textures();
}

} // namespace ui
