/* See paper.hpp. */
#include "graders/render/paper.hpp"
#include "graders/render/text.hpp"

#include <algorithm>
#include <cmath>
#include <unistd.h>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkFreeTypeTools.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

void keep_fonts()
{
    vtkFreeTypeTools::GetInstance()->SetMaximumNumberOfFaces(4096);
}

static const double descent = .22; /* of a font's size */

paper::paper(vtkContext2D *context, int width_pixels, int height_pixels)
    : context_(context), scale_(height_pixels / paper_height), width_(width_pixels / scale_),
      height_pixels_(height_pixels)
{
}

void paper::set_fill(colour fill)
{
    context_->GetPen()->SetLineType(vtkPen::NO_PEN);
    context_->GetBrush()->SetColor(fill.red, fill.green, fill.blue, fill.alpha);
}

void paper::polygon(const std::vector<point2> &convex, colour fill)
{
    std::vector<float> xy;
    for (point2 p : convex) {
        xy.push_back(float(p.x * scale_));
        xy.push_back(float(height_pixels_ - p.y * scale_));
    }
    set_fill(fill);
    context_->DrawPolygon(xy.data(), int(convex.size()));
}

void paper::rectangle(point2 corner, double width, double height, colour fill)
{
    polygon({corner,
             {corner.x + width, corner.y},
             {corner.x + width, corner.y + height},
             {corner.x, corner.y + height}},
            fill);
}

