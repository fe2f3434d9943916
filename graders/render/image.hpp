/* Pictures in memory, and writing and reading them with OpenImageIO. */
#ifndef GRADERS_RENDER_IMAGE_HPP
#define GRADERS_RENDER_IMAGE_HPP

#include <cstdint>
#include <map>
#include <string>
#include <vector>

struct image {
    int width = 0;
    int height = 0;
    std::vector<uint8_t> rgb; /* sRGB, rows from the top, 3 bytes a pixel */

    image() = default;
    image(int columns, int rows) : width(columns), height(rows), rgb(3ull * columns * rows)
    {
    }
};

/* What travels in the file beside the pixels. Everything in it may be a stranger's text: control
 * characters are dropped and each text is cut at 200 bytes. */
struct image_notes {
    std::string title;
    std::map<std::string, std::string> metadata; /* exercise, case, verdict, seed, student */
};

/* Writes a picture in the format that the extension of `path` names: png, exr (half float, linear),
 * tif, jpg. The file appears whole or not at all, and holds no clock. Throws std::runtime_error. */
void write_image(const image &picture, const image_notes &notes, const std::string &path);

/* Reads any picture as 8-bit sRGB; throws std::runtime_error. */
image read_image(const std::string &path);

/* The picture at another size, with its proportions kept and the rest filled with the colour of its
 * corner. */
image fit_image(const image &picture, int width, int height);

/* Copies `part` into `whole` with its upper left corner at (x, y); what falls outside is dropped.
 */
void paste_image(image &whole, const image &part, int x, int y);

#endif
