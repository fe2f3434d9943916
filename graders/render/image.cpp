/* See image.hpp. */
#include "graders/render/image.hpp"
#include "graders/render/text.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <stdexcept>

static const size_t note_bytes_limit = 200;

static OIIO::ImageBuf buffer_of(const image &picture)
{
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    OIIO::ImageBuf buffer(spec);
    std::memcpy(buffer.localpixels(), picture.rgb.data(), picture.rgb.size());
    return buffer;
}

static image image_of(const OIIO::ImageBuf &buffer)
{
    image picture(buffer.spec().width, buffer.spec().height);
    OIIO::ROI roi = buffer.roi();
    roi.chend = 3;
    if (!buffer.get_pixels(roi, OIIO::TypeDesc::UINT8, picture.rgb.data()))
        throw std::runtime_error(buffer.geterror());
    return picture;
}

static std::string lower_extension(const std::string &path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/* JPEG and TIFF keep only ImageDescription, so everything stands there too. */
static void attach_notes(OIIO::ImageSpec &spec, const image_notes &notes,
                         const std::string &extension)
{
    std::string description = clean_text(notes.title, note_bytes_limit);
    for (const auto &[key, value] : notes.metadata) {
        std::string name = clean_text(key, 40), text = clean_text(value, note_bytes_limit);
        spec.attribute("meshgrade:" + name, text);
        description += "; " + name + ": " + text;
    }
    spec.attribute("ImageDescription", description);
    spec.attribute("Software", "meshgrade");
    /* Without it TIFF and EXR get the time of writing, and the same picture other bytes. */
    if (extension == ".tif" || extension == ".tiff" || extension == ".exr")
        spec.attribute("DateTime", "1980:01:01 00:00:00");
    spec.attribute("png:compressionLevel", 6);
    const int all_png_filters = 0xf8;
    spec.attribute("png:filter", all_png_filters);
}

static std::string compression_for(const std::string &extension)
{
    if (extension == ".jpg" || extension == ".jpeg")
        return "jpeg:92";
    return extension == ".exr" ? "piz" : "zip";
}

void write_image(const image &picture, const image_notes &notes, const std::string &path)
{
    std::string extension = lower_extension(path);
    OIIO::ImageBuf buffer = buffer_of(picture);
    if (extension == ".exr") {
        buffer = OIIO::ImageBufAlgo::colorconvert(buffer, "sRGB", "linear");
        buffer.set_write_format(OIIO::TypeDesc::HALF);
    }
    attach_notes(buffer.specmod(), notes, extension);
    buffer.specmod().attribute("compression", compression_for(extension));
    std::string part = path + ".part" + extension;
    std::error_code failed;
    if (!buffer.write(part)) {
        std::string why = buffer.geterror();
        std::filesystem::remove(part, failed);
        throw std::runtime_error(why.empty() ? "cannot write " + path : why);
    }
    std::filesystem::rename(part, path, failed);
    if (failed)
        throw std::runtime_error("cannot rename to " + path + ": " + failed.message());
}

image read_image(const std::string &path)
{
    const int side_limit = 16384;
    OIIO::ImageBuf buffer(path);
    if (!buffer.read(0, 0, true, OIIO::TypeDesc::UINT8))
        throw std::runtime_error(buffer.geterror());
    const OIIO::ImageSpec &spec = buffer.spec();
    if (spec.width > side_limit || spec.height > side_limit || spec.nchannels < 1)
        throw std::runtime_error(path + ": no picture of a size that can be shown");
    if (spec.get_string_attribute("oiio:ColorSpace") == "Linear")
        buffer = OIIO::ImageBufAlgo::colorconvert(buffer, "linear", "sRGB");
    if (buffer.nchannels() < 3)
        buffer = OIIO::ImageBufAlgo::channels(buffer, 3, {0, 0, 0});
    return image_of(buffer);
}

image fit_image(const image &picture, int width, int height)
{
    double scale = std::min(double(width) / picture.width, double(height) / picture.height);
    int w = std::max(1, int(picture.width * scale + .5));
    int h = std::max(1, int(picture.height * scale + .5));
    OIIO::ImageBuf small = OIIO::ImageBufAlgo::resize(buffer_of(picture), "triangle", 0,
                                                      OIIO::ROI(0, w, 0, h, 0, 1, 0, 3));
    if (small.has_error())
        throw std::runtime_error(small.geterror());
    image fitted(width, height);
    for (size_t i = 0; i < fitted.rgb.size(); i++)
        fitted.rgb[i] = picture.rgb[i % 3];
    paste_image(fitted, image_of(small), (width - w) / 2, (height - h) / 2);
    return fitted;
}

void paste_image(image &whole, const image &part, int x, int y)
{
    int left = std::max(0, x), right = std::min(whole.width, x + part.width);
    int top = std::max(0, y), bottom = std::min(whole.height, y + part.height);
    for (int row = top; row < bottom && left < right; row++)
        std::memcpy(&whole.rgb[3 * (size_t(row) * whole.width + left)],
                    &part.rgb[3 * (size_t(row - y) * part.width + (left - x))],
                    3 * size_t(right - left));
}
