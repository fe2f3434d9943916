/* Values out of a scene's JSON, which may hold anything. */
#ifndef GRADERS_RENDER_JSON_VALUES_HPP
#define GRADERS_RENDER_JSON_VALUES_HPP

#include <cstdint>
#include <jansson.h>
#include <string>
#include <vector>

/* Puts one language ("en", "es") in the place of every text that is there in several: a string for
 * {"en": "...", "es": "..."}. Where that language is absent, English stands. */
void choose_language(json_t *json, const std::string &language);

/* A text, cleaned and cut; empty when there is none. */
std::string text_at(const json_t *json, const char *key);

/* A whole number of 0 ... largest; throws not_showable, calling it `what`. */
int64_t integer_at(const json_t *json, const char *key, int64_t largest, const char *what);

/* The bytes of a base64 text, which must be exactly `count`; throws not_showable. */
std::vector<uint8_t> bytes_at(const json_t *json, const char *key, size_t count);

/* An array of numbers, 0 for what is none; throws not_showable when a chart cannot show so many. */
std::vector<double> numbers_at(const json_t *json, const char *key);

/* A finite number of at most 1e18 in size, or NaN. */
double number_at(const json_t *json, const char *key);

#endif
