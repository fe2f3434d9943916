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

    /* Throws std::runtime_error when OpenGL fails. */
    image draw();

  private:
    void set_backdrop(backdrop behind);

    int width_, height_, samples_;
    vtkNew<vtkRenderer> behind_, world_, front_, top_;
    std::vector<vtkSmartPointer<vtkRenderer>> insets_;
    std::vector<std::function<void(paper &)>> painters_;
};

#endif
