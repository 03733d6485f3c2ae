// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <ostream>
#include <string>

namespace crease::tools {

/// Shows the progress of something long: a bar on a terminal, else one line at each quarter, which suits
/// logs.
class progress {
public:
    /// On stderr; a bar where that is a terminal.
    explicit progress(std::string label);
    progress(std::string label, std::ostream& to, bool terminal);
    ~progress();
    progress(progress&&) noexcept;
    progress& operator=(progress&&) noexcept;

    /// @param fraction done, 0 to 1; never shown to go back
    void operator()(double fraction);

private:
    struct display;
    struct bar;
    struct lines;
    std::unique_ptr<display> display_;
};

}