static std::vector<point2> arc(point2 centre, double radius, double from_degrees, int steps,
                               double degrees)
{
    std::vector<point2> points;
    for (int i = 0; i <= steps; i++) {
        double angle = (from_degrees + degrees * i / steps) * M_PI / 180;
        points.push_back(
            {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return points;
}

void paper::rounded(point2 corner, double width, double height, double radius, colour fill)
{
    const point2 centres[] = {{corner.x + width - radius, corner.y + height - radius},
                              {corner.x + radius, corner.y + height - radius},
                              {corner.x + radius, corner.y + radius},
                              {corner.x + width - radius, corner.y + radius}};
    std::vector<point2> outline;
    for (int i = 0; i < 4; i++) {
        std::vector<point2> quarter = arc(centres[i], radius, 90.0 * i, 8, 90);
        outline.insert(outline.end(), quarter.begin(), quarter.end());
    }
    polygon(outline, fill);
}

void paper::disc(point2 centre, double radius, colour fill)
{
    polygon(arc(centre, radius, 0, 36, 360), fill);
}

void paper::circle(point2 centre, double radius, double width, colour ink)
{
    polyline(arc(centre, radius, 0, 48, 360), width, ink);
}

void paper::line(point2 from, point2 to, double width, colour ink)
{
    double dx = to.x - from.x, dy = to.y - from.y;
    double length = std::hypot(dx, dy);
    if (!(length > 0))
        return disc(from, width / 2, ink);
    double degrees = std::atan2(dy, dx) * 180 / M_PI;
    std::vector<point2> outline = arc(to, width / 2, degrees - 90, 8, 180);
    std::vector<point2> tail = arc(from, width / 2, degrees + 90, 8, 180);
    outline.insert(outline.end(), tail.begin(), tail.end());
    polygon(outline, ink);
}

void paper::dashed(point2 from, point2 to, double width, double dash, double gap, colour ink)
{
    double length = std::hypot(to.x - from.x, to.y - from.y);
    for (double at = 0; at < length; at += dash + gap) {
        double end = std::min(length, at + dash);
        line({from.x + (to.x - from.x) * at / length, from.y + (to.y - from.y) * at / length},
             {from.x + (to.x - from.x) * end / length, from.y + (to.y - from.y) * end / length},
             width, ink);
    }
}

void paper::polyline(const std::vector<point2> &points, double width, colour ink)
{
    for (size_t i = 1; i < points.size(); i++)
        line(points[i - 1], points[i], width, ink);
}

static const char *font_file(weight boldness)
{
    static const char *const regular[] = {
        "/usr/share/fonts/truetype/open-sans/OpenSans-Regular.ttf",
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"};
    static const char *const semibold[] = {
        "/usr/share/fonts/truetype/open-sans/OpenSans-Semibold.ttf",
        "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"};
    for (const char *file : boldness == weight::regular ? regular : semibold)
        if (access(file, R_OK) == 0)
            return file;
    return nullptr;
}

void paper::set_font(const font &style)
{
    static const char *const files[] = {font_file(weight::regular), font_file(weight::semibold)};
    vtkTextProperty *property = context_->GetTextProp();
    const char *file = files[style.boldness == weight::semibold];
    if (file) {
        property->SetFontFamily(VTK_FONT_FILE);
        property->SetFontFile(file);
    } else {
        property->SetFontFamilyToArial();
        property->SetBold(style.boldness == weight::semibold);
    }
    property->SetFontSize(std::max(4, int(std::lround(style.size * scale_))));
    property->SetColor(style.ink.red / 255.0, style.ink.green / 255.0, style.ink.blue / 255.0);
    property->SetOpacity(style.ink.alpha / 255.0);
    property->SetOrientation(0);
    property->SetJustificationToLeft();
    property->SetVerticalJustificationToBottom();
}

/* VTK reads "$...$" as a formula. */
static std::string literal(const std::string &words)
{
    std::string out;
    for (char c : clean_text(words, 400)) {
        if (c == '$')
            out += '\\';
        out += c;
    }
    return out;
}

double paper::text(point2 at, const std::string &words, const font &style, align where)
{
    double width = text_width(words, style);
    double left = where == align::left    ? at.x
                  : where == align::right ? at.x - width
                                          : at.x - width / 2;
    /* VTK's bottom is that of the descenders. */
    double bottom = at.y + descent * style.size;
    context_->DrawString(float(std::lround(left * scale_)),
                         float(std::lround(height_pixels_ - bottom * scale_)),
                         literal(words).c_str());
    return width;
}

void paper::upward_text(point2 at, const std::string &words, const font &style)
{
    set_font(style);
    context_->GetTextProp()->SetOrientation(90);
    context_->GetTextProp()->SetJustificationToCentered();
    context_->DrawString(float(at.x * scale_), float(height_pixels_ - at.y * scale_),
                         literal(words).c_str());
}

double paper::text_width(const std::string &words, const font &style)
{
    set_font(style);
    float bounds[4] = {0, 0, 0, 0};
    if (!words.empty())
        context_->ComputeStringBounds(literal(words).c_str(), bounds);
    return bounds[2] / scale_;
}

std::string paper::fitting(const std::string &words, const font &style, double width)
{
    std::string whole = clean_text(words, 400);
    if (text_width(whole, style) <= width)
        return whole;
    size_t fits = 0, too_long = whole.size();
    while (fits + 1 < too_long) {
        size_t middle = (fits + too_long) / 2;
        bool short_enough = text_width(clean_text(whole, middle) + "\u2026", style) <= width;
        (short_enough ? fits : too_long) = middle;
    }
    return clean_text(whole, fits) + "\u2026";
}

std::vector<std::string> paper::wrapped(const std::string &words, const font &style, double width,
                                        size_t line_limit)
{
    std::string left = clean_text(words, 400);
    std::vector<std::string> lines;
    while (!left.empty() && lines.size() + 1 < line_limit && text_width(left, style) > width) {
        size_t end = std::string::npos;
        for (size_t space = left.find(' '); space != std::string::npos;
             space = left.find(' ', space + 1)) {
            if (text_width(left.substr(0, space), style) > width)
                break;
            end = space;
        }
        if (end == std::string::npos)
            break; /* one word wider than the line */
        lines.push_back(left.substr(0, end));
        left = left.substr(end + 1);
    }
    if (!left.empty())
        lines.push_back(fitting(left, style, width));
    return lines;
}
