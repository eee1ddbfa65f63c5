#include "ui/context/gl.h"

#include <string>
#include <string_view>

namespace ui::gl {

namespace {

template <class Function> void load_one(Loader load, const char* name, Function& function)
{
    function = reinterpret_cast<Function>(load(name));
    if (!function)
        throw ContextError("OpenGL: the driver has no function " + std::string(name) +
                           "; OpenGL 3.3 is needed, update the graphics driver");
}

} // namespace

// Each member is set below, or the constructor throws.
Functions::Functions(Loader load)
{
    load_one(load, "glActiveTexture", ActiveTexture);
    load_one(load, "glAttachShader", AttachShader);
    load_one(load, "glBindBuffer", BindBuffer);
    load_one(load, "glBindFramebuffer", BindFramebuffer);
    load_one(load, "glBindRenderbuffer", BindRenderbuffer);
    load_one(load, "glBindTexture", BindTexture);
    load_one(load, "glBindVertexArray", BindVertexArray);
    load_one(load, "glBlendEquation", BlendEquation);
    load_one(load, "glBlendFuncSeparate", BlendFuncSeparate);
    load_one(load, "glBlitFramebuffer", BlitFramebuffer);
    load_one(load, "glBufferData", BufferData);
    load_one(load, "glCheckFramebufferStatus", CheckFramebufferStatus);
    load_one(load, "glClear", Clear);
    load_one(load, "glClearColor", ClearColor);
    load_one(load, "glCompileShader", CompileShader);
    load_one(load, "glCreateProgram", CreateProgram);
    load_one(load, "glCreateShader", CreateShader);
    load_one(load, "glDeleteBuffers", DeleteBuffers);
    load_one(load, "glDeleteFramebuffers", DeleteFramebuffers);
    load_one(load, "glDeleteProgram", DeleteProgram);
    load_one(load, "glDeleteRenderbuffers", DeleteRenderbuffers);
    load_one(load, "glDeleteShader", DeleteShader);
    load_one(load, "glDeleteTextures", DeleteTextures);
    load_one(load, "glDeleteVertexArrays", DeleteVertexArrays);
    load_one(load, "glDisable", Disable);
    load_one(load, "glDrawElements", DrawElements);
    load_one(load, "glEnable", Enable);
    load_one(load, "glEnableVertexAttribArray", EnableVertexAttribArray);
    load_one(load, "glFinish", Finish);
    load_one(load, "glFramebufferRenderbuffer", FramebufferRenderbuffer);
    load_one(load, "glGenBuffers", GenBuffers);
    load_one(load, "glGenFramebuffers", GenFramebuffers);
    load_one(load, "glGenRenderbuffers", GenRenderbuffers);
    load_one(load, "glGenTextures", GenTextures);
    load_one(load, "glGenVertexArrays", GenVertexArrays);
    load_one(load, "glGenerateMipmap", GenerateMipmap);
    load_one(load, "glGetIntegerv", GetIntegerv);
    load_one(load, "glGetProgramInfoLog", GetProgramInfoLog);
    load_one(load, "glGetProgramiv", GetProgramiv);
    load_one(load, "glGetShaderInfoLog", GetShaderInfoLog);
    load_one(load, "glGetShaderiv", GetShaderiv);
    load_one(load, "glGetString", GetString);
    load_one(load, "glGetUniformLocation", GetUniformLocation);
    load_one(load, "glLinkProgram", LinkProgram);
    load_one(load, "glPixelStorei", PixelStorei);
    load_one(load, "glReadPixels", ReadPixels);
    load_one(load, "glRenderbufferStorage", RenderbufferStorage);
    load_one(load, "glScissor", Scissor);
    load_one(load, "glShaderSource", ShaderSource);
    load_one(load, "glTexImage2D", TexImage2D);
    load_one(load, "glTexParameteri", TexParameteri);
    load_one(load, "glUniform1i", Uniform1i);
    load_one(load, "glUniform4f", Uniform4f);
    load_one(load, "glUseProgram", UseProgram);
    load_one(load, "glVertexAttribPointer", VertexAttribPointer);
    load_one(load, "glViewport", Viewport);
    const auto* const words = reinterpret_cast<const char*>(GetString(version));
    is_embedded = words && std::string_view(words).starts_with("OpenGL ES");
}

} // namespace ui::gl
