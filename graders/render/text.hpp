/* Texts for pictures: cleaning strangers' text, and writing numbers for people. */
#ifndef GRADERS_RENDER_TEXT_HPP
#define GRADERS_RENDER_TEXT_HPP

#include <cstddef>
#include <cstdint>
#include <string>

/* Valid UTF-8 without control characters or direction overrides, at most `bytes_limit` bytes, never
 * cut within a character. Bytes that are not UTF-8 become "?". Line ends become spaces. */
std::string clean_text(const std::string &text, size_t bytes_limit);

/* 10983 as "10 983", with a thin space. */
std::string grouped(int64_t number);

/* 512 as "512 bytes", 592908 as "579.0 KB" (1 KB = 1024 bytes, as in the course). */
std::string byte_size(double bytes);

/* Short labels for axes: 950, "1k", "12.5k", "3M"; 0.001 stays "0.001". */
std::string short_number(double number);

#endif
