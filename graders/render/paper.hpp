/* Two-dimensional drawing over a picture, in units that do not depend on its size: the picture is
 * 600 units high, the origin is the upper left corner, y grows downwards. */
#ifndef GRADERS_RENDER_PAPER_HPP
#define GRADERS_RENDER_PAPER_HPP

#include "graders/render/palette.hpp"

#include <string>
#include <vector>
#include <vtkNew.h>

class vtkContext2D;
class vtkTextProperty;

struct point2 {
    double x, y;
};

enum class weight { regular, semibold };
enum class align { left, centre, right };

struct font {
    double size; /* units, from ascender to descender about 1.36 of it */
    weight boldness;
    colour ink;
};

inline constexpr double paper_height = 600;

/* To be called once, before anything is drawn: keeps every face of every font that was opened.
 * Beyond 30 of them (VTK 9.1 counts each size as one) VTK closes some, and then draws letters of
 * another weight into the same word. */
void keep_fonts();

class paper
{
  public:
    paper(vtkContext2D *context, int width_pixels, int height_pixels);

    double width() const
    {
        return width_;
    }
    double height() const
    {
        return paper_height;
    }

    void line(point2 from, point2 to, double width, colour ink); /* with round ends */
    void dashed(point2 from, point2 to, double width, double dash, double gap, colour ink);
    void polyline(const std::vector<point2> &points, double width, colour ink);
    void polygon(const std::vector<point2> &convex, colour fill);
    void rectangle(point2 corner, double width, double height, colour fill);
    void rounded(point2 corner, double width, double height, double radius, colour fill);
    void disc(point2 centre, double radius, colour fill);
    void circle(point2 centre, double radius, double width, colour ink);

    /* Text with its baseline at `at`; returns its width. Cleaned and taken literally. */
    double text(point2 at, const std::string &words, const font &style, align where = align::left);
    /* The same, turned to read upwards around `at`, centred. */
    void upward_text(point2 at, const std::string &words, const font &style);
    double text_width(const std::string &words, const font &style);
    /* The text in lines that fit, at most `line_limit`; the last one takes what is left. */
    std::vector<std::string> wrapped(const std::string &words, const font &style, double width,
                                     size_t line_limit);
    /* The longest beginning of the text that fits, with an ellipsis if it is not the whole. */
    std::string fitting(const std::string &words, const font &style, double width);

  private:
    void set_fill(colour fill);
    void set_font(const font &style);

    vtkContext2D *context_;
    double scale_; /* pixels a unit */
    double width_;
    double height_pixels_;
};

#endif
