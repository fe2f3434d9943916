/* An OpenGL window without a display: Mesa's surfaceless EGL platform under VTK's generic window.
 */
#ifndef GRADERS_RENDER_WINDOW_HPP
#define GRADERS_RENDER_WINDOW_HPP

#include <string>
#include <vtkGenericOpenGLRenderWindow.h>

/* Debian's VTK has no EGL window of its own, and its X11 window aborts where no display is: make
 * only this one. One thread in a process may draw at a time. */
class headless_window : public vtkGenericOpenGLRenderWindow
{
  public:
    static headless_window *New();
    vtkTypeMacro(headless_window, vtkGenericOpenGLRenderWindow);

    /* Makes the OpenGL context and an off-screen buffer of the given size in pixels; false where
     * there is no OpenGL 3.2. */
    bool open(int width, int height);

    void MakeCurrent() override;
    bool IsCurrent() override;
    void Frame() override;

  protected:
    headless_window() = default;
    ~headless_window() override;

  private:
    bool make_context();

    void *display_ = nullptr; /* EGLDisplay and EGLContext are pointers */
    void *context_ = nullptr;
};

/* Whether this machine can draw at all. Costs milliseconds where it cannot. */
bool has_opengl();

/* Chooses Mesa's shader cache, once, before the first window: a folder of our own in the user's
 * cache, or none where that cannot be written. A folder shared with other programs may hold shaders
 * compiled for another vector width, which crash Mesa. */
void choose_shader_cache();

/* Keeps VTK from printing. Its last error since then, or since it was last taken, can be asked for.
 */
void silence_vtk();
std::string take_vtk_error(); /* empty: none */

#endif
