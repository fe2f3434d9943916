/* The axis of a chart: its range and the ticks that read well. No drawing here. */
#ifndef GRADERS_RENDER_AXIS_HPP
#define GRADERS_RENDER_AXIS_HPP

#include <string>
#include <vector>

struct tick {
    double value;
    std::string label; /* empty for minor ticks */
};

struct chart_axis {
    double low = 1, high = 10;
    bool linear = false; /* else logarithmic */
    std::vector<tick> ticks;

    /* Where a value lies, 0 at low and 1 at high. */
    double place(double value) const;
};

/* A logarithmic axis for the values (in [1e-12, 1e18]), with a little air on both sides.
 *
 * label  names what is measured; one that speaks of bytes gets binary ticks ("64 KB", "1 MB", where
 *        1 KB = 1024 bytes)
 * most_ticks  how many have room */
chart_axis make_axis(const std::vector<double> &values, const std::string &label,
                     size_t most_ticks = 7);

/* An axis whose ticks are these values, when they are few enough to be named one by one; else like
 * make_axis. For sizes that were chosen, 128, 256, 512, ... */
chart_axis make_axis_of_sizes(const std::vector<double> &values, const std::string &label);

/* A linear axis from 0 over all values (none below 0). */
chart_axis make_linear_axis(const std::vector<double> &values);

#endif
