/* See json_values.hpp. */
#include "graders/render/json_values.hpp"
#include "graders/render/scene.hpp"
#include "graders/render/text.hpp"

#include <cmath>
#include <cstring>

static const size_t text_bytes_limit = 300;
static const size_t point_limit = 10000;

/* The string that takes the place of a value, or null: it is no text in several languages. */
static json_t *chosen(json_t *value, const std::string &language)
{
    json_t *english = json_object_get(value, "en");
    json_t *text = json_object_get(value, language.c_str());
    if (!json_is_string(english))
        return nullptr;
    return json_is_string(text) ? text : english;
}

void choose_language(json_t *json, const std::string &language)
{
    if (json_is_array(json)) {
        for (size_t i = 0; i < json_array_size(json); i++) {
            json_t *value = json_array_get(json, i), *text = chosen(value, language);
            if (text)
                json_array_set(json, i, text);
            else
                choose_language(value, language);
        }
        return;
    }
    for (void *at = json_object_iter(json); at; at = json_object_iter_next(json, at)) {
        json_t *value = json_object_iter_value(at), *text = chosen(value, language);
        if (text)
            json_object_iter_set(json, at, text);
        else
            choose_language(value, language);
    }
}

std::string text_at(const json_t *json, const char *key)
{
    const json_t *value = json_object_get(json, key);
    if (json_is_object(value))
        value = json_object_get(value, "en");
    if (!json_is_string(value))
        return "";
    return clean_text({json_string_value(value), json_string_length(value)}, text_bytes_limit);
}

int64_t integer_at(const json_t *json, const char *key, int64_t largest, const char *what)
{
    const json_t *value = json_object_get(json, key);
    int64_t number = json_is_integer(value) ? json_integer_value(value) : -1;
    if (number < 0 || number > largest)
        throw not_showable(std::string(what) + ": " +
                           (json_is_integer(value)
                                ? std::to_string(json_integer_value(value)) +
                                      " is not between 0 and " + std::to_string(largest)
                                : "not said"));
    return number;
}

static int digit_of(char c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = c ? std::strchr(digits, c) : nullptr;
    return at ? int(at - digits) : -1;
}

std::vector<uint8_t> bytes_at(const json_t *json, const char *key, size_t count)
{
    const json_t *value = json_object_get(json, key);
    std::string name = key;
    if (!json_is_string(value) || json_string_length(value) != (count + 2) / 3 * 4)
        throw not_showable(name + " does not hold " + std::to_string(count) + " bytes");
    const char *text = json_string_value(value);
    std::vector<uint8_t> bytes(count);
    uint32_t group = 0;
    for (size_t i = 0, out = 0; out < count; i++) {
        int digit = digit_of(text[i]);
        if (digit < 0)
            throw not_showable(name + " is not base64");
        group = group << 6 | uint32_t(digit);
        if (i % 4 != 0)
            bytes[out++] = uint8_t(group >> (6 - 2 * (i % 4)));
    }
    return bytes;
}

std::vector<double> numbers_at(const json_t *json, const char *key)
{
    const json_t *list = json_object_get(json, key);
    if (json_array_size(list) > point_limit)
        throw not_showable("more points than a chart can show");
    std::vector<double> numbers;
    for (size_t i = 0; i < json_array_size(list); i++)
        numbers.push_back(json_number_value(json_array_get(list, i)));
    return numbers;
}

double number_at(const json_t *json, const char *key)
{
    const double most = 1e18;
    const json_t *value = json_object_get(json, key);
    double number = json_number_value(value);
    return json_is_number(value) && std::fabs(number) <= most ? number : std::nan("");
}
