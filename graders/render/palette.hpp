/* The colours of all pictures. Those that tell things apart stay apart in the common kinds of
 * colour blindness (checked with the Okabe-Ito set as the start); shapes and words say the same
 * again. */
#ifndef GRADERS_RENDER_PALETTE_HPP
#define GRADERS_RENDER_PALETTE_HPP

#include <cstdint>

struct colour {
    uint8_t red, green, blue;
    uint8_t alpha = 255;

    colour with_alpha(double opacity) const
    {
        return {red, green, blue, static_cast<uint8_t>(opacity * 255 + .5)};
    }
    colour darker(double factor) const
    {
        return {static_cast<uint8_t>(red * factor), static_cast<uint8_t>(green * factor),
                static_cast<uint8_t>(blue * factor), alpha};
    }
};

namespace palette
{
inline constexpr colour ink = {26, 33, 46};
inline constexpr colour grey_ink = {74, 84, 99};
inline constexpr colour pale_ink = {146, 155, 168};
inline constexpr colour hairline = {222, 227, 234};
inline constexpr colour paper = {255, 255, 255};
inline constexpr colour sheet = {237, 240, 245};
inline constexpr colour backdrop_centre = {249, 251, 255};
inline constexpr colour backdrop_corner = {209, 214, 223};
inline constexpr colour surface = {230, 236, 245};
inline constexpr colour back_face = {244, 208, 170};
inline constexpr colour wire = {26, 36, 51};

/* By enum mark_kind: missing, duplicate, extra, degenerate, boundary, flipped, wrong, right, and
 * the six turn colours, which are no fault: darker and duller, so that faults stand out among them.
 */
inline constexpr colour marks[] = {{214, 32, 47},  {232, 116, 0},  {190, 25, 160},  {0, 104, 190},
                                   {240, 196, 0},  {168, 62, 22},  {60, 40, 120},   {0, 128, 96},
                                   {66, 110, 170}, {146, 112, 48}, {104, 178, 214}, {112, 122, 138},
                                   {120, 132, 62}, {180, 124, 152}};

/* Strips in turn. */
inline constexpr colour strips[] = {{86, 160, 211},  {240, 186, 92},  {158, 150, 206},
                                    {236, 226, 128}, {214, 140, 178}, {178, 192, 202}};

/* Curves: submission and reference are always the first two. */
inline constexpr colour curves[] = {{213, 74, 20},  {0, 104, 180}, {0, 146, 108},
                                    {180, 84, 150}, {222, 146, 0}, {70, 160, 210}};

/* Series, bars and arrows of figures, by number: the curves' and two greys. */
inline constexpr colour looks[] = {{213, 74, 20}, {0, 104, 180},  {0, 146, 108},   {180, 84, 150},
                                   {222, 146, 0}, {70, 160, 210}, {128, 138, 152}, {52, 62, 78}};
inline constexpr int look_count = 8;

/* Heat maps, from little to much; its lightness falls evenly. */
inline constexpr colour heat[] = {{255, 253, 226}, {217, 236, 190}, {147, 208, 188}, {72, 168, 191},
                                  {40, 112, 170},  {32, 64, 124},   {18, 28, 70}};
} // namespace palette

#endif
