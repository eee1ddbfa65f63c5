#pragma once

#include <cstddef>
#include <stdexcept>

#if defined(_WIN32)
#define UI_GL_CALL __stdcall
#else
#define UI_GL_CALL
#endif

namespace ui {

/// No context, no renderer or too old an OpenGL; the message says what was tried and what to install.
class ContextError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The part of OpenGL 3.3 core that this program uses, with the names and numbers of the OpenGL specification.
namespace gl {

using Enum = unsigned int;
using Uint = unsigned int;
using Int = int;
using Sizei = int;
using Float = float;
using Boolean = unsigned char;
using Bitfield = unsigned int;
using Ubyte = unsigned char;
using Char = char;
using Intptr = std::ptrdiff_t;

inline constexpr Enum triangles = 0x0004, unsigned_byte = 0x1401, unsigned_short = 0x1403, unsigned_int = 0x1405,
                      float_type = 0x1406, blend = 0x0BE2, scissor_test = 0x0C11, depth_test = 0x0B71,
                      cull_face = 0x0B44, framebuffer_srgb = 0x8DB9, one = 1, src_alpha = 0x0302,
                      one_minus_src_alpha = 0x0303, func_add = 0x8006, texture_2d = 0x0DE1, texture0 = 0x84C0,
                      texture_min_filter = 0x2801, texture_mag_filter = 0x2800, texture_wrap_s = 0x2802,
                      texture_wrap_t = 0x2803, clamp_to_edge = 0x812F, linear = 0x2601, linear_mipmap_linear = 0x2703,
                      red = 0x1903, rgba = 0x1908, r8 = 0x8229, rgba8 = 0x8058, unpack_alignment = 0x0CF5,
                      pack_alignment = 0x0D05, array_buffer = 0x8892, element_array_buffer = 0x8893,
                      stream_draw = 0x88E0, vertex_shader = 0x8B31, fragment_shader = 0x8B30, compile_status = 0x8B81,
                      link_status = 0x8B82, framebuffer = 0x8D40, read_framebuffer = 0x8CA8, draw_framebuffer = 0x8CA9,
                      framebuffer_binding = 0x8CA6, nearest = 0x2600, renderbuffer = 0x8D41, color_attachment0 = 0x8CE0,
                      framebuffer_complete = 0x8CD5, version = 0x1F02, renderer = 0x1F01,
                      max_renderbuffer_size = 0x84E8;
inline constexpr Bitfield color_buffer_bit = 0x00004000;

/// Finds a function of the context by name; null where it has none.
using Proc = void (*)();
using Loader = Proc (*)(const char* name);

// NOLINTBEGIN(readability-identifier-naming): the specification's names
/// Every function used, loaded through a context's own loader, so that one program can draw to a window and off screen.
struct Functions {
    /// \pre the context is current. \throws ContextError naming the first function that is missing.
    explicit Functions(Loader load);

    /// OpenGL ES 3.0, which WebGL 2 is: its shaders are headed otherwise, and it has no switch for sRGB.
    bool is_embedded = false;

