/* See text.hpp. */
#include "graders/render/text.hpp"

#include <cmath>
#include <cstdio>

/* Bytes of the UTF-8 character at the start of `text`, 0 when there is none. */
static size_t utf8_length(const unsigned char *text, size_t left, uint32_t &code)
{
    size_t length = text[0] < 0x80                      ? 1
                    : text[0] >= 0xc2 && text[0] < 0xe0 ? 2
                    : text[0] >= 0xe0 && text[0] < 0xf0 ? 3
                    : text[0] >= 0xf0 && text[0] < 0xf5 ? 4
                                                        : 0;
    if (length == 0 || length > left)
        return 0;
    code = length == 1 ? text[0] : text[0] & (0x7fu >> length);
    for (size_t i = 1; i < length; i++) {
        if ((text[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (text[i] & 0x3fu);
    }
    static const uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    bool surrogate = code >= 0xd800 && code < 0xe000;
    return code < smallest[length] || code > 0x10ffff || surrogate ? 0 : length;
}

static bool is_invisible(uint32_t code)
{
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x200b && code <= 0x200f) ||
           (code >= 0x2028 && code <= 0x202e) || (code >= 0x2060 && code <= 0x206f) ||
           code == 0xfeff;
}

std::string clean_text(const std::string &text, size_t bytes_limit)
{
    std::string clean;
    auto bytes = reinterpret_cast<const unsigned char *>(text.data());
    for (size_t i = 0; i < text.size();) {
        uint32_t code = 0;
        size_t length = utf8_length(bytes + i, text.size() - i, code);
        std::string piece = length ? text.substr(i, length) : "?";
        if (length && (code == '\n' || code == '\t' || code == '\r'))
            piece = " ";
        else if (length && is_invisible(code))
            piece.clear();
        if (clean.size() + piece.size() > bytes_limit)
            break;
        clean += piece;
        i += length ? length : 1;
    }
    return clean;
}

std::string grouped(int64_t number)
{
    std::string digits = std::to_string(number);
    std::string out;
    size_t sign = number < 0 ? 1 : 0;
    for (size_t i = 0; i < digits.size(); i++) {
        if (i > sign && (digits.size() - i) % 3 == 0)
            out += "\u2009";
        out += digits[i];
    }
    return out;
}

static std::string formatted(double number, int decimals, const char *unit)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, number);
    std::string out = text;
    if (decimals > 0) {
        out.erase(out.find_last_not_of('0') + 1);
        if (out.back() == '.')
            out.pop_back();
    }
    return out + unit;
}

std::string byte_size(double bytes)
{
    static const char *const units[] = {" bytes", " KB", " MB", " GB", " TB", " PB", " EB"};
    int unit = 0;
    for (; bytes >= 1024 && unit < 6; unit++)
        bytes /= 1024;
    if (unit == 0 && bytes == 1)
        return "1 byte";
    return formatted(bytes, unit == 0 ? 0 : bytes < 10 ? 2 : 1, units[unit]);
}

std::string short_number(double number)
{
    static const char *const units[] = {"", "k", "M", "G", "T", "P"};
    if (number < 1) {
        char text[64];
        std::snprintf(text, sizeof text, "%.3g", number);
        return text;
    }
    int unit = 0;
    for (; number >= 999.5 && unit < 5; unit++)
        number /= 1000;
    return formatted(number, number < 10 ? 2 : number < 100 ? 1 : 0, units[unit]);
}
