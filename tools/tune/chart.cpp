// SPDX-License-Identifier: MIT
#include "tune/chart.hpp"

#include <cairo-svg.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace crease::tools {

namespace {

constexpr double width = 820, height = 460, left = 70, right = 20, top = 20, bottom = 50, line_height = 18;

struct range {
    double least = 0, most = 1;

    double share(double value) const { return (value - least) / (most - least); }
};

/// The values with a twentieth of their range to either side.
range range_of(std::span<const chart_point> points, double (*value)(const chart_point&)) {
    const auto [least, most] = std::ranges::minmax(points, {}, value);
    const double low = value(least), high = value(most), more = std::max((high - low) / 20, 1e-3);
    return {low - more, high + more};
}

struct chart {
    cairo_t* on;
    range x, y;

    double column(double value) const { return left + x.share(std::log10(value)) * (width - left - right); }
    double row(double value) const { return top + (1 - y.share(value)) * (height - top - bottom); }

    void dot(const chart_point& p, double radius) const {
        cairo_new_path(on); // or a line leads to it from the last text
        cairo_arc(on, column(p.x), row(p.y), radius, 0, 2 * std::numbers::pi);
        cairo_fill(on);
    }

    void say(double at_x, double at_y, const std::string& text) const {
        cairo_move_to(on, at_x, at_y);
        cairo_show_text(on, text.c_str());
    }

    void draw_axes(const std::string& across, const std::string& up) const {
        cairo_set_source_rgb(on, 0.8, 0.8, 0.8);
        cairo_rectangle(on, left, top, width - left - right, height - top - bottom);
        for (int i = 1; i < 5; ++i) {
            cairo_move_to(on, left, row(error_at(i)));
            cairo_line_to(on, width - right, row(error_at(i)));
            cairo_move_to(on, column(cost_at(i)), top);
            cairo_line_to(on, column(cost_at(i)), height - bottom);
        }
        cairo_stroke(on);
        cairo_set_source_rgb(on, 0.1, 0.1, 0.1);
        for (int i = 0; i <= 5; ++i) {
            say(8, row(error_at(i)) + 5, fmt::format("{:.4f}", error_at(i)));
            say(std::min(column(cost_at(i)) - 12, width - 50), height - bottom + 18,
                fmt::format("{:.3g}", cost_at(i)));
        }
        say(left, height - bottom + 40, across + ", against " + up);
    }

private:
    double error_at(int i) const { return y.least + (y.most - y.least) * i / 5; }
    double cost_at(int i) const { return std::pow(10, x.least + (x.most - x.least) * i / 5); }
};

cairo_status_t append(void* to, const unsigned char* bytes, unsigned count) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

}

std::string front_chart(std::span<const chart_point> points, const std::string& x, const std::string& y) {
    std::vector<chart_point> named;
    std::ranges::copy_if(points, std::back_inserter(named),
                         [](const chart_point& p) { return !p.name.empty(); });
    std::string bytes;
    const double whole = height + line_height * static_cast<double>(named.size() + 1);
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
        cairo_svg_surface_create_for_stream(append, &bytes, width, whole), cairo_surface_destroy);
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> on(cairo_create(surface.get()), cairo_destroy);
    cairo_set_source_rgb(on.get(), 1, 1, 1);
    cairo_paint(on.get());
    cairo_select_font_face(on.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(on.get(), 13);
    const chart drawn{on.get(), range_of(points, [](const chart_point& p) { return std::log10(p.x); }),
                      range_of(points, [](const chart_point& p) { return p.y; })};
    drawn.draw_axes(x, y);
    cairo_set_source_rgb(on.get(), 0.6, 0.6, 0.6);
    for (const chart_point& p : points)
        drawn.dot(p, 2.5);
    cairo_set_source_rgb(on.get(), 0.1, 0.3, 0.7);
    cairo_new_path(on.get());
    for (const chart_point& p : named)
        cairo_line_to(on.get(), drawn.column(p.x), drawn.row(p.y));
    cairo_stroke(on.get());
    for (std::size_t i = 0; i < named.size(); ++i) {
        const chart_point& p = named[i];
        drawn.dot(p, 4);
        drawn.say(drawn.column(p.x) + 6, drawn.row(p.y) - 6, fmt::format("{}", i + 1));
        drawn.say(left, height + line_height * static_cast<double>(i + 1),
                  fmt::format("{}  {}", i + 1, p.name));
    }
    cairo_surface_finish(surface.get());
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error("cannot draw the chart of the front");
    return bytes;
}

}
