/* The EGL context under VTK; see window.hpp. */
#include "graders/render/window.hpp"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <utility>
#include <vtkAutoInit.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

VTK_MODULE_INIT(vtkRenderingOpenGL2);
VTK_MODULE_INIT(vtkRenderingContextOpenGL2);
VTK_MODULE_INIT(vtkRenderingFreeType);
VTK_MODULE_INIT(vtkInteractionStyle);

/* Debian's GLEW is built for GLX: without X its glewInit loads every entry point and then returns
 * "no GLX display" (4), which VTK takes as fatal. Defined in the program, this one is called
 * instead of the library's. */
extern "C" unsigned glewInit(void);
extern "C" unsigned glewInit(void)
{
    const unsigned no_glx_display = 4;
    auto real = reinterpret_cast<unsigned (*)()>(dlsym(RTLD_NEXT, "glewInit"));
    unsigned result = real ? real() : 1;
    return result == no_glx_display ? 0 : result;
}

vtkStandardNewMacro(headless_window);

static EGLDisplay surfaceless_display()
{
    auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!get_display)
        return EGL_NO_DISPLAY;
    EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    EGLint major, minor;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor))
        return EGL_NO_DISPLAY;
    return display;
}

static EGLContext core_context(EGLDisplay display)
{
    const EGLint wanted[] = {EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_ALPHA_SIZE,
                             8,
                             EGL_DEPTH_SIZE,
                             24,
                             EGL_NONE};
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              2,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    EGLConfig config;
    EGLint count;
    if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display, wanted, &config, 1, &count) ||
        count < 1)
        return EGL_NO_CONTEXT;
    return eglCreateContext(display, config, EGL_NO_CONTEXT, version);
}

bool headless_window::make_context()
{
    display_ = surfaceless_display();
    if (display_ == EGL_NO_DISPLAY)
        return false;
    context_ = core_context(display_);
    return context_ != EGL_NO_CONTEXT &&
           eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
}

bool headless_window::open(int width, int height)
{
    if (!make_context())
        return false;
    SetIsCurrent(true);
    SetIsDirect(1);
    SetSupportsOpenGL(1);
    SetOwnContext(1);
    SetMultiSamples(0);
    SetSize(width, height);
    SetMapped(1);
    SetReadyForRendering(true);
    OpenGLInit();
    SetUseOffScreenBuffers(true);
    return true;
}

void headless_window::MakeCurrent()
{
    if (context_)
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
}

bool headless_window::IsCurrent()
{
    return context_ && eglGetCurrentContext() == context_;
}

void headless_window::Frame()
{
}

headless_window::~headless_window()
{
    Finalize();
    if (context_) {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }
    if (display_)
        eglTerminate(display_);
}

bool has_opengl()
{
    EGLDisplay display = surfaceless_display();
    if (display == EGL_NO_DISPLAY)
        return false;
    EGLContext context = core_context(display);
    bool works = context != EGL_NO_CONTEXT;
    if (works)
        eglDestroyContext(display, context);
    eglTerminate(display);
    return works;
}

static std::string cache_folder()
{
    const char *cache = getenv("XDG_CACHE_HOME");
    const char *home = getenv("HOME");
    if (cache && cache[0] == '/')
        return std::string(cache) + "/meshgrade/mesa";
    return home && home[0] == '/' ? std::string(home) + "/.cache/meshgrade/mesa" : "";
}

void choose_shader_cache()
{
    if (getenv("MESA_SHADER_CACHE_DIR") || getenv("MESA_SHADER_CACHE_DISABLE"))
        return;
    std::string folder = cache_folder();
    std::error_code failed;
    if (!folder.empty())
        std::filesystem::create_directories(folder, failed);
    if (!folder.empty() && !failed && access(folder.c_str(), W_OK) == 0)
        setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 1);
    else
        setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

namespace
{
std::string last_error;

class quiet_output : public vtkOutputWindow
{
  public:
    static quiet_output *New();
    vtkTypeMacro(quiet_output, vtkOutputWindow);
    void DisplayText(const char *) override
    {
    }
    void DisplayErrorText(const char *text) override
    {
        last_error = text ? text : "";
        for (char &c : last_error)
            if (c == '\n' || c == '\r')
                c = ' ';
    }
    void DisplayWarningText(const char *) override
    {
    }
};
vtkStandardNewMacro(quiet_output);
} // namespace

void silence_vtk()
{
    vtkNew<quiet_output> quiet;
    vtkOutputWindow::SetInstance(quiet);
}

std::string take_vtk_error()
{
    return std::exchange(last_error, "");
}
