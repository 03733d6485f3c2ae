// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <boost/timer/progress_display.hpp>
#include <fmt/ostream.h>

#include <algorithm>
#include <iostream>
#include <unistd.h>

namespace crease::tools {

struct progress::display {
    virtual ~display() = default;
    virtual void show(double fraction) = 0;
};

struct progress::bar final : display {
    bar(const std::string& label, std::ostream& to) : stars(steps, to, label + "\n") {}

    void show(double fraction) override {
        const auto count = static_cast<unsigned long>(fraction * static_cast<double>(steps));
        if (count > stars.count())
            stars += count - stars.count();
    }

    static constexpr unsigned long steps = 1000;
    boost::timer::progress_display stars;
};

struct progress::lines final : display {
    lines(std::string name, std::ostream& stream) : label(std::move(name)), to(stream) {}

    void show(double fraction) override {
        for (; next <= 4 && fraction * 4 >= next; ++next)
            fmt::print(to, "{}: {} %\n", label, next * 25);
        to.flush();
    }

    std::string label;
    std::ostream& to;
    int next = 0; ///< the quarter to be reported next
};

progress::progress(std::string label) : progress(std::move(label), std::cerr, isatty(STDERR_FILENO) != 0) {}

progress::progress(std::string label, std::ostream& to, bool terminal) {
    if (terminal)
        display_ = std::make_unique<bar>(label, to);
    else
        display_ = std::make_unique<lines>(std::move(label), to);
    display_->show(0);
}

progress::~progress() = default;
progress::progress(progress&&) noexcept = default;
progress& progress::operator=(progress&&) noexcept = default;

void progress::operator()(double fraction) {
    display_->show(std::clamp(fraction, 0.0, 1.0));
}

}
