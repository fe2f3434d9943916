/* See marker.hpp. */
#include "graders/render/marker.hpp"

#include <cmath>
#include <iterator>

void draw_marker(paper &sheet, point2 at, size_t look, double size, colour paint)
{
    static const int corners_of[] = {4, 0, 3, 4, 3, 6}; /* 0: a disc */
    static const double turn_of[] = {45, 0, -90, 0, 90, 0};
    look %= std::size(corners_of);
    int corners = corners_of[look];
    auto shape = [&](double radius, colour fill) {
        if (corners == 0)
            return sheet.disc(at, radius, fill);
        double reach = radius * (corners == 3 ? 1.35 : 1.2);
        std::vector<point2> outline;
        for (int i = 0; i < corners; i++) {
            double angle = (turn_of[look] + 360.0 * i / corners) * M_PI / 180;
            outline.push_back({at.x + reach * std::cos(angle), at.y + reach * std::sin(angle)});
        }
        sheet.polygon(outline, fill);
    };
    shape(size + 1.6, palette::paper);
    shape(size, paint);
}
