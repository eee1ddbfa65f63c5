#pragma once

#include "ui/context/context.h"
#include "ui/context/frame_tiles.h"
#include "ui/paint/color.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>

struct ImDrawData;

namespace ui {

struct Image;

/// Draws Dear ImGui's lists with OpenGL 3.3. A list's texture (`ImTextureID`) is the address of an Image, uploaded
/// when it is new or has changed, or null for lines and areas alone. Units of the lists are physical pixels. A vertex
/// with uv.y < 0 belongs to a line or disc: uv.x is its distance across, -uv.y the reach (ui/paint/mesh/mesh.h).
///
/// The renderer keeps the picture of the frame before, draws again what differs, and copies the whole to the context.
/// \pre the context outlives the renderer and is current at each call
class DrawListRenderer {
public:
    /// \throws ContextError with the driver's words when it refuses the shaders.
    explicit DrawListRenderer(Context& context);
    ~DrawListRenderer();
    DrawListRenderer(const DrawListRenderer&) = delete;
    DrawListRenderer& operator=(const DrawListRenderer&) = delete;

    /// Draws a frame over a background.
    void render(const ImDrawData& data, Color background);

private:
    struct Texture {
        gl::Uint name = 0;
        std::uint64_t version = 0;
        std::uint64_t last_used = 0;
    };

    struct Program {
        gl::Uint name = 0;
        gl::Int frame = -1; ///< place of the uniform
    };

    /// Triangles that lie one after the other among the uploaded indices.
    struct Stretch {
        const DrawBatch* batch;
        PixelBox box;
        std::size_t first, n;
    };

    void fit_picture();
    void set_state(const ImDrawData& data);
    void scissor(const PixelBox& box);
    void clear(const PixelBox& box, Color color);
    void render_list(std::span<const DrawBatch> batches);
    void draw(const Stretch& stretch);
    void copy_to(gl::Uint framebuffer);
    gl::Uint texture(const Image& image);
    const Program& program_of(const DrawBatch& batch) const;
    void upload(Texture& texture, const Image& image);
    void forget_unused_textures();

    Context& context_;
    Program plain_;
    Program image_;
    Program photo_;
    gl::Uint vertex_array_ = 0;
    gl::Uint vertices_ = 0;
    gl::Uint indices_ = 0;
    PixelSize size_{}; ///< of the kept picture
    gl::Uint framebuffer_ = 0;
    gl::Uint renderbuffer_ = 0;
    FrameTiles tiles_;
    std::uint64_t n_rendered_ = 0;
    std::unordered_map<const Image*, Texture> textures_;
};

} // namespace ui
