#include "ui/context/empty_gl.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace ui::gl {

namespace {

template <class Function> Proc proc(Function* function) { return reinterpret_cast<Proc>(function); }

/// A function of that kind that draws nothing and says 0.
template <class Result, class... Arguments> Proc nothing(Result (UI_GL_CALL* Functions::*)(Arguments...))
{
    Result(UI_GL_CALL* const function)(Arguments...) = [](Arguments...) -> Result { return Result(); };
    return reinterpret_cast<Proc>(function);
}

void UI_GL_CALL give_names(Sizei n, Uint* names) { std::fill_n(names, n, 1U); }
void UI_GL_CALL give_limit(Enum what, Int* value) { *value = what == max_renderbuffer_size ? 16384 : 0; }
void UI_GL_CALL give_success(Uint /*of*/, Enum /*what*/, Int* value) { *value = 1; }
const Ubyte* UI_GL_CALL give_words(Enum /*what*/)
{
    static constexpr Ubyte words[] = {'n', 'o', 'n', 'e', 0};
    return words;
}

struct Entry {
    std::string_view name;
    Proc function;
};

const auto& entries()
{
    static const std::array all = {
        Entry{"glActiveTexture", nothing(&Functions::ActiveTexture)},
        Entry{"glAttachShader", nothing(&Functions::AttachShader)},
        Entry{"glBindBuffer", nothing(&Functions::BindBuffer)},
        Entry{"glBindFramebuffer", nothing(&Functions::BindFramebuffer)},
        Entry{"glBindRenderbuffer", nothing(&Functions::BindRenderbuffer)},
        Entry{"glBindTexture", nothing(&Functions::BindTexture)},
        Entry{"glBindVertexArray", nothing(&Functions::BindVertexArray)},
        Entry{"glBlendEquation", nothing(&Functions::BlendEquation)},
        Entry{"glBlendFuncSeparate", nothing(&Functions::BlendFuncSeparate)},
        Entry{"glBlitFramebuffer", nothing(&Functions::BlitFramebuffer)},
        Entry{"glBufferData", nothing(&Functions::BufferData)},
        Entry{"glCheckFramebufferStatus", proc(+[](Enum) -> Enum { return framebuffer_complete; })},
        Entry{"glClear", nothing(&Functions::Clear)},
        Entry{"glClearColor", nothing(&Functions::ClearColor)},
        Entry{"glCompileShader", nothing(&Functions::CompileShader)},
        Entry{"glCreateProgram", proc(+[]() -> Uint { return 1; })},
        Entry{"glCreateShader", proc(+[](Enum) -> Uint { return 1; })},
        Entry{"glDeleteBuffers", nothing(&Functions::DeleteBuffers)},
        Entry{"glDeleteFramebuffers", nothing(&Functions::DeleteFramebuffers)},
        Entry{"glDeleteProgram", nothing(&Functions::DeleteProgram)},
        Entry{"glDeleteRenderbuffers", nothing(&Functions::DeleteRenderbuffers)},
        Entry{"glDeleteShader", nothing(&Functions::DeleteShader)},
        Entry{"glDeleteTextures", nothing(&Functions::DeleteTextures)},
        Entry{"glDeleteVertexArrays", nothing(&Functions::DeleteVertexArrays)},
        Entry{"glDisable", nothing(&Functions::Disable)},
        Entry{"glDrawElements", nothing(&Functions::DrawElements)},
        Entry{"glEnable", nothing(&Functions::Enable)},
        Entry{"glEnableVertexAttribArray", nothing(&Functions::EnableVertexAttribArray)},
        Entry{"glFinish", nothing(&Functions::Finish)},
        Entry{"glFramebufferRenderbuffer", nothing(&Functions::FramebufferRenderbuffer)},
        Entry{"glGenBuffers", proc(&give_names)},
        Entry{"glGenFramebuffers", proc(&give_names)},
        Entry{"glGenRenderbuffers", proc(&give_names)},
        Entry{"glGenTextures", proc(&give_names)},
        Entry{"glGenVertexArrays", proc(&give_names)},
        Entry{"glGenerateMipmap", nothing(&Functions::GenerateMipmap)},
        Entry{"glGetIntegerv", proc(&give_limit)},
        Entry{"glGetProgramInfoLog", nothing(&Functions::GetProgramInfoLog)},
        Entry{"glGetProgramiv", proc(&give_success)},
        Entry{"glGetShaderInfoLog", nothing(&Functions::GetShaderInfoLog)},
        Entry{"glGetShaderiv", proc(&give_success)},
        Entry{"glGetString", proc(&give_words)},
        Entry{"glGetUniformLocation", nothing(&Functions::GetUniformLocation)},
        Entry{"glLinkProgram", nothing(&Functions::LinkProgram)},
        Entry{"glPixelStorei", nothing(&Functions::PixelStorei)},
        Entry{"glReadPixels", nothing(&Functions::ReadPixels)},
        Entry{"glRenderbufferStorage", nothing(&Functions::RenderbufferStorage)},
        Entry{"glScissor", nothing(&Functions::Scissor)},
        Entry{"glShaderSource", nothing(&Functions::ShaderSource)},
        Entry{"glTexImage2D", nothing(&Functions::TexImage2D)},
        Entry{"glTexParameteri", nothing(&Functions::TexParameteri)},
        Entry{"glUniform1i", nothing(&Functions::Uniform1i)},
        Entry{"glUniform4f", nothing(&Functions::Uniform4f)},
        Entry{"glUseProgram", nothing(&Functions::UseProgram)},
        Entry{"glVertexAttribPointer", nothing(&Functions::VertexAttribPointer)},
        Entry{"glViewport", nothing(&Functions::Viewport)},
    };
    return all;
}

} // namespace

Proc empty_function(const char* name)
{
    const auto found = std::find_if(entries().begin(), entries().end(),
                                    [&](const Entry& entry) { return entry.name == name; });
    return found == entries().end() ? nullptr : found->function;
}

} // namespace ui::gl
