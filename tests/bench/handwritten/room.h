// scenes/refraction-room as one would write it for that scene alone: everything is known beforehand.
#pragma once

#include <epoxy/gl.h>

#include <string>

namespace by_hand {

// Needs a current context of OpenGL 3.3 or above; what it makes there goes with the context.
class Room {
public:
    // `folder` holds posx.bmp to negz.bmp. `sliders`: the ball's five numbers are uniforms, as the scene's sliders
    // need them; else they are constants, which is less than the scene offers. Throws where something is missing.
    explicit Room(const std::string& folder, bool sliders = true);
    void draw(GLuint framebuffer, int width, int height);

private:
    void aim(int width, int height);

    GLuint walls_ = 0, glass_ = 0;                           // programs
    GLuint wall_quads_ = 0, ball_ = 0;                       // vertex arrays
    GLuint pictures_[6]{}, cube_ = 0;                        // textures
    GLint wall_clip_ = -1, ball_clip_ = -1, ball_eye_ = -1;  // locations
    GLsizei ball_indices_ = 0;
    int width_ = 0, height_ = 0;  // that the matrices are for
};

}  // namespace by_hand