    void(UI_GL_CALL* ActiveTexture)(Enum);
    void(UI_GL_CALL* AttachShader)(Uint, Uint);
    void(UI_GL_CALL* BindBuffer)(Enum, Uint);
    void(UI_GL_CALL* BindFramebuffer)(Enum, Uint);
    void(UI_GL_CALL* BindRenderbuffer)(Enum, Uint);
    void(UI_GL_CALL* BindTexture)(Enum, Uint);
    void(UI_GL_CALL* BindVertexArray)(Uint);
    void(UI_GL_CALL* BlendEquation)(Enum);
    void(UI_GL_CALL* BlendFuncSeparate)(Enum, Enum, Enum, Enum);
    void(UI_GL_CALL* BlitFramebuffer)(Int, Int, Int, Int, Int, Int, Int, Int, Bitfield, Enum);
    void(UI_GL_CALL* BufferData)(Enum, Intptr, const void*, Enum);
    Enum(UI_GL_CALL* CheckFramebufferStatus)(Enum);
    void(UI_GL_CALL* Clear)(Bitfield);
    void(UI_GL_CALL* ClearColor)(Float, Float, Float, Float);
    void(UI_GL_CALL* CompileShader)(Uint);
    Uint(UI_GL_CALL* CreateProgram)();
    Uint(UI_GL_CALL* CreateShader)(Enum);
    void(UI_GL_CALL* DeleteBuffers)(Sizei, const Uint*);
    void(UI_GL_CALL* DeleteFramebuffers)(Sizei, const Uint*);
    void(UI_GL_CALL* DeleteProgram)(Uint);
    void(UI_GL_CALL* DeleteRenderbuffers)(Sizei, const Uint*);
    void(UI_GL_CALL* DeleteShader)(Uint);
    void(UI_GL_CALL* DeleteTextures)(Sizei, const Uint*);
    void(UI_GL_CALL* DeleteVertexArrays)(Sizei, const Uint*);
    void(UI_GL_CALL* Disable)(Enum);
    void(UI_GL_CALL* DrawElements)(Enum, Sizei, Enum, const void*);
    void(UI_GL_CALL* Enable)(Enum);
    void(UI_GL_CALL* EnableVertexAttribArray)(Uint);
    void(UI_GL_CALL* Finish)();
    void(UI_GL_CALL* FramebufferRenderbuffer)(Enum, Enum, Enum, Uint);
    void(UI_GL_CALL* GenBuffers)(Sizei, Uint*);
    void(UI_GL_CALL* GenFramebuffers)(Sizei, Uint*);
    void(UI_GL_CALL* GenRenderbuffers)(Sizei, Uint*);
    void(UI_GL_CALL* GenTextures)(Sizei, Uint*);
    void(UI_GL_CALL* GenVertexArrays)(Sizei, Uint*);
    void(UI_GL_CALL* GenerateMipmap)(Enum);
    void(UI_GL_CALL* GetIntegerv)(Enum, Int*);
    void(UI_GL_CALL* GetProgramInfoLog)(Uint, Sizei, Sizei*, Char*);
    void(UI_GL_CALL* GetProgramiv)(Uint, Enum, Int*);
    void(UI_GL_CALL* GetShaderInfoLog)(Uint, Sizei, Sizei*, Char*);
    void(UI_GL_CALL* GetShaderiv)(Uint, Enum, Int*);
    const Ubyte*(UI_GL_CALL* GetString)(Enum);
    Int(UI_GL_CALL* GetUniformLocation)(Uint, const Char*);
    void(UI_GL_CALL* LinkProgram)(Uint);
    void(UI_GL_CALL* PixelStorei)(Enum, Int);
    void(UI_GL_CALL* ReadPixels)(Int, Int, Sizei, Sizei, Enum, Enum, void*);
    void(UI_GL_CALL* RenderbufferStorage)(Enum, Enum, Sizei, Sizei);
    void(UI_GL_CALL* Scissor)(Int, Int, Sizei, Sizei);
    void(UI_GL_CALL* ShaderSource)(Uint, Sizei, const Char* const*, const Int*);
    void(UI_GL_CALL* TexImage2D)(Enum, Int, Int, Sizei, Sizei, Int, Enum, Enum, const void*);
    void(UI_GL_CALL* TexParameteri)(Enum, Enum, Int);
    void(UI_GL_CALL* Uniform1i)(Int, Int);
    void(UI_GL_CALL* Uniform4f)(Int, Float, Float, Float, Float);
    void(UI_GL_CALL* UseProgram)(Uint);
    void(UI_GL_CALL* VertexAttribPointer)(Uint, Int, Enum, Boolean, Sizei, const void*);
    void(UI_GL_CALL* Viewport)(Int, Int, Sizei, Sizei);
};
// NOLINTEND(readability-identifier-naming)

} // namespace gl
} // namespace ui
