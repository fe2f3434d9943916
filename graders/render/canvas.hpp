/* A picture being drawn: a backdrop, the world, what lies in front of the world, and paper on top.
 */
#ifndef GRADERS_RENDER_CANVAS_HPP
#define GRADERS_RENDER_CANVAS_HPP

#include "graders/render/image.hpp"
#include "graders/render/paper.hpp"

#include <functional>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

enum class backdrop { gradient, plain };

/* What a canvas drew below its paper. The same picture with other words needs only new paper. */
struct drawn_world {
    int width = 0, height = 0; /* 0: nothing was drawn yet */
    std::vector<uint8_t> rgb;  /* rows from the lowest on, as OpenGL has them */
};

class canvas
{
  public:
    /* Pixels of the finished picture; it is drawn `samples` times as wide and high and averaged. */
    canvas(int width, int height, backdrop behind, int samples = 2);

    vtkRenderer *world()
    {
        return world_;
    }
    /* Drawn over the world without regard to what hides what; shares the world's camera. */
    vtkRenderer *front()
    {
        return front_;
    }
    /* Pixels of the drawn (not the finished) picture a unit of paper. */
    double scale() const
    {
        return samples_ * height_ / paper_height;
    }
    double paper_width() const
    {
        return paper_height * width_ / height_;
    }

    /* A picture in the picture: a renderer for a rectangle of the paper, over world and front, with
     * a plain background. The canvas owns it. */
    vtkRenderer *add_inset(point2 corner, double width, double height);

    /* Adds something to draw on the paper; called at draw(), in order. */
    void on_paper(std::function<void(paper &)> paint);

    /* Throws std::runtime_error when OpenGL fails.
     *
     * kept  of an earlier canvas with the same world, which is then not drawn again; gets what was
     *       drawn when it holds nothing; null: draw everything at once */
    image draw(drawn_world *kept = nullptr);

  private:
    std::vector<vtkRenderer *> below_paper();
    void draw_world(drawn_world &kept);
    void set_backdrop(backdrop behind);

    int width_, height_, samples_;
    vtkNew<vtkRenderer> behind_, world_, front_, top_;
    std::vector<vtkSmartPointer<vtkRenderer>> insets_;
    std::vector<std::function<void(paper &)>> painters_;
};

#endif
