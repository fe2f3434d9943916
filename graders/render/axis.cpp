/* See axis.hpp. */
#include "graders/render/axis.hpp"
#include "graders/render/text.hpp"

#include <algorithm>
#include <cmath>

static const size_t ticks_enough = 7;
static const double least_gap = .06; /* between two ticks, of the axis */

double chart_axis::place(double value) const
{
    if (linear)
        return (value - low) / (high - low);
    return std::log(value / low) / std::log(high / low);
}

static bool speaks_of_bytes(const std::string &label)
{
    return label.find("byte") != std::string::npos;
}

static std::string label_of(double value, bool bytes)
{
    if (bytes)
        return byte_size(value);
    bool whole = value == std::floor(value) && value < 10000;
    return whole ? std::to_string(int(value)) : short_number(value);
}

/* At least a factor of two, and air on both sides. */
static chart_axis range_of(const std::vector<double> &values)
{
    chart_axis axis;
    if (!values.empty()) {
        axis.low = *std::min_element(values.begin(), values.end());
        axis.high = *std::max_element(values.begin(), values.end());
    }
    double air =
        std::max(std::pow(axis.high / axis.low, .05), axis.high < 2 * axis.low ? 1.6 : 1.0);
    axis.low /= air;
    axis.high *= air;
    return axis;
}

static std::vector<double> steps(const chart_axis &axis, double base,
                                 const std::vector<double> &parts)
{
    std::vector<double> values;
    double start = std::pow(base, std::floor(std::log(axis.low) / std::log(base)));
    for (double power = start; power <= axis.high; power *= base)
        for (double part : parts)
            if (power * part >= axis.low && power * part <= axis.high)
                values.push_back(power * part);
    return values;
}

/* The finest steps that are not too many; always something, even for a range within one step. */
static std::vector<double> chosen_steps(const chart_axis &axis, bool bytes, size_t most_ticks)
{
    using parts = std::vector<double>;
    std::vector<std::pair<double, parts>> choices;
    if (bytes)
        for (double base : {2.0, 4.0, 16.0, 64.0, 1024.0, 65536.0, 1048576.0})
            choices.push_back({base, {1}});
    else
        choices = {{10, {1, 2, 5}}, {10, {1, 3}}, {10, {1}}, {100, {1}}, {1000, {1}}, {1e6, {1}}};
    for (const auto &[base, fractions] : choices) {
        std::vector<double> values = steps(axis, base, fractions);
        if (values.size() <= most_ticks)
            return values;
    }
    return {};
}

/* Of the values themselves those that leave room for their names. */
static std::vector<double> apart(const chart_axis &axis, std::vector<double> values)
{
    std::vector<double> chosen;
    std::sort(values.begin(), values.end());
    for (double value : values)
        if (chosen.empty() || axis.place(value) - axis.place(chosen.back()) > least_gap)
            chosen.push_back(value);
    return chosen;
}

chart_axis make_axis(const std::vector<double> &values, const std::string &label, size_t most_ticks)
{
    chart_axis axis = range_of(values);
    bool bytes = speaks_of_bytes(label);
    std::vector<double> named = chosen_steps(axis, bytes, most_ticks);
    if (named.size() < 2)
        named = apart(axis, values);
    for (double value : named)
        axis.ticks.push_back({value, label_of(value, bytes)});
    return axis;
}

chart_axis make_axis_of_sizes(const std::vector<double> &values, const std::string &label)
{
    std::vector<double> sizes = values;
    std::sort(sizes.begin(), sizes.end());
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    chart_axis axis = range_of(sizes);
    if (sizes.size() < 2 || sizes.size() > ticks_enough + 2)
        return make_axis(values, label);
    for (size_t i = 1; i < sizes.size(); i++)
        if (axis.place(sizes[i]) - axis.place(sizes[i - 1]) < least_gap)
            return make_axis(values, label);
    for (double size : sizes)
        axis.ticks.push_back({size, label_of(size, speaks_of_bytes(label))});
    return axis;
}

chart_axis make_linear_axis(const std::vector<double> &values)
{
    const double most_steps = 8, air = 1.04;
    double most = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
    chart_axis axis;
    axis.linear = true;
    axis.low = 0;
    axis.high = most > 0 ? most * air : 1;
    double step = std::pow(10, std::floor(std::log10(axis.high)));
    for (double part : {.1, .2, .5, 1.0})
        if (axis.high / (step * part) <= most_steps) {
            step *= part;
            break;
        }
    for (int i = 0; i * step <= axis.high; i++)
        axis.ticks.push_back({i * step, i == 0 ? "0" : label_of(i * step, false)});
    return axis;
}
