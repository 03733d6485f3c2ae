// SPDX-License-Identifier: MIT
#include "frame/sheet.hpp"

#include "image/file.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace crease::tools {

namespace {

using surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

constexpr double margin = 12, line_height = 20, font_size = 15;

surface make_surface(unsigned width, unsigned height) {
    surface made(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)),
        cairo_surface_destroy);
    if (cairo_surface_status(made.get()) != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(fmt::format("cannot make a sheet of {} x {} pixels: {}", width, height,
                                             cairo_status_to_string(cairo_surface_status(made.get()))));
    return made;
}

surface grey_surface(const image& picture) {
    surface made = make_surface(picture.width, picture.height);
    cairo_surface_flush(made.get());
    unsigned char* bytes = cairo_image_surface_get_data(made.get());
    const int stride = cairo_image_surface_get_stride(made.get());
    for (unsigned y = 0; y < picture.height; ++y)
        for (unsigned x = 0; x < picture.width; ++x) {
            const auto grey =
                static_cast<unsigned char>(std::lround(std::clamp(picture.at(x, y), 0.0f, 1.0f) * 255.0f));
            unsigned char* texel = bytes + static_cast<std::ptrdiff_t>(y) * stride + std::ptrdiff_t{x} * 4;
            texel[0] = texel[1] = texel[2] = grey;
        }
    cairo_surface_mark_dirty(made.get());
    return made;
}

void draw_cell(cairo_t* on, const sheet_cell& cell, double x, double y) {
    const surface picture = grey_surface(cell.picture);
    cairo_set_source_surface(on, picture.get(), x, y);
    cairo_paint(on);
    cairo_set_source_rgb(on, 0.1, 0.1, 0.1);
    double baseline = y + cell.picture.height + line_height;
    for (const std::string& line : cell.lines) {
        cairo_move_to(on, x, baseline);
        cairo_show_text(on, line.c_str());
        baseline += line_height;
    }
}

cairo_status_t append(void* to, const unsigned char* bytes, unsigned count) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

}

void write_sheet(const std::filesystem::path& path, const std::vector<sheet_cell>& cells, unsigned columns) {
    std::size_t lines = 0;
    for (const sheet_cell& cell : cells)
        lines = std::max(lines, cell.lines.size());
    const double cell_width = cells.at(0).picture.width + margin;
    const double cell_height =
        cells[0].picture.height + line_height * static_cast<double>(lines) + 2 * margin;
    const std::size_t rows = (cells.size() + columns - 1) / columns;
    const surface sheet =
        make_surface(static_cast<unsigned>(cell_width * columns + margin),
                     static_cast<unsigned>(cell_height * static_cast<double>(rows) + margin));
    const context on(cairo_create(sheet.get()), cairo_destroy);
    cairo_set_source_rgb(on.get(), 1, 1, 1);
    cairo_paint(on.get());
    cairo_select_font_face(on.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(on.get(), font_size);
    for (std::size_t i = 0; i < cells.size(); ++i)
        draw_cell(on.get(), cells[i], margin + cell_width * static_cast<double>(i % columns),
                  margin + cell_height * static_cast<double>(i / columns));
    std::string bytes;
    if (cairo_surface_write_to_png_stream(sheet.get(), append, &bytes) != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(fmt::format("cannot encode the contact sheet '{}'", path.string()));
    write_atomically(path, bytes);
}

}
