/* Round things made of triangles: tubes, balls and cones of one colour, as one actor. */
#ifndef GRADERS_RENDER_SOLIDS_HPP
#define GRADERS_RENDER_SOLIDS_HPP

#include "graders/render/palette.hpp"
#include "graders/render/vec.hpp"

#include <vtkActor.h>
#include <vtkSmartPointer.h>

enum class finish { lit, ghost, flat }; /* ghost: pale and unlit, for what is hidden */

class solids
{
  public:
    void ball(vec3 centre, double radius);
    void tube(vec3 from, vec3 to, double radius); /* with round ends */
    void cone(vec3 base, vec3 tip, double radius);
    void patch(vec3 a, vec3 b, vec3 c);
    bool empty() const
    {
        return triangles_.empty();
    }
    vtkSmartPointer<vtkActor> actor(colour paint, finish look) const;
    /* A rim of one colour around all of it, so wide. */
    vtkSmartPointer<vtkActor> rim(colour paint, double width) const;

  private:
    int32_t add(vec3 point, vec3 normal);
    vtkSmartPointer<vtkActor> actor_of(const std::vector<vec3> &points, colour paint,
                                       finish look) const;

    std::vector<vec3> points_, normals_;
    std::vector<triangle> triangles_;
};

#endif
