/* See canvas.hpp. */
#include "graders/render/canvas.hpp"
#include "graders/render/window.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkImageData.h>
#include <vtkLightKit.h>
#include <vtkObjectFactory.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

namespace
{
class painted_item : public vtkContextItem
{
  public:
    static painted_item *New();
    vtkTypeMacro(painted_item, vtkContextItem);
    bool Paint(vtkContext2D *context) override
    {
        if (below)
            context->DrawImage(0, 0, below);
        paper sheet(context, width, height);
        for (auto &paint : painters)
            paint(sheet);
        return true;
    }
    int width = 0, height = 0;
    vtkSmartPointer<vtkImageData> below; /* null: the world is drawn with it */
    std::vector<std::function<void(paper &)>> painters;
};
vtkStandardNewMacro(painted_item);
} // namespace

static uint8_t mixed(uint8_t a, uint8_t b, double t)
{
    return uint8_t(std::lround(a + (b - a) * t));
}

static vtkSmartPointer<vtkTexture> radial_texture(colour centre, colour corner)
{
    const int width = 256, height = 192;
    vtkNew<vtkImageData> pixels;
    pixels->SetDimensions(width, height, 1);
    pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto rgb = static_cast<uint8_t *>(pixels->GetScalarPointer());
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++, rgb += 3) {
            double dx = 2.0 * x / (width - 1) - 1, dy = 2.0 * y / (height - 1) - 1.05;
            double t = std::min(1.0, std::sqrt((dx * dx + dy * dy) / 2));
            t = t * t * (3 - 2 * t);
            rgb[0] = mixed(centre.red, corner.red, t);
            rgb[1] = mixed(centre.green, corner.green, t);
            rgb[2] = mixed(centre.blue, corner.blue, t);
        }
    vtkNew<vtkTexture> texture;
    texture->SetInputData(pixels);
    texture->InterpolateOn();
    return texture.Get();
}

void canvas::set_backdrop(backdrop kind)
{
    if (kind == backdrop::plain) {
        behind_->SetBackground(palette::paper.red / 255.0, palette::paper.green / 255.0,
                               palette::paper.blue / 255.0);
        return;
    }
    behind_->SetBackgroundTexture(
        radial_texture(palette::backdrop_centre, palette::backdrop_corner));
    behind_->TexturedBackgroundOn();
}

static void set_lights(vtkRenderer *renderer)
{
    renderer->AutomaticLightCreationOff();
    vtkNew<vtkLightKit> lights;
    lights->SetKeyLightAngle(42, -28);
    lights->SetKeyLightIntensity(.92);
    lights->SetKeyToFillRatio(1.7);
    lights->SetKeyToHeadRatio(2.8);
    lights->SetKeyToBackRatio(3.2);
    lights->SetKeyLightWarmth(.56);
    lights->SetFillLightWarmth(.42);
    lights->AddLightsToRenderer(renderer);
}

/* Layers: 0 backdrop, 1 world, 2 front, 3 insets, 4 paper. */
canvas::canvas(int width, int height, backdrop kind, int samples)
    : width_(width), height_(height), samples_(samples)
{
    vtkRenderer *layers[] = {behind_, world_, front_, top_};
    const int numbers[] = {0, 1, 2, 4};
    for (int i = 0; i < 4; i++) {
        layers[i]->SetLayer(numbers[i]);
        layers[i]->InteractiveOff();
        set_lights(layers[i]);
    }
    front_->SetActiveCamera(world_->GetActiveCamera());
    set_backdrop(kind);
}

vtkRenderer *canvas::add_inset(point2 corner, double width, double height)
{
    vtkNew<vtkRenderer> inset;
    double left = corner.x / paper_width(), right = (corner.x + width) / paper_width();
    double top = 1 - corner.y / paper_height, bottom = 1 - (corner.y + height) / paper_height;
    inset->SetViewport(left, bottom, right, top);
    inset->SetLayer(3);
    inset->SetPreserveColorBuffer(0);
    inset->SetBackground(palette::sheet.red / 255.0, palette::sheet.green / 255.0,
                         palette::sheet.blue / 255.0);
    set_lights(inset);
    insets_.push_back(inset.Get());
    return inset;
}

void canvas::on_paper(std::function<void(paper &)> paint)
{
    painters_.push_back(std::move(paint));
}

/* Averages blocks of n x n pixels and turns the rows round: OpenGL's first is the
 * lowest. */
static image averaged(const uint8_t *drawn, int width, int height, int n)
{
    image picture(width, height);
    size_t row_bytes = 3ull * n * width;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            for (int c = 0; c < 3; c++) {
                unsigned sum = n * n / 2;
                for (int dy = 0; dy < n; dy++)
                    for (int dx = 0; dx < n; dx++)
                        sum += drawn[(size_t(height - 1 - y) * n + dy) * row_bytes +
                                     3 * (size_t(x) * n + dx) + c];
                picture.rgb[3 * (size_t(y) * width + x) + c] = uint8_t(sum / (n * n));
            }
    return picture;
}

/* Draws layers into pixels, rows from the lowest on. */
static vtkSmartPointer<vtkUnsignedCharArray> pixels_of(const std::vector<vtkRenderer *> &renderers,
                                                       int width, int height)
{
    vtkNew<headless_window> window;
    if (!window->open(width, height))
        throw std::runtime_error("OpenGL is gone");
    window->SetNumberOfLayers(5);
    for (vtkRenderer *renderer : renderers)
        window->AddRenderer(renderer);
    window->Render();
    std::string error = take_vtk_error();
    if (!error.empty())
        throw std::runtime_error("VTK: " + error);
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetPixelData(0, 0, width - 1, height - 1, 0, pixels.Get(), 0);
    if (pixels->GetNumberOfValues() != vtkIdType(3) * width * height)
        throw std::runtime_error("OpenGL gave no pixels");
    for (vtkRenderer *renderer : renderers)
        window->RemoveRenderer(renderer);
    return pixels.Get();
}

std::vector<vtkRenderer *> canvas::below_paper()
{
    std::vector<vtkRenderer *> renderers = {behind_, world_, front_};
    renderers.insert(renderers.end(), insets_.begin(), insets_.end());
    return renderers;
}

void canvas::draw_world(drawn_world &kept)
{
    kept.width = samples_ * width_;
    kept.height = samples_ * height_;
    vtkSmartPointer<vtkUnsignedCharArray> pixels =
        pixels_of(below_paper(), kept.width, kept.height);
    kept.rgb.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
}

static vtkSmartPointer<vtkImageData> picture_of(const drawn_world &world)
{
    vtkNew<vtkImageData> picture;
    picture->SetDimensions(world.width, world.height, 1);
    picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    std::copy(world.rgb.begin(), world.rgb.end(),
              static_cast<uint8_t *>(picture->GetScalarPointer()));
    return picture.Get();
}

image canvas::draw(drawn_world *kept)
{
    int w = samples_ * width_, h = samples_ * height_;
    vtkNew<painted_item> item;
    item->width = w;
    item->height = h;
    item->painters = painters_;
    vtkNew<vtkContextActor> actor;
    actor->GetScene()->AddItem(item);
    top_->AddActor(actor);
    std::vector<vtkRenderer *> renderers;
    if (kept) {
        if (kept->width != w || kept->height != h)
            draw_world(*kept);
        item->below = picture_of(*kept);
        top_->SetLayer(0);
    } else {
        renderers = below_paper();
    }
    renderers.push_back(top_);
    return averaged(pixels_of(renderers, w, h)->GetPointer(0), width_, height_, samples_);
}
